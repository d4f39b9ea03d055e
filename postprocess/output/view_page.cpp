// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "view_page.h"

#include "html.h"
#include "periodic_cell.h"
#include "view_data.h"
#include "view_files.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace ellipsoid::post {
namespace {

using nlohmann::json;

constexpr double scale_steps = 1e5; ///< templates are compared to 1 / scale_steps of their size

double component(const Vector3& v, unsigned axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

json numbers(const Vector3& v) { return {v.x, v.y, v.z}; }

std::string data_element(const std::string& id, const PackedColumns& columns) {
  return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id, columns.text());
}

/// Spheres of a body in its own frame, x y z R in units of its largest semi-axis.
std::vector<float> spheres_in_body(const ParticleSet& set, const Particle& p) {
  const Rotation3 turn = rotation(p.orientation);
  const double scale = 1.0 / p.largest_axis();
  std::vector<float> spheres;
  for (std::size_t k = p.first_sphere; k < p.first_sphere + p.sphere_count; ++k) {
    const Vector3 centre = scale * turn.to_body(set.spheres[k].centre - p.centre);
    for (const double value : {centre.x, centre.y, centre.z, scale * set.spheres[k].radius})
      spheres.push_back(static_cast<float>(value));
  }
  return spheres;
}

/// The box as its lower corner, three edges, and which of them repeat; nothing without a box.
json box_json(const Box& box) {
  const PeriodicCell cell(box);
  json edges = json::array(), repeats = json::array();
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(norm(cell.edge(k)) > 0.0))
      return nullptr;
    edges.push_back(numbers(cell.edge(k)));
    repeats.push_back(cell.is_periodic(k));
  }
  return {{"origin", numbers(cell.corner())}, {"edges", edges}, {"repeats", repeats}};
}

std::string time_text(const Frame& frame, const std::optional<double>& time) {
  if (time)
    return fmt::format("t = {:.6g}{}", *time,
                       frame.units.empty() || frame.units == "si" ? " s" : "");
  return fmt::format("time step {}", frame.timestep);
}

json templates_json(const std::vector<std::vector<float>>& spheres_of_templates) {
  json templates = json::array();
  std::size_t first = 0;
  for (const auto& spheres : spheres_of_templates) {
    templates.push_back({{"first", first}, {"spheres", spheres}});
    first += spheres.size() / 4;
  }
  return templates;
}

json walls_json(const ViewSettings& settings) {
  json walls = json::array();
  for (const ViewWall& wall : settings.walls)
    walls.push_back({{"point", numbers(wall.point)}, {"normal", numbers(wall.normal)}});
  return walls;
}

json cylinders_json(const ViewSettings& settings) {
  json cylinders = json::array();
  for (const ViewCylinder& cylinder : settings.cylinders)
    cylinders.push_back({{"point", numbers(cylinder.point)},
                         {"axis", numbers(cylinder.axis)},
                         {"radius", cylinder.radius}});
  return cylinders;
}

json meshes_json(const ViewSettings& settings) {
  json meshes = json::array();
  for (const ViewMesh& mesh : settings.meshes)
    meshes.push_back({{"name", mesh.name}});
  return meshes;
}

/// Text inside a script element: nothing in it may end the element.
std::string script_safe(std::string text) {
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3))
    text.replace(at, 2, "<\\/");
  return text;
}

} // namespace

void ViewSurvey::add(const Frame& frame, const ParticleSet& set) {
  constexpr std::size_t most_templates = 10000;
  for (const Particle& p : set.particles) {
    if (bodies_.empty()) {
      plane_ = p.centre.z;
      smallest_axis_ = p.smallest_axis();
      for (unsigned k = 0; k < 3; ++k)
        bounds_.lower[k] = bounds_.upper[k] = component(p.centre, k);
    }
    const double reach = p.largest_axis();
    for (unsigned k = 0; k < 3; ++k) {
      bounds_.lower[k] = std::min(bounds_.lower[k], component(p.centre, k) - reach);
      bounds_.upper[k] = std::max(bounds_.upper[k], component(p.centre, k) + reach);
      coordinates_[k].add({component(p.centre, k)});
    }
    largest_axis_ = std::max(largest_axis_, reach);
    is_planar_ = is_planar_ && std::abs(p.centre.z - plane_) <= 1e-6 * reach;
    smallest_axis_ = std::min(smallest_axis_, p.smallest_axis());
    const double number = template_of(set, p);
    bodies_.emplace(
        Body{static_cast<double>(p.id), p.semiaxes.x, p.semiaxes.y, p.semiaxes.z, number},
        static_cast<std::uint32_t>(bodies_.size()));
    if (templates_.size() > most_templates)
      throw InputError(fmt::format("{}: more than {} kinds of bodies of spheres; the file does not "
                                   "tell how its bodies are turned (columns quat1..quat4)",
                                   frame.location.file, most_templates));
  }
  add_columns(frame, set);
  ++frames_;
}

