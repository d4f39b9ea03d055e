// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "pile_picture.h"

#include "legends.h"
#include "particle_colours.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

constexpr double degrees = 180.0 / 3.141592653589793238462643;
constexpr Colour ink{0.13, 0.15, 0.18}, red{0.80, 0.10, 0.10}, chain_blue{0.00, 0.32, 0.60},
    grey{0.45, 0.47, 0.50}, pale{0.93, 0.94, 0.95};

/// Margins around the drawn plane (pixels at a width of 1600; they scale with the width).
constexpr double side_margin = 60.0, top_margin = 70.0, bottom_margin = 110.0, wall_width = 16.0;

/// Plane coordinates to pixels.
struct Projection {
  PileView view;
  double scale = 1.0, left = 0.0, top = 0.0, unit = 1.0; ///< unit: pixels for 1 at width 1600

  PixelPoint at(const Point& p) const {
    return {left + (p.x() - view.left) * scale, top + (view.top - p.y()) * scale};
  }
};

/// An outline as centre, semi-axes and turn: principal axes of the conjugate half-diameters.
void draw_outline(Canvas& canvas, const Projection& to, const PlaneEllipse& e, const Style& style) {
  const double sxx = e.ux * e.ux, sxy = e.ux * e.uy, syy = e.uy * e.uy + e.vy * e.vy;
  const double mean = 0.5 * (sxx + syy), half = std::hypot(0.5 * (sxx - syy), sxy);
  const double turn = 0.5 * std::atan2(2.0 * sxy, sxx - syy);
  canvas.ellipse(to.at(e.centre), to.scale * std::sqrt(mean + half),
                 to.scale * std::sqrt(std::max(0.0, mean - half)), -turn * degrees, style);
}

/// Outline and filling of one particle. Multi-sphere particles: the lines of all discs first,
/// then their fillings, so that only the outline of the union stays.
void draw_particle(Canvas& canvas, const Projection& to, const std::vector<PlaneEllipse>& parts,
                   const Colour& colour, double line_width, bool show_discs) {
  Style line, filling;
  line.line = ink;
  line.line_width = 2.0 * line_width;
  filling.is_filled = true;
  filling.fill = colour;
  filling.line_width = 0.0;
  for (const PlaneEllipse& part : parts)
    draw_outline(canvas, to, part, line);
  for (const PlaneEllipse& part : parts)
    draw_outline(canvas, to, part, filling);
  if (show_discs) {
    line.line = grey;
    line.line_width = 0.5 * line_width;
    for (const PlaneEllipse& part : parts)
      draw_outline(canvas, to, part, line);
  }
}

void draw_particles(Canvas& canvas, const Projection& to, const ParticleSet& set, const Pile& pile,
                    const PileOptions& pile_options, const ParticleColours& colours,
                    const PilePictureOptions& options) {
  const double line_width = std::clamp(0.05 * pile.mean_b * to.scale, 0.3, 2.0 * to.unit);
  for (std::size_t i = 0; i < set.particles.size(); ++i)
    draw_particle(canvas, to, outlines(set, {i}, pile.section, pile_options.outline),
                  colours.colours[i], line_width, options.show_discs);
}

void draw_walls(Canvas& canvas, const Projection& to, const PileOptions& options) {
  Style solid;
  solid.is_filled = true;
  solid.fill = grey;
  solid.line_width = 0.0;
  const double width = wall_width * to.unit;
  const PixelPoint low_left = to.at({to.view.left, options.floor});
  const PixelPoint top_right = to.at({to.view.right, to.view.top});
  const double begin = options.wall ? low_left.x - width : low_left.x;
  if (to.view.bottom <= options.floor)
    canvas.rectangle({begin, low_left.y}, top_right.x - begin, width, solid);
  if (options.wall && to.view.left <= *options.wall)
    canvas.rectangle({low_left.x - width, top_right.y}, width, low_left.y - top_right.y, solid);
}

bool shows(const PileView& view, const Point& p) {
  return p.x() >= view.left && p.x() <= view.right && p.y() >= view.bottom && p.y() <= view.top;
}

