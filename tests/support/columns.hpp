#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "sigmasweep/model/parameters.hpp"

/// The golden list of columns: all fields of a row in the order in which they are stored, and which of them the table
/// of a sweep of soft spheres has where no other parameter is given.
namespace sigmasweep::golden {

enum class Part { parameters, results, timings };

struct Column {
  std::string_view name;
  Part part;
  std::string_view geometries;  ///< initials of the geometries whose tables have it: Column, Vibrated column, Lattice,
                                ///< Plate with a lattice
};

inline constexpr auto columns = std::to_array<Column>({
    {"v0", Part::parameters, "CL"},
    {"tc", Part::parameters, "CVLP"},
    {"s0", Part::parameters, "CL"},
    {"sigma", Part::parameters, "CL"},
    {"N", Part::parameters, "CVLP"},
    {"epsilon", Part::parameters, "CVLP"},
    {"method", Part::parameters, "CVLP"},
    {"geometry", Part::parameters, "VLP"},
    {"rows", Part::parameters, "LP"},
    {"columns", Part::parameters, "LP"},
    {"D_t", Part::parameters, ""},
    {"side_walls", Part::parameters, ""},
    {"wall", Part::parameters, ""},
    {"law", Part::parameters, ""},
    {"beta", Part::parameters, ""},
    {"gamma", Part::parameters, ""},
    {"K_over_m", Part::parameters, ""},
    {"D_n", Part::parameters, ""},
    {"material", Part::parameters, ""},
    {"integrator", Part::parameters, ""},
    {"d", Part::parameters, ""},
    {"width", Part::parameters, ""},
    {"random_separation", Part::parameters, ""},
    {"seed", Part::parameters, ""},
    {"ed_rule", Part::parameters, ""},
    {"steps_per_tc", Part::parameters, ""},
    {"tolerance", Part::parameters, ""},
    {"gravity", Part::parameters, ""},
    {"frequency", Part::parameters, "VP"},
    {"alpha", Part::parameters, "VP"},
    {"A0", Part::parameters, "VP"},
    {"periods", Part::parameters, "VP"},
    {"transient", Part::parameters, ""},
    {"eps_eff", Part::results, "CL"},
    {"eps_eff_error", Part::results, "CL"},
    {"Er_Ef", Part::results, "CL"},
    {"Er_Ef_error", Part::results, "CL"},
    {"Er_E0", Part::results, "CL"},
    {"v_cm", Part::results, "CL"},
    {"v_cm_error", Part::results, "CL"},
    {"t_k", Part::results, "CL"},
    {"x_max", Part::results, "CVLP"},
    {"predicted_growth", Part::results, ""},
    {"steps_used", Part::results, ""},
    {"h_cm", Part::results, "VP"},
    {"h_cm_error", Part::results, "VP"},
    {"h_cm_excess", Part::results, "VP"},
    {"separation", Part::results, "V"},
    {"separation_max", Part::results, "V"},
    {"E_r", Part::results, "VP"},
    {"cm_period", Part::results, "VP"},
    {"power_in", Part::results, "VP"},
    {"power_lost", Part::results, "VP"},
    {"imbalance", Part::results, "VP"},
    {"contacts", Part::results, "CVLP"},
    {"end", Part::results, "CVLP"},
    {"status", Part::results, "CVLP"},
    {"run_time", Part::timings, ""},
    {"predicted_time", Part::timings, ""},
    {"rank", Part::timings, ""},
    {"attempt", Part::timings, ""},
});

inline std::vector<std::string> names_of(Part part) {
  std::vector<std::string> names;
  for (const Column& column : columns)
    if (column.part == part) names.emplace_back(column.name);
  return names;
}

/// The columns of the table of a plain sweep.
inline std::vector<std::string> table_of(Geometry geometry) {
  const char initial = "CVLP"[static_cast<std::size_t>(geometry)];
  std::vector<std::string> names;
  for (const Column& column : columns)
    if (column.geometries.find(initial) != std::string_view::npos) names.emplace_back(column.name);
  return names;
}

}  // namespace sigmasweep::golden
