// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "field_rows.h"

#include <algorithm>

namespace ellipsoid::post {
namespace {

/// One quantity of the fields: a scalar, a vector or a tensor by its components.
struct FieldColumn {
  std::string name, unit, unit_key;
  std::vector<double> components;
  bool needs_matter = false; ///< has no value where there are no particles
};

std::vector<double> components_of(const Vector3& v) { return {v.x, v.y, v.z}; }
std::vector<double> components_of(const Tensor3& t) { return {t.begin(), t.end()}; }

std::vector<FieldColumn> columns_of(const Fields& f, const KnownFields& known) {
  std::vector<FieldColumn> columns{
      {"number density", "1/m3", "per_m3", {f.number_density}},
      {"density", "kg/m3", "kg_per_m3", {f.density}},
      {"solid fraction", "", "", {f.solid_fraction}},
  };
  const auto add = [&columns](FieldColumn column) { columns.push_back(std::move(column)); };
  if (known.has_motion) {
    add({"momentum", "kg/m2/s", "kg_per_m2_s", components_of(f.momentum)});
    add({"velocity", "m/s", "m_per_s", components_of(f.velocity), true});
    if (known.has_spins)
      add({"angular velocity", "rad/s", "rad_per_s", components_of(f.angular_velocity), true});
    add({"temperature", "m2/s2", "m2_per_s2", {f.temperature}, true});
    if (known.has_spins)
      add({"rotational temperature", "m2/s2", "m2_per_s2", {f.rotational_temperature}, true});
    add({"kinetic stress", "Pa", "Pa", components_of(f.kinetic_stress)});
  }
  if (known.has_forces) {
    add({"pressure", "Pa", "Pa", {(f.stress[0] + f.stress[4] + f.stress[8]) / 3.0}});
    add({"stress", "Pa", "Pa", components_of(f.stress)});
    add({"contact stress", "Pa", "Pa", components_of(f.contact_stress)});
    add({"couple stress", "N/m", "N_per_m", components_of(f.couple_stress)});
  }
  if (known.has_walls)
    add({"boundary force", "N/m3", "N_per_m3", components_of(f.boundary_force)});
  if (known.has_normals)
    add({"fabric", "", "", components_of(f.fabric)});
  return columns;
}

/// "velocity", "x", "m_per_s" and perhaps "standard_error" to one key, the unit last.
std::string key_of(const FieldColumn& column, const std::string& component,
                   const std::string& what = "") {
  std::string key = column.name;
  for (const std::string& part : {component, what, column.unit_key})
    key += part.empty() ? "" : "_" + part;
  std::replace(key.begin(), key.end(), ' ', '_');
  return key;
}

std::string component_name(std::size_t count, std::size_t k, const ComponentNames& names) {
  return count == 1 ? "" : count == 3 ? names[k] : names[k / 3] + names[k % 3];
}

const char* const standard_error = ", standard error"; ///< behind a column's name

} // namespace

void append_fields(Row& row, const Fields& fields, const KnownFields& known,
                   const ComponentNames& names) {
  for (const FieldColumn& column : columns_of(fields, known))
    for (std::size_t k = 0; k < column.components.size(); ++k) {
      const std::string component = component_name(column.components.size(), k, names);
      const bool is_known = !column.needs_matter || fields.density > 0.0;
      row.push_back({key_of(column, component),
                     column.name + (component.empty() ? "" : " " + component), column.unit,
                     is_known ? Value(column.components[k]) : Value()});
    }
}

std::vector<double> field_numbers(const Fields& fields, const KnownFields& known) {
  std::vector<double> numbers;
  for (const FieldColumn& column : columns_of(fields, known))
    numbers.insert(numbers.end(), column.components.begin(), column.components.end());
  return numbers;
}

void append_field_errors(Row& row, const KnownFields& known, const ComponentNames& names,
                         const std::vector<double>& errors) {
  std::size_t n = 0;
  for (const FieldColumn& column : columns_of({}, known))
    for (std::size_t k = 0; k < column.components.size(); ++k, ++n) {
      const std::string component = component_name(column.components.size(), k, names);
      const std::string name = column.name + (component.empty() ? "" : " " + component);
      row.push_back({key_of(column, component, "standard_error"), name + standard_error,
                     column.unit, n < errors.size() ? Value(errors[n]) : Value()});
    }
}

void append_main_fields(Row& row, const Row& all, const ComponentNames& names) {
  const std::string last = names[2] + names[2];
  for (const std::string& name :
       {std::string("density"), std::string("solid fraction"), "velocity " + names[0],
        "velocity " + names[1], "velocity " + names[2], std::string("temperature"),
        std::string("pressure"), "stress " + last, "fabric " + last})
    for (const Quantity& q : all)
      if (q.name == name || q.name == name + standard_error)
        row.push_back(q);
}

std::vector<GridValues> grid_values(const std::vector<Fields>& fields, const KnownFields& known) {
  std::vector<GridValues> result;
  for (const Fields& f : fields) {
    const std::vector<FieldColumn> columns = columns_of(f, known);
    result.resize(columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::vector<double>& values = columns[k].components;
      result[k].name = key_of(columns[k], "");
      result[k].components = static_cast<int>(values.size());
      result[k].values.insert(result[k].values.end(), values.begin(), values.end());
    }
  }
  return result;
}

} // namespace ellipsoid::post
