#include "plot/named.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "base/spelling.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {

const PlotSpec& plot_named(const std::vector<PlotSpec>& plots, const std::string& name) {
  if (const auto found = std::ranges::find(plots, name, &PlotSpec::name); found != plots.end()) return *found;
  std::vector<std::string_view> known;
  for (const PlotSpec& plot : plots)
    if (!plot.name.empty()) known.push_back(plot.name);
  throw UsageError(fmt::format("the table's spec has no plot '{}'{}", name,
                               known.empty() ? "; none has a name" : hint(name, known)));
}

std::string picture_named(const std::string& file, const std::string& name) {
  const std::filesystem::path path(file);
  const std::string stem = path.stem().string() + "-" + name;
  return (path.parent_path() / (stem + path.extension().string())).string();
}

}  // namespace sigmasweep