std::vector<std::string> ViewSurvey::column_names() const {
  std::vector<std::string> names;
  for (const ColumnRange& range : columns_)
    names.push_back(range.name());
  return names;
}

/// The bounds of almost all bodies where strays would make the picture small; else of all.
Box ViewSurvey::bulk() const {
  Box bulk = bounds_;
  for (unsigned k = 0; k < 3; ++k) {
    const auto [low, high] = coordinates_[k].shown();
    if (low > coordinates_[k].low() || high < coordinates_[k].high()) {
      bulk.lower[k] = low - largest_axis_;
      bulk.upper[k] = high + largest_axis_;
    }
  }
  return bulk;
}

/// 0 for smooth ellipsoids.
std::uint32_t ViewSurvey::template_of(const ParticleSet& set, const Particle& p) {
  if (p.is_smooth())
    return 0;
  std::vector<float> spheres = spheres_in_body(set, p);
  std::vector<long> key;
  for (const float value : spheres)
    key.push_back(std::lround(scale_steps * static_cast<double>(value)));
  const auto [entry, is_new] =
      templates_.emplace(std::move(key), static_cast<std::uint32_t>(templates_.size() + 1));
  if (is_new)
    spheres_.push_back(std::move(spheres));
  return entry->second;
}

void ViewSurvey::add_columns(const Frame& frame, const ParticleSet& set) {
  const std::vector<ViewColumn> columns = view_columns(frame, set, up_);
  if (frames_ == 0)
    for (const ViewColumn& column : columns)
      columns_.emplace_back(column);
  const auto named = [&](const std::string& name) {
    return std::find_if(columns.begin(), columns.end(),
                        [&](const ViewColumn& column) { return column.name == name; });
  };
  columns_.erase(std::remove_if(columns_.begin(), columns_.end(),
                                [&](const ColumnRange& range) {
                                  return named(range.name()) == columns.end();
                                }),
                 columns_.end());
  for (ColumnRange& range : columns_)
    range.add(named(range.name())->values);
}

ViewPage::ViewPage(ViewSurvey survey, ViewSettings settings)
    : survey_(std::move(survey)), settings_(std::move(settings)) {
  constexpr double largest_error = 1e-3; ///< of a coordinate, share of the smallest semi-axis
  double longest = 0.0;
  for (unsigned k = 0; k < 3; ++k)
    longest = std::max(longest, survey_.bounds_.upper[k] - survey_.bounds_.lower[k]);
  step_ = longest / 65535.0;
  is_fine_ = 0.5 * step_ > largest_error * survey_.smallest_axis_;
  if (is_fine_)
    step_ = longest / 4294967295.0;
}

std::size_t ViewPage::bytes_per_particle() const {
  return 4 + (is_fine_ ? 12 : 6) + 6 + 2 * survey_.columns_.size();
}

/// Number of the body, coordinates and turns of each particle, column by column.
void ViewPage::pack_bodies(PackedColumns& packed, const Frame& frame, const ParticleSet& set) {
  std::vector<std::uint32_t> bodies;
  std::array<std::vector<std::uint32_t>, 3> coordinates;
  std::array<std::vector<std::uint16_t>, 3> turns;
  for (const Particle& p : set.particles) {
    const double number = survey_.template_of(set, p);
    const auto body = survey_.bodies_.find(
        {static_cast<double>(p.id), p.semiaxes.x, p.semiaxes.y, p.semiaxes.z, number});
    if (body == survey_.bodies_.end())
      throw InputError(frame.location.file +
                       ": changed while it was read; start again when it is whole");
    bodies.push_back(body->second);
    for (unsigned k = 0; k < 3; ++k)
      coordinates[k].push_back(static_cast<std::uint32_t>(std::llround(
          (component(p.centre, k) - survey_.bounds_.lower[k]) / std::max(step_, 1e-300))));
    const auto turn = packed_quaternion(p.orientation);
    for (unsigned k = 0; k < 3; ++k)
      turns[k].push_back(turn[k]);
  }
  packed.add(bodies);
  for (const auto& column : coordinates)
    if (is_fine_)
      packed.add(column);
    else
      packed.add(std::vector<std::uint16_t>(column.begin(), column.end()));
  for (const auto& turn : turns)
    packed.add(turn);
}

/// What all frames know of each particle, as codes within the column's range.
void ViewPage::pack_columns(PackedColumns& packed, const Frame& frame,
                            const ParticleSet& set) const {
  const std::vector<ViewColumn> columns = view_columns(frame, set, survey_.up_);
  for (const ColumnRange& range : survey_.columns_)
    for (const ViewColumn& column : columns)
      if (column.name == range.name()) {
        std::vector<std::uint16_t> codes;
        for (const double value : column.values)
          codes.push_back(range.code_of(value));
        packed.add(codes);
      }
}

