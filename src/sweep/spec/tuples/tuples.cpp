#include "sweep/spec/tuples/tuples.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "sweep/toml/mistakes.hpp"

namespace sigmasweep::spec {
namespace {

constexpr std::size_t max_parts = 1000;
constexpr std::uint64_t max_tuples = std::uint64_t{1} << 40;

std::vector<Entry> tables_of(const Entry& sweep) {
  if (!sweep.node->is_array()) return {sweep};
  std::vector<Entry> tables = elements(sweep);
  if (tables.empty() || tables.size() > max_parts)
    refuse(sweep, fmt::format("1 to {} [[sweep]] are allowed", max_parts));
  return tables;
}

std::vector<Entry> keys_of(const std::optional<Entry>& defaults) {
  if (!defaults) return {};
  return entries(as_table(*defaults), *defaults->file, defaults->path);
}

bool has(const Grid& part, std::string_view name) {
  return std::ranges::find(part.given, name, &ParameterField::name) != part.given.end();
}

/// Refuses parameters in [defaults] that no part uses.
void require_used(const std::vector<Entry>& defaults, const std::vector<Grid>& parts,
                  const std::vector<Entry>& tables) {
  Mistakes mistakes;
  for (const Entry& key : defaults) {
    const auto has_own = [&](const Entry& table) { return as_table(table).contains(key.name); };
    if (std::ranges::all_of(tables, has_own))
      mistakes.keep([&] { refuse(key, "every [sweep] has its own"); });
    else if (find_parameter(key.name) &&
             std::ranges::none_of(parts, [&](const Grid& part) { return has(part, key.name); }))
      mistakes.keep([&] { refuse(key, "no tuple uses it"); });
  }
  mistakes.refuse_any();
}

}  // namespace

Tuples::Tuples(const Entry& sweep, const std::optional<Entry>& given_defaults) {
  const std::vector<Entry> tables = tables_of(sweep), defaults = keys_of(given_defaults);
  Mistakes mistakes;
  for (const Entry& table : tables)
    mistakes.keep([&] { parts_.push_back(std::move(*read_part(table, defaults, false))); });
  mistakes.refuse_any();
  require_used(defaults, parts_, tables);
  std::uint64_t size = 0;
  for (const Grid& part : parts_) ends_.push_back(size += size_of(part));
  if (size > max_tuples) refuse(sweep, fmt::format("{} tuples in all, at most 2^40 are allowed", size));
  combine();
}

void Tuples::combine() {
  for (const Grid& part : parts_) std::ranges::copy(part.representatives, std::back_inserter(representatives_));
  for (const ParameterField& field : fields_of_parameters())
    if (std::ranges::any_of(parts_, [&](const Grid& part) { return has(part, field.name); })) given_.push_back(&field);
  std::vector<const ParameterField*> varying;
  const auto add = [&](const ParameterField* field) {
    if (std::ranges::find(varying, field) == varying.end()) varying.push_back(field);
  };
  for (const Grid& part : parts_) std::ranges::for_each(part.axes, add);
  const auto differs = [&](const ParameterField* field) {
    const auto value = [&](const Grid& part) { return exact_number(*field, part.product.base()); };
    return std::ranges::any_of(parts_, [&](const Grid& part) { return value(part) != value(parts_.front()); });
  };
  for (const ParameterField* field : given_)
    if (differs(field)) add(field);
  for (const ParameterField* field : varying) {
    std::uint64_t values = 0;
    for (const Grid& part : parts_) {
      const auto axis = std::ranges::find(part.axes, field);
      values += axis == part.axes.end() ? 1 : part.axis_sizes[static_cast<std::size_t>(axis - part.axes.begin())];
    }
    axes_.emplace_back(field->name);
    axis_sizes_.push_back(values);
  }
}

Parameters Tuples::at(std::uint64_t row) const {
  const auto end = std::ranges::upper_bound(ends_, row);
  const Grid& part = parts_[static_cast<std::size_t>(end - ends_.begin())];
  const std::uint64_t within = row - (*end - size_of(part));
  return part.product.at(part.selection ? (*part.selection)[within] : within);
}

void require_readable(const Entry& sweep, const std::optional<Entry>& defaults) {
  Mistakes mistakes;
  for (const Entry& table : tables_of(sweep)) mistakes.keep([&] { read_part(table, keys_of(defaults), true); });
  mistakes.refuse_any();
}

}  // namespace sigmasweep::spec
