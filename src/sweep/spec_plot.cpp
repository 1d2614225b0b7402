#include <array>

#include "sigmasweep/sweep/spelling.hpp"
#include "spec_tables.hpp"

namespace sigmasweep::spec {
namespace {

constexpr std::array<std::string_view, 6> plot_keys{"x", "y", "x_scale", "y_scale", "series", "title"};
constexpr std::array<std::string_view, 2> scales{"linear", "log"};
constexpr std::array<std::string_view, 1> run_keys{"manager"};
constexpr std::array<std::string_view, 3> managers{"auto", "computes", "dedicated"};

std::string as_field(const Entry& entry) {
  std::vector<std::string_view> known;
  for (const auto fields : {parameter_fields(), result_fields(), timing_fields()})
    for (const Field& field : fields) known.push_back(field.name);
  std::string name = as_string(entry);
  if (find_field(name) == nullptr) refuse_value(entry, "is no field of a row" + hint(name, known));
  return name;
}

}  // namespace

PlotSpec read_plot(const Entry& plot) {
  PlotSpec spec;
  for (const Entry& entry : entries(as_table(plot), *plot.file, plot.path)) {
    if (entry.name == "x") spec.x = as_field(entry);
    else if (entry.name == "y") spec.y = as_field(entry);
    else if (entry.name == "x_scale") spec.x_log = as_one_of(entry, scales) == 1;
    else if (entry.name == "y_scale") spec.y_log = as_one_of(entry, scales) == 1;
    else if (entry.name == "title") spec.title = as_string(entry);
    else if (entry.name == "series")
      for (const Entry& element : elements(entry)) spec.series.push_back(as_field(element));
    else refuse_unknown(entry, plot_keys);
  }
  return spec;
}

ManagerRole read_run(const Entry& run) {
  auto role = ManagerRole::automatic;
  for (const Entry& entry : entries(as_table(run), *run.file, run.path)) {
    if (entry.name != "manager") refuse_unknown(entry, run_keys);
    role = static_cast<ManagerRole>(as_one_of(entry, managers));
  }
  return role;
}

}  // namespace sigmasweep::spec