void ViewPage::pack_contacts(PackedColumns& packed, const std::vector<ViewContact>& contacts) {
  std::vector<std::uint32_t> first, second;
  std::vector<float> force, overlap;
  for (const ViewContact& contact : contacts) {
    first.push_back(static_cast<std::uint32_t>(contact.i));
    second.push_back(static_cast<std::uint32_t>(contact.j));
    force.push_back(static_cast<float>(contact.force));
    overlap.push_back(static_cast<float>(contact.overlap));
    largest_force_ = std::max(largest_force_, contact.force);
  }
  packed.add(first);
  packed.add(second);
  packed.add(force);
  packed.add(overlap);
}

void ViewPage::add(const Frame& frame, const ParticleSet& set,
                   const std::vector<ViewContact>& contacts, const std::optional<double>& time) {
  PackedColumns packed;
  pack_bodies(packed, frame, set);
  pack_columns(packed, frame, set);
  pack_contacts(packed, contacts);
  const json about = {{"count", set.particles.size()},
                      {"contacts", contacts.size()},
                      {"step", frame.timestep},
                      {"time_text", time_text(frame, time)},
                      {"box", box_json(set.box)}};
  frames_json_ += (frames_ ? "," : "") + about.dump();
  data_ += data_element(fmt::format("frame-{}", frames_++), packed);
}

std::string ViewPage::columns_json() const {
  json columns = json::array();
  for (const ColumnRange& range : survey_.columns_) {
    json column = {{"name", range.name()},
                   {"unit", range.unit()},
                   {"map", range.is_cyclic() ? "cyclic" : "even"}};
    if (range.is_of_kinds()) {
      column["kinds"] = range.kinds();
    } else {
      const bool has_values = range.low() <= range.high();
      column["low"] = has_values ? range.low() : 0.0;
      column["high"] = has_values ? range.high() : 1.0;
      const auto [low, high] = has_values ? range.shown() : std::pair(0.0, 1.0);
      column["shown"] = {low, high};
    }
    columns.push_back(column);
  }
  return columns.dump();
}

/// Ids, semi-axes and templates of all bodies, in the order of their numbers.
PackedColumns ViewPage::packed_survey() const {
  std::vector<ViewSurvey::Body> ordered(survey_.bodies_.size());
  for (const auto& [body, number] : survey_.bodies_)
    ordered[number] = body;
  std::vector<std::uint32_t> low, high, number;
  std::array<std::vector<float>, 3> axes;
  for (const auto& body : ordered) {
    const auto id = static_cast<std::uint64_t>(body[0]);
    low.push_back(static_cast<std::uint32_t>(id & 0xffffffffu));
    high.push_back(static_cast<std::uint32_t>(id >> 32));
    for (unsigned k = 0; k < 3; ++k)
      axes[k].push_back(static_cast<float>(body[k + 1]));
    number.push_back(static_cast<std::uint32_t>(body[4]));
  }
  PackedColumns bodies;
  bodies.add(low);
  bodies.add(high);
  for (const auto& axis : axes)
    bodies.add(axis);
  bodies.add(number);
  return bodies;
}

std::string ViewPage::header_json() const {
  const auto& bounds = survey_.bounds_;
  const Box bulk = survey_.bulk();
  const json position = {
      {"bytes", is_fine_ ? 4 : 2}, {"origin", bounds.lower}, {"step", {step_, step_, step_}}};
  const json maps = {{"even", settings_.even_colours},
                     {"cyclic", settings_.cyclic_colours},
                     {"kinds", settings_.kind_colours}};
  const json header = {{"title", settings_.title},
                       {"up", settings_.up == 1 || survey_.is_planar_ ? "y" : "z"},
                       {"planar", survey_.is_planar_},
                       {"colour_by", settings_.colour_by},
                       {"length_unit", "length"},
                       {"bodies", survey_.bodies_.size()},
                       {"bounds", {{"lower", bounds.lower}, {"upper", bounds.upper}}},
                       {"bulk", {{"lower", bulk.lower}, {"upper", bulk.upper}}},
                       {"position", position},
                       {"columns", json::parse(columns_json())},
                       {"frames", json::parse("[" + frames_json_ + "]")},
                       {"templates", templates_json(survey_.spheres_)},
                       {"walls", walls_json(settings_)},
                       {"cylinders", cylinders_json(settings_)},
                       {"meshes", meshes_json(settings_)},
                       {"has_contacts", settings_.has_contacts},
                       {"has_forces", settings_.has_forces},
                       {"largest_force", largest_force_},
                       {"maps", maps}};
  return header.dump();
}

std::string ViewPage::html() const {
  std::string data = data_element("bodies", packed_survey());
  for (std::size_t k = 0; k < settings_.meshes.size(); ++k) {
    PackedColumns corners;
    corners.add(settings_.meshes[k].corners);
    data += data_element(fmt::format("mesh-{}", k), corners);
  }
  return view_html({{"TITLE", html_safe(settings_.title)},
                    {"HEADER", script_safe(header_json())},
                    {"DATA", data + data_}});
}

} // namespace ellipsoid::post
