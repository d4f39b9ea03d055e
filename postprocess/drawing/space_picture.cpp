// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "space_picture.h"

#include "depth_buffer.h"
#include "height_map.h"
#include "legends.h"
#include "quaternion_of_matrix.h"
#include "space_axes.h"
#include "space_camera.h"
#include "space_scenery.h"

#include <algorithm>
#include <cmath>

namespace ellipsoid::post {
namespace {

/// The set in the camera's frame.
ParticleSet in_camera_frame(const ParticleSet& set, const SpaceView& view) {
  const Camera camera(view);
  const auto seen = [&](const Vector3& v) { return camera.seen(v); };
  const Quaternion turn =
      quaternion_of({seen({1.0, 0.0, 0.0}), seen({0.0, 1.0, 0.0}), seen({0.0, 0.0, 1.0})});
  ParticleSet result = set;
  for (Particle& p : result.particles) {
    p.centre = seen(p.centre);
    p.orientation = turn * p.orientation;
  }
  for (Sphere& s : result.spheres)
    s.centre = seen(s.centre);
  return result;
}

/// A rectangle in the camera's plane.
struct SeenRange {
  double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
  void add(const Vector3& centre, double reach) {
    x0 = std::min(x0, centre.x - reach);
    x1 = std::max(x1, centre.x + reach);
    y0 = std::min(y0, centre.y - reach);
    y1 = std::max(y1, centre.y + reach);
  }
};

/// What is to be seen: all particles, or the corners of a box.
SeenRange seen_range(const ParticleSet& seen, const SpaceView& view) {
  SeenRange range;
  if (!view.part) {
    for (const Particle& p : seen.particles)
      range.add(p.centre, p.largest_axis());
    return range;
  }
  const Camera camera(view);
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto bound = [&](unsigned k) {
      return (corner >> k & 1u) != 0 ? view.part->upper[k] : view.part->lower[k];
    };
    range.add(camera.seen({bound(0), bound(1), bound(2)}), 0.0);
  }
  return range;
}

Screen screen_for(const SeenRange& range, const DepthBuffer& buffer, double zoom) {
  const auto& [x0, x1, y0, y1] = range;
  constexpr double filled = 0.94; // of the picture
  const double width = static_cast<double>(buffer.width),
               height = static_cast<double>(buffer.height);
  Screen screen;
  screen.scale = zoom * filled * std::min(width / (x1 - x0), height / (y1 - y0));
  screen.left = 0.5 * (x0 + x1) - 0.5 * width / screen.scale;
  screen.top = 0.5 * (y0 + y1) + 0.5 * height / screen.scale;
  return screen;
}

/// Brightness of a surface with unit normal n in the camera's frame: a lamp over the left
/// shoulder, a weak one at the camera, some light from everywhere.
double brightness(const Vector3& n) {
  const Vector3 lamp = normalized(Vector3{-0.5, 0.7, 0.8});
  return 0.30 + 0.50 * std::max(0.0, dot(n, lamp)) + 0.22 * std::max(0.0, n.z);
}

/// Draws one body: `top(x, y, z)` gives its nearest point, `normal(point)` its outward normal.
template <class Top, class Normal>
void draw_body(DepthBuffer& buffer, const Screen& screen, const Vector3& centre, double reach,
               std::size_t owner, const Top& top, const Normal& normal) {
  const auto clamped = [](double k, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(count)));
  };
  const std::size_t i0 = clamped((centre.x - reach - screen.left) * screen.scale, buffer.width);
  const std::size_t i1 = clamped((centre.x + reach - screen.left) * screen.scale + 1, buffer.width);
  const std::size_t j0 = clamped((screen.top - centre.y - reach) * screen.scale, buffer.height);
  const std::size_t j1 = clamped((screen.top - centre.y + reach) * screen.scale + 1, buffer.height);
  double z = 0.0;
  for (std::size_t j = j0; j < j1; ++j)
    for (std::size_t i = i0; i < i1; ++i) {
      const std::size_t ray = j * buffer.width + i;
      if (!top(screen.x(i), screen.y(j), z) || z <= buffer.depth[ray])
        continue;
      buffer.depth[ray] = z;
      buffer.owner[ray] = static_cast<std::int32_t>(owner);
      buffer.light[ray] =
          static_cast<float>(brightness(normal(Vector3{screen.x(i), screen.y(j), z})));
    }
}

void draw_particle(DepthBuffer& buffer, const Screen& screen, const ParticleSet& set,
                   std::size_t index) {
  const Particle& p = set.particles[index];
  if (p.is_smooth()) {
    const Vector3& s = p.semiaxes;
    const SymmetricMatrix3 m = rotated_diagonal(rotation(p.orientation), 1.0 / (s.x * s.x),
                                                1.0 / (s.y * s.y), 1.0 / (s.z * s.z));
    draw_body(
        buffer, screen, p.centre, p.largest_axis(), index,
        [&](double x, double y, double& z) { return top_of_ellipsoid(p, x, y, z); },
        [&](const Vector3& point) { return normalized(m * (point - p.centre)); });
  }
  for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k) {
    const Sphere& s = set.spheres[k];
    draw_body(
        buffer, screen, s.centre, s.radius, index,
        [&](double x, double y, double& z) { return top_of_sphere(s, x, y, z); },
        [&](const Vector3& point) { return (1.0 / s.radius) * (point - s.centre); });
  }
}