void draw_fit(Canvas& canvas, const Projection& to, const PileOptions& options,
              const ReposeAngle& angle) {
  Style dashed, thick, dot;
  dashed.line = thick.line = red;
  dashed.line_width = 2.0 * to.unit;
  dashed.dashes = {8.0 * to.unit, 6.0 * to.unit};
  thick.line_width = 3.5 * to.unit;
  dot.is_filled = true;
  dot.fill = red;
  dot.line_width = 0.0;
  const double slope = angle.line.slope;
  const Point foot((options.floor - angle.line.intercept) / slope, options.floor);
  const double top = options.wall.value_or(angle.a.x());
  canvas.begin_clip(to.at({to.view.left, to.view.top}), to.scale * (to.view.right - to.view.left),
                    to.scale * (to.view.top - to.view.bottom));
  canvas.line(to.at(foot), to.at({top, angle.line.intercept + slope * top}), dashed);
  canvas.line(to.at(angle.a), to.at(angle.b), thick);
  canvas.end_clip();
  TextStyle text;
  text.size = 26.0 * to.unit;
  text.colour = red;
  text.is_bold = true;
  const double outwards = angle.b.x() > angle.a.x() ? 1.0 : -1.0; // where the words stand
  text.anchor = outwards > 0.0 ? Anchor::start : Anchor::end;
  for (const auto& [point, name] : {std::pair(angle.a, "A"), std::pair(angle.b, "B")}) {
    const PixelPoint p = to.at(point);
    canvas.ellipse(p, 6.0 * to.unit, 6.0 * to.unit, 0.0, dot);
    canvas.text({p.x + outwards * 10.0 * to.unit, p.y - 14.0 * to.unit}, name, text);
  }
  const PixelPoint middle = to.at(0.5 * (angle.a + angle.b));
  canvas.text({middle.x + outwards * 40.0 * to.unit, middle.y - 50.0 * to.unit},
              fmt::format("{:.1f}° ± {:.1f}°", angle.angle_deg, angle.standard_error_deg), text);
}

void draw_surface(Canvas& canvas, const Projection& to, const Pile& pile) {
  std::vector<PixelPoint> points;
  const double step = 0.5 / to.scale;
  for (double x = pile.left; x < pile.right; x += step)
    points.push_back(to.at({x, pile.surface.height(x)}));
  Style line;
  line.line = {0.0, 0.35, 0.75};
  line.line_width = 2.0 * to.unit;
  canvas.polyline(points, false, line);
}

double largest_force(const std::vector<ForceLink>& links) {
  double largest = 0.0;
  for (const ForceLink& link : links)
    largest = std::max(largest, link.force);
  return largest;
}

/// Width of the line of the largest force (pixels).
double widest_link(const Projection& to, const Pile& pile) {
  return std::max(3.0 * to.unit, 0.7 * pile.mean_b * to.scale);
}

/// Lines between the centres of touching particles, as wide as the force is large; weak ones first.
void draw_force_chains(Canvas& canvas, const Projection& to, const Pile& pile,
                       std::vector<ForceLink> links) {
  constexpr double narrowest = 0.3; // pixels that still can be seen
  std::sort(links.begin(), links.end(),
            [](const ForceLink& p, const ForceLink& q) { return p.force < q.force; });
  Style line;
  line.line = chain_blue;
  for (const ForceLink& link : links) {
    line.line_width = std::max(narrowest, widest_link(to, pile) * link.force / links.back().force);
    canvas.line(to.at({link.begin.x, link.begin.y}), to.at({link.end.x, link.end.y}), line);
  }
}

/// The line of the largest force and its value (forces of the file taken as newton).
void draw_force_scale(Canvas& canvas, const Projection& to, const Pile& pile,
                      const std::vector<ForceLink>& links, double x, double y) {
  Style line;
  line.line = chain_blue;
  line.line_width = widest_link(to, pile);
  canvas.line({x, y}, {x + 80.0 * to.unit, y}, line);
  TextStyle text;
  text.size = 24.0 * to.unit;
  canvas.text({x + 92.0 * to.unit, y + 8.0 * to.unit},
              fmt::format("{:.3g} N, the largest force", largest_force(links)), text);
}

