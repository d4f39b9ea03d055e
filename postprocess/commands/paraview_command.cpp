// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "frame_loop.h"
#include "frame_options.h"
#include "messages.h"
#include "template_files.h"
#include "time_option.h"

#include <fmt/format.h>
#include <memory>

namespace ellipsoid::post {
namespace {

void append_body(SurfaceMesh& to, const SurfaceMesh& body, const Vector3& centre,
                 const Rotation3& turn) {
  const std::size_t first = to.points.size();
  for (const Vector3& p : body.points)
    to.points.push_back(centre + turn.to_space(p));
  for (const auto& t : body.triangles)
    to.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

/// Surfaces of all particles with the file's columns as values of their triangles.
SurfaceMesh surfaces_of(const Frame& frame, const ParticleSet& set) {
  constexpr MeshFineness smooth{16, 12}, sphere{12, 8};
  SurfaceMesh mesh;
  std::vector<std::size_t> rows; // of each triangle
  for (const Particle& p : set.particles) {
    if (p.is_smooth())
      append_body(mesh, ellipsoid_surface(p.semiaxes, smooth), p.centre, rotation(p.orientation));
    for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k) {
      const double r = set.spheres[k].radius;
      append_body(mesh, ellipsoid_surface({r, r, r}, sphere), set.spheres[k].centre, Rotation3{});
    }
    rows.resize(mesh.triangles.size(), p.row);
  }
  for (std::size_t k = 0; k < frame.names.size(); ++k) {
    if (!frame.is_readable(k)) {
      report_warning(frame.unreadable[k] + "; the column is left out", frame.unreadable[k]);
      continue;
    }
    CellValues values{frame.names[k], {}};
    for (const std::size_t row : rows)
      values.values.push_back(frame.columns[k][row]);
    mesh.cell_values.push_back(std::move(values));
  }
  return mesh;
}

struct ParaviewOptions {
  FrameOptions frames;
  std::string output;
  double time_step = 0.0; ///< of files without times; 0: the step's number stands for it
};

int write_series(const ParaviewOptions& options) {
  std::string entries;
  const int code = for_chosen_frames(options.frames, [&](const ChosenFrame& chosen) {
    const std::string name = fmt::format("{}_{}.vtp", options.output, chosen.frame.timestep);
    write_text(name, vtp_text(surfaces_of(chosen.frame, chosen.set)));
    const double time = time_of(chosen.frame, options.time_step)
                            .value_or(static_cast<double>(chosen.frame.timestep));
    entries += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time,
                           name.substr(name.find_last_of('/') + 1));
  });
  if (entries.empty())
    return code;
  write_text(options.output + ".pvd",
             "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
             "<Collection>\n" +
                 entries + "</Collection>\n</VTKFile>\n");
  fmt::print(stderr, "ParaView: {}.pvd\n", options.output);
  return code;
}

} // namespace

void add_paraview_command(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ParaviewOptions>();
  options->frames.frames = "all";
  CLI::App* command = program.add_subcommand(
      "paraview", "true surfaces of the particles as VTP files, with a .pvd time series");
  command->footer("All columns of the dump become cell values, for colours and filters.");
  add_frame_options(*command, options->frames, FrameUse::one_series);
  command->add_option("--output,-o", options->output, "beginning of the file names")->required();
  add_time_option(*command, options->time_step);
  command->callback([options, &exit_code] { exit_code = write_series(*options); });
}

} // namespace ellipsoid::post
