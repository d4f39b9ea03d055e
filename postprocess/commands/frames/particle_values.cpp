// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "particle_values.h"

#include "input_error.h"
#include "messages.h"
#include "step_names.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace ellipsoid::post {
namespace {

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

std::string csv_text(const ChosenFrame& chosen, const std::vector<ParticleValues>& columns) {
  Table table{"Particles", {}};
  chosen.set.has_types.require_readable();
  for (std::size_t i = 0; i < chosen.set.particles.size(); ++i) {
    const Particle& p = chosen.set.particles[i];
    Row row = frame_row(chosen);
    row.push_back({"id", "id", "", p.id});
    row.push_back({"type", "type", "", p.type});
    row.push_back({"x_m", "x", "m", p.centre.x});
    row.push_back({"y_m", "y", "m", p.centre.y});
    row.push_back({"z_m", "z", "m", p.centre.z});
    for (const ParticleValues& column : columns)
      row.push_back({column.key, column.key, "",
                     std::isnan(column.values[i]) ? Value() : Value(column.values[i])});
    table.rows.push_back(std::move(row));
  }
  return as_csv(table);
}

/// Origin and edges of a box whose first edge is not along x, or the second one not in the plane
/// of x and y.
std::string general_box_text(const Box& box) {
  std::string text = fmt::format("ITEM: BOX BOUNDS abc origin {}\n", box.boundary);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3& edge = box.tilted_edges[k];
    text += fmt::format("{} {} {} {}\n", edge.x, edge.y, edge.z, box.lower[k]);
  }
  return text;
}

/// Bounds of the box, of a tilted one those of the box around it and the tilts.
std::string box_text(const Box& box) {
  if (box.tilted_edges.empty())
    return fmt::format("ITEM: BOX BOUNDS {}\n{} {}\n{} {}\n{} {}\n", box.boundary, box.lower[0],
                       box.upper[0], box.lower[1], box.upper[1], box.lower[2], box.upper[2]);
  const Vector3 &a = box.tilted_edges[0], &b = box.tilted_edges[1], &c = box.tilted_edges[2];
  const bool is_along_axes = a.y == 0.0 && a.z == 0.0 && b.z == 0.0;
  if (!is_along_axes || a.x <= 0.0 || b.y <= 0.0 || c.z <= 0.0)
    return general_box_text(box);
  const double low_x = std::min({0.0, b.x, c.x, b.x + c.x}), low_y = std::min(0.0, c.y);
  const double high_x = std::max({0.0, b.x, c.x, b.x + c.x}), high_y = std::max(0.0, c.y);
  return fmt::format("ITEM: BOX BOUNDS xy xz yz {}\n{} {} {}\n{} {} {}\n{} {} {}\n", box.boundary,
                     box.lower[0] + low_x, box.lower[0] + a.x + high_x, b.x, box.lower[1] + low_y,
                     box.lower[1] + b.y + high_y, c.x, box.lower[2], box.lower[2] + c.z, c.y);
}

/// Columns that are no numbers are not kept.
void warn_of_words(const ChosenFrame& chosen) {
  std::string names;
  for (std::size_t k = 0; k < chosen.frame.names.size(); ++k)
    if (!chosen.frame.is_readable(k))
      names += (names.empty() ? "" : ", ") + chosen.frame.names[k];
  if (!names.empty())
    report_warning(fmt::format("{}: not all values are numbers, so the .dump of --per-particle is "
                               "without: {}",
                               chosen.run, names),
                   chosen.run + " without " + names);
}

std::string dump_text(const ChosenFrame& chosen, const std::vector<ParticleValues>& columns) {
  const Frame& frame = chosen.frame;
  if (chosen.set.particles.size() != frame.rows)
    throw InputError("--per-particle: bodies take several rows of this dump: choose a name that "
                     "ends in .csv");
  warn_of_words(chosen);
  std::vector<std::size_t> kept; // columns of numbers
  std::string text = frame.units.empty() ? "" : "ITEM: UNITS\n" + frame.units + "\n";
  if (frame.time)
    text += fmt::format("ITEM: TIME\n{}\n", *frame.time);
  text +=
      fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n", frame.timestep, frame.rows) +
      box_text(chosen.set.box);
  text += "ITEM: ATOMS";
  for (std::size_t k = 0; k < frame.names.size(); ++k)
    if (frame.is_readable(k)) {
      kept.push_back(k);
      text += " " + frame.names[k];
    }
  for (const ParticleValues& column : columns)
    text += " " + column.key;
  text += "\n";
  for (std::size_t i = 0; i < chosen.set.particles.size(); ++i) {
    for (const std::size_t k : kept)
      text += fmt::format("{} ", frame.columns[k][chosen.set.particles[i].row]);
    for (const ParticleValues& column : columns)
      text += fmt::format("{} ", column.values[i]);
    text.back() = '\n';
  }
  return text;
}

} // namespace

void add_particle_values_option(CLI::App& command, std::string& path) {
  command.add_option("--per-particle", path,
                     "file for the values of every particle: .csv, or .dump (the dump with further "
                     "columns, for pictures and ParaView); * stands for the time step");
}

void write_particle_values(const std::string& path, const ChosenFrame& chosen,
                           const std::vector<ParticleValues>& columns) {
  const std::string name = name_with_step(path, chosen.frame.timestep);
  if (ends_with(name, ".csv"))
    write_text(name, csv_text(chosen, columns));
  else if (ends_with(name, ".dump"))
    write_text(name, dump_text(chosen, columns));
  else
    throw InputError(name + ": --per-particle needs a name that ends in .csv or .dump");
}

} // namespace ellipsoid::post