Projection projection(const PileView& view, int width, double letters) {
  Projection to;
  to.view = view;
  to.unit = letters * width / 1600.0;
  to.left = side_margin * to.unit;
  to.top = top_margin * to.unit;
  to.scale = (width - 2.0 * to.left) / (view.right - view.left);
  return to;
}

} // namespace

PileView whole_pile(const ParticleSet& set, const Pile& pile, const PileOptions& options) {
  const double room = 2.0 * pile.mean_a;
  PileView view{pile.left, pile.right + room, options.floor, pile.surface.summit().y() + room};
  if (!options.wall)
    view.left -= room;
  // strays are shown as long as they do not shrink the pile much
  const double farthest = pile.left + 1.25 * (pile.right - pile.left);
  for (const Particle& p : set.particles)
    if (p.centre.x + room > view.right && p.centre.x + room < farthest)
      view.right = p.centre.x + room;
  // and whole or not at all
  for (bool is_cut = true; is_cut;) {
    is_cut = false;
    for (const Particle& p : set.particles) {
      const double begin = p.centre.x - p.largest_axis();
      if (begin > pile.right && begin < view.right && p.centre.x + p.largest_axis() > view.right) {
        view.right = begin;
        is_cut = true;
      }
    }
  }
  return view;
}

namespace {

/// An even number: programs that make films want it. Throws InputError where it is too large.
int height_of(const Projection& to, double plane_height) {
  constexpr double most_pixels = 30000.0;
  const double height = 2.0 * std::ceil(0.5 * (to.top + plane_height + bottom_margin * to.unit));
  if (height > most_pixels)
    throw InputError(fmt::format("the picture would be {} pixels high (at most {}): choose a "
                                 "smaller --width or a --view",
                                 height, most_pixels));
  return static_cast<int>(height);
}

} // namespace

std::string draw_pile(PictureFormat format, const Frame& frame, const ParticleSet& set,
                      const Pile& pile, const PileOptions& pile_options,
                      const std::vector<ReposeAngle>& flanks, const PilePictureOptions& options) {
  const PileView view = options.view.value_or(whole_pile(set, pile, pile_options));
  if (!(view.right > view.left && view.top > view.bottom))
    throw InputError("the shown part of the plane is empty: --view needs x0 < x1 and y0 < y1");
  const Projection to = projection(view, options.width, options.letters);
  const double plane_height = (view.top - view.bottom) * to.scale;
  const auto canvas = make_canvas(format, options.width, height_of(to, plane_height));
  ParticleColours colours =
      particle_colours(frame, set, options.colour_by, options.colour_low, options.colour_high);
  if (!options.force_chains.empty() && options.colour_by.empty())
    colours.colours.assign(set.particles.size(), pale);
  canvas->begin_clip({to.left, to.top}, options.width - 2.0 * to.left, plane_height);
  draw_particles(*canvas, to, set, pile, pile_options, colours, options);
  if (options.show_surface)
    draw_surface(*canvas, to, pile);
  draw_force_chains(*canvas, to, pile, options.force_chains);
  canvas->end_clip();
  draw_walls(*canvas, to, pile_options);
  for (const ReposeAngle& flank : flanks)
    if (options.show_fit && shows(view, flank.a) && shows(view, flank.b))
      draw_fit(*canvas, to, pile_options, flank);
  const double below = to.top + plane_height + 58.0 * to.unit;
  draw_scale_bar(*canvas, {to.left, below}, to.scale, view.right - view.left, to.unit);
  if (!options.force_chains.empty())
    draw_force_scale(*canvas, to, pile, options.force_chains, to.left + 0.4 * options.width, below);
  if (colours.has_scale)
    draw_colour_bar(*canvas, {options.width - to.left, below - 14.0 * to.unit}, colours, to.unit);
  TextStyle heading;
  heading.size = 26.0 * to.unit;
  canvas->text({to.left, 44.0 * to.unit}, options.title, heading);
  return canvas->finish();
}

} // namespace ellipsoid::post