/// Colour of the body behind a ray; where the neighbour to the right or below shows another
/// particle there is a dark line.
Colour body_colour(const DepthBuffer& buffer, const std::vector<Colour>& colours, std::size_t i,
                   std::size_t j) {
  const std::size_t ray = j * buffer.width + i;
  const std::int32_t owner = buffer.owner[ray];
  const bool is_edge = (i + 1 < buffer.width && buffer.owner[ray + 1] != owner) ||
                       (j + 1 < buffer.height && buffer.owner[ray + buffer.width] != owner);
  if (is_edge)
    return {0.12, 0.13, 0.15};
  if (owner < 0)
    return {1.0, 1.0, 1.0};
  const Colour& c = colours[static_cast<std::size_t>(owner)];
  const double light = buffer.light[ray];
  return {c.red * light, c.green * light, c.blue * light};
}

/// Colour that a ray shows: a line's, or the body's behind the walls in front of it.
Colour ray_colour(const DepthBuffer& buffer, const std::vector<Colour>& colours, std::size_t i,
                  std::size_t j) {
  const std::size_t ray = j * buffer.width + i;
  if (const Colour* line = colour_of(buffer.lines[ray]))
    return *line;
  const Colour body = body_colour(buffer, colours, i, j);
  const double share = std::pow(1.0 - wall_opacity, buffer.walls[ray]);
  const auto mixed = [share](double wall, double behind) { return wall + share * (behind - wall); };
  return {mixed(wall_colour.red, body.red), mixed(wall_colour.green, body.green),
          mixed(wall_colour.blue, body.blue)};
}

} // namespace

SpacePixels draw_space(const ParticleSet& upright, const std::vector<Colour>& colours,
                       const SpaceView& view, const SpaceScenery* scenery) {
  if (upright.particles.empty())
    throw InputError("there are no particles to show");
  PixelImage image;
  image.width = static_cast<std::size_t>(view.width);
  image.height = static_cast<std::size_t>(view.height);
  DepthBuffer buffer(rays_per_side * image.width, rays_per_side * image.height);
  const ParticleSet seen = in_camera_frame(upright, view);
  const Screen screen = screen_for(seen_range(seen, view), buffer, view.zoom);
  for (std::size_t k = 0; k < seen.particles.size(); ++k)
    draw_particle(buffer, screen, seen, k);
  if (scenery)
    draw_scenery(buffer, screen, *scenery, Camera(view));
  image.samples.reserve(3 * image.width * image.height);
  constexpr double share = 1.0 / (rays_per_side * rays_per_side);
  for (std::size_t row = 0; row < image.height; ++row)
    for (std::size_t column = 0; column < image.width; ++column) {
      Colour sum;
      for (std::size_t ray = 0; ray < rays_per_side * rays_per_side; ++ray) {
        const Colour c = ray_colour(buffer, colours, rays_per_side * column + ray % rays_per_side,
                                    rays_per_side * row + ray / rays_per_side);
        sum = {sum.red + share * c.red, sum.green + share * c.green, sum.blue + share * c.blue};
      }
      for (const double sample : {sum.red, sum.green, sum.blue})
        image.samples.push_back(
            static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(sample, 0.0, 1.0))));
    }
  const double scale = screen.scale / rays_per_side;
  return {std::move(image), scale, {-screen.left * scale, screen.top * scale}};
}

namespace {

/// What is shown of space: a part that was asked for, or what the particles take.
Box shown_part(const ParticleSet& upright, const SpaceView& view) {
  if (view.part)
    return *view.part;
  Box box;
  bool is_first = true;
  for (const Particle& p : upright.particles) {
    const double centre[3] = {p.centre.x, p.centre.y, p.centre.z}, reach = p.largest_axis();
    for (std::size_t k = 0; k < 3; ++k) {
      box.lower[k] = is_first ? centre[k] - reach : std::min(box.lower[k], centre[k] - reach);
      box.upper[k] = is_first ? centre[k] + reach : std::max(box.upper[k], centre[k] + reach);
    }
    is_first = false;
  }
  return box;
}

} // namespace

std::string space_picture(PictureFormat format, const ParticleSet& upright,
                          const ParticleColours& colours, const SpaceView& view,
                          const std::string& title) {
  const double unit = view.letters * view.width / 1600.0, side = 60.0 * unit;
  const double heading = std::ceil(64.0 * unit), footing = std::ceil(84.0 * unit); // pixels
  SpaceView inner = view;
  inner.height = view.height - static_cast<int>(heading + footing);
  if (inner.height < 1)
    throw InputError("the picture is too low for its heading and scale: choose a larger --height, "
                     "or --bare");
  const auto canvas = make_canvas(format, view.width, view.height);
  const SpaceScenery scenery = scenery_of(inner, upright.box, shown_part(upright, inner), unit);
  const SpacePixels pixels = draw_space(upright, colours.colours, inner, &scenery);
  canvas->image({0.0, heading}, pixels.image);
  canvas->begin_clip({0.0, heading}, view.width, inner.height);
  if (view.show_axes)
    draw_axes(*canvas, inner, {side + 60.0 * unit, heading + inner.height - 90.0 * unit}, unit);
  canvas->end_clip();
  TextStyle text;
  text.size = 26.0 * unit;
  canvas->text({side, 44.0 * unit}, title, text);
  const double below = heading + inner.height + 24.0 * unit;
  draw_scale_bar(*canvas, {side, below + 14.0 * unit}, pixels.pixels_per_length,
                 (view.width - 2.0 * side) / pixels.pixels_per_length, unit);
  if (colours.has_scale)
    draw_colour_bar(*canvas, {view.width - side, below}, colours, unit);
  return canvas->finish();
}

} // namespace ellipsoid::post
