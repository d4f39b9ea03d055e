// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "host_bodies.h"

#include "body_axes.h"
#include "particle_columns.h"
#include "periodic_cell.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <set>

namespace ellipsoid::post {
namespace {

/// Place, size and orientation of a rigid body of the host from its spheres.
/// @param[in] have_ids so that their order is that of other frames
void enclose(Particle& body, const std::vector<Sphere>& spheres, bool have_ids) {
  const Sphere* begin = spheres.data() + body.first_sphere;
  const Sphere* end = begin + body.sphere_count;
  Vector3 centre;
  for (const Sphere* s = begin; s != end; ++s)
    centre += (1.0 / static_cast<double>(body.sphere_count)) * s->centre;
  const BodyAxes axes = axes_of_body(begin, end, centre);
  body.centre = centre;
  body.orientation = axes.orientation;
  body.semiaxes = axes.semiaxes;
  body.known_orientation = have_ids ? axes.known : KnownOrientation::none;
}

/// Whether a body's spheres come in pairs about its centre: that is then the mass centre.
bool is_symmetric(const Sphere* begin, const Sphere* end, const Vector3& centre) {
  constexpr double same = 1e-5; // of a radius: six digits in the file
  return std::all_of(begin, end, [&](const Sphere& s) {
    const Vector3 twin = 2.0 * centre - s.centre;
    return std::any_of(begin, end, [&](const Sphere& t) {
      return norm(t.centre - twin) <= same * s.radius &&
             std::abs(t.radius - s.radius) <= same * s.radius;
    });
  });
}

/// The host writes the body's spin and mass to each of its spheres: what differs is no body.
void require_one_motion(const Particle& body, const Particle& sphere, const Frame& frame) {
  if (sphere.mass != body.mass || norm(sphere.angular_velocity - body.angular_velocity) != 0.0)
    throw bad_value(frame, sphere.row,
                    "the mass and the angular velocity of the whole body in each of its rows",
                    "others than in the body's first row");
}

/// Joins the spheres of a body that the box has taken apart: one after the other takes the place of
/// its image that is nearest to a sphere that has its place.
void put_together(Sphere* begin, const Sphere* end, const PeriodicCell& cell) {
  const auto count = static_cast<std::size_t>(end - begin);
  std::vector<Vector3> ways(count); // places: of the image nearest to a sphere that has its place
  std::vector<double> distances(count, std::numeric_limits<double>::infinity());
  std::vector<bool> has_place(count, false);
  for (std::size_t last = 0, placed = 1; placed < count; ++placed) {
    has_place[last] = true;
    std::size_t next = count;
    for (std::size_t k = 0; k < count; ++k) {
      if (has_place[k])
        continue;
      const Vector3 way = cell.nearest(begin[k].centre - begin[last].centre);
      if (norm(way) < distances[k]) {
        distances[k] = norm(way);
        ways[k] = begin[last].centre + way;
      }
      if (next == count || distances[k] < distances[next])
        next = k;
    }
    begin[next].centre = ways[next];
    last = next;
  }
}

/// Makes bodies from the rows of their spheres.
class BodyMaker {
 public:
  BodyMaker(ParticleSet& set, const NamedColumns& columns, const ParticleOptions& options)
      : set_(set), frame_(columns.frame()), cell_(set.box), sizes_(columns, options),
        common_(columns), have_ids_(columns.find("id") != nullptr) {
    common_.describe(set);
    // the host keeps its bodies within the box by the image flags of their spheres
    set.tells_ways = false;
  }

  void add(const std::vector<std::size_t>& rows, std::int64_t body_number) {
    Particle body = common_.at(rows.front());
    body.first_sphere = set_.spheres.size();
    body.sphere_count = rows.size();
    body.is_host_body = true;
    Vector3 velocity;
    for (const std::size_t row : rows) {
      const Particle sphere = common_.at(row);
      set_.spheres.push_back({sphere.centre, radius_at(row)});
      set_.sphere_ids.push_back(sphere.id);
      velocity += (1.0 / static_cast<double>(rows.size())) * sphere.velocity;
      require_one_motion(body, sphere, frame_);
    }
    Sphere* const first = set_.spheres.data() + body.first_sphere;
    if (cell_.is_periodic() && !common_.is_unwrapped())
      put_together(first, first + rows.size(), cell_);
    enclose(body, set_.spheres, have_ids_);
    body.velocity = velocity; // of the middle of the centres: motion of a rigid body is linear
    if (!is_symmetric(first, first + rows.size(), body.centre))
      ++set_.asymmetric_bodies;
    set_id(body, body_number);
    set_.particles.push_back(body);
  }

 private:
  double radius_at(std::size_t row) const {
    const Vector3 s = sizes_.at(row);
    if (s.x != s.y || s.x != s.z)
      throw bad_value(frame_, row, "a sphere of a rigid body (--bodies none: no bodies)",
                      fmt::format("semi-axes {} {} {}", s.x, s.y, s.z));
    return s.x;
  }

  void set_id(Particle& body, std::int64_t body_number) {
    if (body_number > 0)
      body.id = body_number;
    if (!ids_.insert(body.id).second)
      throw bad_value(frame_, body.row, "numbers of bodies that are no ids of single spheres",
                      fmt::format("{} for both: dump bodies and single spheres apart, or say "
                                  "--bodies none",
                                  body.id));
  }

  ParticleSet& set_;
  const Frame& frame_;
  PeriodicCell cell_;
  SizeColumns sizes_;
  CommonColumns common_;
  bool have_ids_;
  std::set<std::int64_t> ids_;
};

} // namespace

void add_host_bodies(ParticleSet& set, const std::vector<double>& body_of_row,
                     const NamedColumns& columns, const ParticleOptions& options) {
  if (options.subspheres || options.spacing)
    throw InputError("--subspheres and --spacing are for files of ellipsoids; this one has bodies "
                     "of spheres: leave them out, or say --bodies none");
  BodyMaker maker(set, columns, options);
  std::map<std::int64_t, std::vector<std::size_t>> rows_of_body;
  std::int64_t single = std::numeric_limits<std::int64_t>::min(); // rows of no body
  for (const std::size_t row : rows_by_id(columns)) {
    const std::int64_t body = whole_number(columns.frame(), row, "body", body_of_row[row]);
    rows_of_body[body > 0 ? body : single++].push_back(row);
  }
  for (const auto& [body, rows] : rows_of_body)
    maker.add(rows, body);
}

Column bodies_column(const NamedColumns& columns, const ParticleOptions& options) {
  const auto joins = [](Column body) {
    return body && std::any_of(body->begin(), body->end(), [](double b) { return b > 0.0; });
  };
  if (options.bodies == "none")
    return nullptr;
  if (!options.bodies.empty())
    return &columns.frame().required(options.bodies, "--bodies");
  const bool has_shapes = columns.has("shapex") || columns.has("c_shape[1]");
  if (const Column host = columns.find("id_multisphere"); joins(host)) {
    if (has_shapes)
      throw InputError("the file has shapes and a column \"id_multisphere\" with bodies: --bodies "
                       "id_multisphere takes its rows as spheres of bodies, --bodies none as "
                       "particles of their own");
    return host;
  }
  if (!has_shapes && joins(columns.find("mol")))
    throw InputError("the column \"mol\" may join spheres to rigid bodies or be a mere label: say "
                     "--bodies mol or --bodies none");
  return nullptr;
}

} // namespace ellipsoid::post
