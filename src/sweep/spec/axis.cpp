#include "sweep/spec/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/spelling.hpp"
#include "sigmasweep/base/errors.hpp"

namespace sigmasweep::spec {
namespace {

constexpr std::array<std::string_view, 2> scales{"linear", "log"};
constexpr std::array<std::string_view, 4> samples{"uniform", "log-uniform", "sobol", "latin-hypercube"};

constexpr auto known_keys = std::to_array<KeyInfo>({
    {"from", KeyForm::number, "first value, or lower end of a sample"},
    {"to", KeyForm::number, "last value, or upper end of a sample"},
    {"count", KeyForm::whole_number, "number of values"},
    {"scale", KeyForm::choice, "whether steps or ratios are even; not of uniform and log-uniform", "linear", scales},
    {"sample", KeyForm::choice, "kind of a random or quasi-random sample", "none: a range", samples},
    {"seed", KeyForm::whole_number, "chooses the sample", "0"},
});

constexpr std::uint64_t max_values = std::uint64_t{1} << 40;
constexpr std::uint64_t max_stored_values = std::uint64_t{1} << 20;

bool is_whole(const ParameterField& field) { return field.type == FieldType::integer; }

/// Refuses a value that its parameter never has, with any values of other parameters.
void require_allowed(const Entry& entry, const ParameterField& field, double value, const std::string& shown) {
  const std::string why = why_refused(field, value, shown);
  if (!why.empty()) throw SpecError(fmt::format("{}sweep.{}", place(*entry.file, entry.line), why));
}

AnyNumber read_value(const Entry& entry, const ParameterField& field) {
  if (field.type == FieldType::of<Flag>()) return as_truth(entry) ? 1 : 0;
  if (const auto names = enumerators(field.type); !names.empty())
    return static_cast<AnyNumber>(as_one_of(entry, names));
  const AnyNumber value = is_whole(field) ? static_cast<AnyNumber>(as_whole_number(entry)) : as_number(entry);
  const auto rounded = static_cast<double>(value);
  require_allowed(entry, field, rounded, is_whole(field) ? fmt::format("{:.0f}", value) : fmt::format("{}", rounded));
  return value;
}

std::vector<AnyNumber> read_list(const Entry& entry, const ParameterField& field) {
  std::vector<AnyNumber> values;
  for (const Entry& element : elements(entry)) values.push_back(read_value(element, field));
  if (values.empty()) refuse(entry, "an axis needs at least one value, this list is empty");
  return values;
}

/// The keys of a range or a sample.
struct AxisTable {
  Interval interval;
  std::uint64_t count = 0;
  std::optional<std::size_t> sample, scale;
  std::uint64_t seed = 0;
  Entry from, to, counted;
};

const Entry* find(const std::vector<Entry>& keys, std::string_view name) {
  for (const Entry& key : keys)
    if (key.name == name) return &key;
  return nullptr;
}

const Entry& need(const Entry& entry, const std::vector<Entry>& keys, std::string_view name) {
  if (const Entry* key = find(keys, name)) return *key;
  refuse(entry, fmt::format("'{}' is missing: a range is {{ from, to, count, scale }}, a sample "
                            "{{ sample, from, to, count, seed }}",
                            name));
}

AxisTable read_form(const Entry& entry, const ParameterField& field) {
  if (field.type == FieldType::of<Flag>()) refuse(entry, "must be true or false, or a list of them");
  if (!enumerators(field.type).empty())
    refuse(entry, fmt::format("must be a name or a list of names: {}", alternatives(enumerators(field.type))));
  const auto keys = entries(as_table(entry), *entry.file, entry.path);
  std::array<std::string_view, known_keys.size()> names;
  std::ranges::transform(known_keys, names.begin(), &KeyInfo::name);
  for (const Entry& key : keys)
    if (std::ranges::find(names, key.name) == names.end()) refuse_unknown(key, names);

  AxisTable form;
  form.from = need(entry, keys, "from");
  form.to = need(entry, keys, "to");
  form.counted = need(entry, keys, "count");
  form.interval.from = read_value(form.from, field);
  form.interval.to = read_value(form.to, field);
  form.interval.whole = is_whole(field);
  form.count = as_count(form.counted, 1, max_values);
  if (const Entry* sample = find(keys, "sample")) form.sample = as_one_of(*sample, samples);
  if (const Entry* scale = find(keys, "scale")) {
    form.scale = as_one_of(*scale, scales);
    if (form.sample && *form.sample < 2) refuse(*scale, "is given by the sample: 'uniform' or 'log-uniform'");
  }
  if (const Entry* seed = find(keys, "seed")) {
    if (!form.sample) refuse(*seed, "only a sample has a seed");
    form.seed = as_count(*seed, 0, INT64_MAX);
  }
  form.interval.log = form.scale == 1u || form.sample == 1u;
  return form;
}

void require_sensible(const AxisTable& form) {
  const auto& [from, to, log, whole] = form.interval;
  for (const Entry* end : {&form.from, &form.to})
    if (log && as_number(*end) <= 0.0) refuse_value(*end, "a logarithmic axis needs from > 0 and to > 0");
  if (form.sample) {
    if (from > to) refuse_value(form.from, fmt::format("must not be above 'to', which is {}", static_cast<double>(to)));
    return;
  }
  if (form.count == 1 && from != to)
    refuse_value(form.counted, "both 'from' and 'to' are values of a range: at least 2");
  if (whole && log && form.count > max_stored_values)
    refuse_value(form.counted, fmt::format("at most {} for a logarithmic range of whole numbers", max_stored_values));
  if (whole && !log && !has_whole_step(form.interval, form.count))
    refuse_value(form.counted, fmt::format("{} values from {} to {} are not all whole numbers", form.count, from, to));
}

Sampling sampling_of(const AxisTable& form, const ParameterField& field, std::size_t sobol_dimension) {
  const std::uint64_t key = stream_key(form.seed, field.name);
  switch (*form.sample) {
    case 2: return {SampleKind::sobol, form.seed == 0 ? 0 : key, sobol_dimension};
    case 3: return {SampleKind::latin_hypercube, key, 0};
    default: return {SampleKind::uniform, key, 0};
  }
}

}  // namespace

Setting read_setting(const Entry& entry, const ParameterField& field, std::size_t sobol_dimension) {
  if (entry.node->is_array()) return {entry, &field, Axis::list(read_list(entry, field)), true};
  if (!entry.node->is_table()) return {entry, &field, Axis::list({read_value(entry, field)})};
  const AxisTable form = read_form(entry, field);
  require_sensible(form);
  if (!form.sample) return {entry, &field, Axis::range(form.interval, form.count), true};
  const Sampling sampling = sampling_of(form, field, sobol_dimension);
  return {entry, &field, Axis::sample(form.interval, form.count, sampling), true, sampling.kind == SampleKind::sobol};
}

std::vector<KeyInfo> keys_of_axis() { return {known_keys.begin(), known_keys.end()}; }

}  // namespace sigmasweep::spec
