// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "law/law_batch.h"

#include "vectorised/vector_versions.h"

namespace ellipsoid {

namespace {

using C = LawColumns;

struct Frames {
  const ContactBatch::Columns& from;
  LawColumns& to;
};

/// Normals of the law point from j to i.
inline void copy_loop(Frames& frames, int size) {
  using From = ContactBatch::Columns;
  const auto& out = frames.from.out;
  const auto& in = frames.from.in;
  auto& to = frames.to.in;
#pragma GCC ivdep
  for (int k = 0; k < size; ++k) {
    for (int l = 0; l < 3; ++l) {
      to[C::nx + l][k] = -out[From::nx + l][k];
      to[C::lix + l][k] = out[From::px + l][k];
      to[C::ljx + l][k] = out[From::px + l][k] - in[From::dx + l][k];
    }
    const double overlap = out[From::overlap][k];
    to[C::overlap][k] = overlap > 0.0 ? overlap : 0.0;
    to[C::radius][k] = out[From::reduced_radius][k];
    to[C::radius_i][k] = out[From::radius_i][k];
    to[C::radius_j][k] = out[From::radius_j][k];
  }
}

/// Whether the bodies are bodies in the plane that move in it.
inline void plane_loop(LawColumns& c, int size) {
  c.are_in_plane = all_zero(
      c.in, {C::nz, C::liz, C::ljz, C::vz, C::wix, C::wiy, C::wjx, C::wjy, C::sz, C::rx, C::ry},
      size);
}

} // namespace

void ContactLawBatch::set_frames(const ContactBatch& pairs) {
  resize(pairs.size());
  Frames frames{pairs.columns(), columns_};
  WidestVersion<copy_loop>::run(frames, size());
}

void ContactLawBatch::set_parameters_of_all(const LawParameters& parameters) {
  for (int k = 0; k < capacity; ++k)
    set_parameters(k, parameters);
}

void ContactLawBatch::solve(const ContactLaws& laws, const LawSettings& settings) {
  columns_.settings = settings;
  WidestVersion<plane_loop>::run(columns_, size());
  for (const BatchedLaw* law : laws.of_kind)
    if (law)
      law->loop(columns_, size());
}

} // namespace ellipsoid
