// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// A run as one web page that can be turned, played and read (folder view/): first a survey of all
// frames (which bodies there are, ranges of all values), then the frames themselves.
#pragma once

#include "contacts.h"
#include "frame.h"
#include "particles.h"
#include "view_columns.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ellipsoid::post {

class PackedColumns;

struct ViewWall {
  Vector3 point, normal; ///< normal: unit
};

struct ViewMesh {
  std::string name;
  std::vector<float> corners; ///< 9 numbers a triangle (length)
};

struct ViewCylinder {
  Vector3 point, axis; ///< axis: unit
  double radius = 0.0; ///< (length)
};

using ByteColour = std::array<int, 3>;

struct ViewSettings {
  std::string title, colour_by;
  unsigned up = 2; ///< axis
  std::vector<ViewWall> walls;
  std::vector<ViewCylinder> cylinders;
  std::vector<ViewMesh> meshes;
  bool has_contacts = false, has_forces = false;
  std::vector<ByteColour> even_colours, cyclic_colours, kind_colours;
};

/// A contact of a view.
struct ViewContact {
  std::size_t i = 0, j = 0;          ///< particles of the set
  double force = 0.0, overlap = 0.0; ///< (force), (length)
};

/// What has to be known of all frames before the first one is written.
class ViewSurvey {
 public:
  explicit ViewSurvey(unsigned up) : up_(up) {}
  /// Throws InputError when the file does not tell how the bodies of spheres are turned.
  void add(const Frame& frame, const ParticleSet& set);

  std::size_t frames() const { return frames_; }
  bool is_planar() const { return is_planar_; }
  std::vector<std::string> column_names() const;

 private:
  friend class ViewPage;
  /// id, semi-axes, template: what a body keeps.
  using Body = std::array<double, 5>;

  void add_columns(const Frame& frame, const ParticleSet& set);
  Box bulk() const;
  std::uint32_t template_of(const ParticleSet& set, const Particle& p);

  unsigned up_;
  std::size_t frames_ = 0;
  bool is_planar_ = true;
  double plane_ = 0.0, smallest_axis_ = 0.0, largest_axis_ = 0.0;
  std::vector<ColumnRange> coordinates_ =
      std::vector<ColumnRange>(3, ColumnRange({"coordinate", "", false, {}}));
  Box bounds_; ///< of all bodies in all frames
  std::map<Body, std::uint32_t> bodies_;
  std::map<std::vector<long>, std::uint32_t> templates_; ///< rounded spheres -> number from 1 on
  std::vector<std::vector<float>> spheres_;              ///< x y z R in units of the largest axis
  std::vector<ColumnRange> columns_;                     ///< those that all frames have
};

/// The page, frame by frame.
class ViewPage {
 public:
  ViewPage(ViewSurvey survey, ViewSettings settings);
  /// The same frames as in the survey, in the same order. Throws InputError if they are others.
  /// @param[in] time where it is known
  void add(const Frame& frame, const ParticleSet& set, const std::vector<ViewContact>& contacts,
           const std::optional<double>& time);
  std::string html() const;

  /// Bytes before compression.
  std::size_t bytes_per_particle() const;
  /// Largest error of a coordinate (length).
  double position_error() const { return 0.5 * step_; }

 private:
  void pack_bodies(PackedColumns& packed, const Frame& frame, const ParticleSet& set);
  void pack_columns(PackedColumns& packed, const Frame& frame, const ParticleSet& set) const;
  void pack_contacts(PackedColumns& packed, const std::vector<ViewContact>& contacts);
  PackedColumns packed_survey() const;
  std::string columns_json() const;
  std::string header_json() const;

  ViewSurvey survey_;
  ViewSettings settings_;
  double step_;  ///< of coordinates (length)
  bool is_fine_; ///< 4 bytes a coordinate instead of 2
  double largest_force_ = 0.0;
  std::string frames_json_, data_;
  std::size_t frames_ = 0;
};

} // namespace ellipsoid::post
