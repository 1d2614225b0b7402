#include "sweep/spec/tuples/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "base/spelling.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sweep/expression/expression.hpp"

namespace sigmasweep::spec {
namespace {

constexpr std::array<std::string_view, 2> scales{"linear", "log"};
constexpr std::array<std::string_view, 3> methods{"uniform", "sobol", "latin-hypercube"};
constexpr std::array<std::string_view, 6> samples{"uniform",         "log-uniform", "sobol",
                                                  "latin-hypercube", "normal",      "log-normal"};

constexpr auto known_keys = std::to_array<KeyInfo>({
    {"from", KeyForm::number, "first value, or lower end of a sample"},
    {"to", KeyForm::number, "last value, or upper end of a sample"},
    {"count", KeyForm::whole_number, "number of values"},
    {"scale", KeyForm::choice, "whether steps or ratios are even; of ranges, sobol and latin-hypercube", "linear",
     scales},
    {"sample", KeyForm::choice, "kind of a random or quasi-random sample", "none: a range", samples},
    {"seed", KeyForm::whole_number, "chooses the sample", "0"},
    {"mean", KeyForm::number, "mean of a normal or log-normal sample, which from and to may cut off"},
    {"sd", KeyForm::number, "standard deviation of a normal or log-normal sample"},
});

constexpr auto joint_keys = std::to_array<KeyInfo>({
    {"method", KeyForm::choice, "kind of the sample", "sobol", methods},
    {"of", KeyForm::names, "parameters, each with { from, to, scale }, or { sample = \"normal\", mean, sd }"},
    {"count", KeyForm::whole_number, "number of points"},
    {"seed", KeyForm::whole_number, "chooses the sample", "0"},
});

constexpr std::uint64_t max_values = std::uint64_t{1} << 40;
constexpr std::uint64_t max_stored_values = std::uint64_t{1} << 20;

bool is_whole(const ParameterField& field) { return field.type == FieldType::integer; }

/// Refuses a value that its parameter never has, with any values of other parameters.
void require_allowed(const Entry& entry, const ParameterField& field, double value, const std::string& shown) {
  const std::string why = why_refused(field, value, shown);
  if (why.empty()) return;
  const std::string_view path = entry.path;
  const std::string_view table = path.substr(0, path.find(fmt::format(".{}", field.name)) + 1);  // "sweep."
  throw SpecError(fmt::format("{}{}{}", place(*entry.file, entry.line), table, why));
}

std::vector<AnyNumber> read_list(const Entry& entry, const ParameterField& field) {
  std::vector<AnyNumber> values;
  for (const Entry& element : elements(entry)) values.push_back(read_value(element, field));
  if (values.empty()) refuse(entry, "an axis needs at least one value, this list is empty");
  return values;
}

void require_expression(const Entry& entry) {
  try {
    const Expression<Parameters> expression(as_string(entry), fields_of_parameters(), expression_types::Wanted::number);
  } catch (const UsageError& error) {
    refuse_value(entry, fmt::format("must be a number, or an expression: {}", error.what()));
  }
}

/// The keys of a range or a sample.
struct AxisTable {
  Interval interval;
  std::optional<NormalDistribution> normal;
  std::uint64_t count = 0;
  std::optional<SampleKind> sample;
  std::uint64_t seed = 0;
  const Entry *from = nullptr, *to = nullptr, *counted = nullptr;
};

using Keys = std::vector<Entry>;

const Entry& need(const Entry& entry, const Keys& keys, std::string_view name, std::string_view form) {
  if (const Entry* key = find(keys, name)) return *key;
  refuse(entry, fmt::format("'{}' is missing: {}", name, form));
}

constexpr std::string_view forms = "a range is { from, to, count, scale }, a sample { sample, from, to, count, seed }",
                           normal_form = "a normal sample is { sample, mean, sd, count, seed }",
                           joint_form = "a joint sample is { method, of, count, seed }";

Keys keys_of(const Entry& entry, std::span<const KeyInfo> known) {
  Keys keys = entries(as_table(entry), *entry.file, entry.path);
  std::vector<std::string_view> names;
  for (const KeyInfo& key : known) names.push_back(key.name);
  for (const Entry& key : keys)
    if (std::ranges::find(names, key.name) == names.end()) refuse_unknown(key, names);
  return keys;
}

/// The distribution of a normal sample, cut off at from and to where these are given.
void read_normal(const Entry& entry, const Keys& keys, bool log, const ParameterField& field, AxisTable& form) {
  const Entry &mean = need(entry, keys, "mean", normal_form), &sd = need(entry, keys, "sd", normal_form);
  NormalDistribution normal{as_number(mean), as_number(sd), log};
  if (!(normal.sd > 0.0 && std::isfinite(normal.sd))) refuse_value(sd, "must be a finite number > 0");
  if (!std::isfinite(normal.mean) || (log && normal.mean <= 0.0))
    refuse_value(mean, log ? "must be a finite number > 0" : "must be a finite number");
  if (log) {  // from mean and sd of the values to those of their logarithms
    const double variance = std::log1p(normal.sd / normal.mean * (normal.sd / normal.mean));
    normal.mean = std::log(normal.mean) - variance / 2.0;
    normal.sd = std::sqrt(variance);
  }
  form.normal = normal;
  const AnyNumber infinity = std::numeric_limits<AnyNumber>::infinity();
  form.interval.from = form.from ? read_value(*form.from, field) : log ? AnyNumber{0} : -infinity;
  form.interval.to = form.to ? read_value(*form.to, field) : infinity;
}

void read_scale(const Keys& keys, std::optional<std::size_t> sample, AxisTable& form) {
  const Entry* scale = find(keys, "scale");
  form.interval.log = sample == 1u || (scale != nullptr && as_one_of(*scale, scales) == 1u);
  if (scale == nullptr || !sample) return;
  if (*sample < 2) refuse(*scale, "is given by the sample: 'uniform' or 'log-uniform'");
  if (*sample > 3) refuse(*scale, "is given by the sample: 'normal' or 'log-normal'");
}

void read_sampling(const Entry& entry, const Keys& keys, std::optional<std::size_t> sample, const JointSample* joint,
                   AxisTable& form) {
  constexpr std::array of_samples{SampleKind::uniform,         SampleKind::uniform, SampleKind::sobol,
                                  SampleKind::latin_hypercube, SampleKind::uniform, SampleKind::uniform};
  constexpr std::array of_methods{SampleKind::uniform, SampleKind::sobol, SampleKind::latin_hypercube};
  const Entry* seed = find(keys, "seed");
  if (joint) {
    for (const Entry* key : {find(keys, "count"), seed})
      if (key) refuse(*key, "is given by sweep.sample");
    if (sample && *sample < 4) refuse(*find(keys, "sample"), "is given by sweep.sample, but for normal and log-normal");
    form.count = joint->count;
    form.seed = joint->seed;
    form.sample = of_methods.at(joint->method);
    return;
  }
  form.counted = &need(entry, keys, "count", form.normal ? normal_form : forms);
  form.count = as_count(*form.counted, 1, max_values);
  if (sample) form.sample = of_samples.at(*sample);
  if (seed && !sample) refuse(*seed, "only a sample has a seed");
  if (seed) form.seed = as_count(*seed, 0, INT64_MAX);
}

AxisTable read_form(const Entry& entry, const ParameterField& field, const Keys& keys, const JointSample* joint) {
  AxisTable form;
  std::optional<std::size_t> sample;
  if (const Entry* kind = find(keys, "sample")) sample = as_one_of(*kind, samples);
  const bool normal = sample && *sample > 3;
  form.from = normal ? find(keys, "from") : &need(entry, keys, "from", forms);
  form.to = normal ? find(keys, "to") : &need(entry, keys, "to", forms);
  if (normal) {
    read_normal(entry, keys, *sample == 5, field, form);
  } else {
    for (const std::string_view name : {"mean", "sd"})
      if (const Entry* key = find(keys, name)) refuse(*key, "only a normal or log-normal sample has it");
    form.interval.from = read_value(*form.from, field);
    form.interval.to = read_value(*form.to, field);
  }
  form.interval.whole = is_whole(field);
  read_sampling(entry, keys, sample, joint, form);
  read_scale(keys, sample, form);
  return form;
}

void require_sensible(const AxisTable& form) {
  const auto& [from, to, log, whole] = form.interval;
  for (const Entry* end : {form.from, form.to})
    if (end && log && as_number(*end) <= 0.0) refuse_value(*end, "a logarithmic axis needs from > 0 and to > 0");
  if (form.sample) {
    if (from > to)
      refuse_value(*form.from, fmt::format("must not be above 'to', which is {}", static_cast<double>(to)));
    return;
  }
  if (form.count == 1 && from != to)
    refuse_value(*form.counted, "both 'from' and 'to' are values of a range: at least 2");
  if (whole && log && form.count > max_stored_values)
    refuse_value(*form.counted, fmt::format("at most {} for a logarithmic range of whole numbers", max_stored_values));
  if (whole && !log && !has_whole_step(form.interval, form.count))
    refuse_value(*form.counted, fmt::format("{} values from {} to {} are not all whole numbers", form.count, from, to));
}

Sampling sampling_of(const AxisTable& form, const ParameterField& field, std::size_t sobol_dimension) {
  const std::uint64_t key = stream_key(form.seed, field.name);
  if (*form.sample == SampleKind::sobol) return {SampleKind::sobol, form.seed == 0 ? 0 : key, sobol_dimension};
  return {*form.sample, key, 0};
}

Axis axis_of(const Entry& entry, const ParameterField& field, const AxisTable& form, std::size_t sobol_dimension) {
  if (!form.sample) return Axis::range(form.interval, form.count);
  const Sampling sampling = sampling_of(form, field, sobol_dimension);
  if (!form.normal) return Axis::sample(form.interval, form.count, sampling);
  Axis axis = Axis::normal_sample(*form.normal, form.interval, form.count, sampling);
  const auto [least, most] = axis.bounds();
  for (const AnyNumber end : {least, most})
    if (const auto value = static_cast<double>(end);
        !std::isfinite(value) || (field.allowed.contain && !field.allowed.contain(value)))
      refuse(entry, fmt::format("the sample has the value {}, and it must be {}: cut it off by 'from' and 'to'", value,
                                field.allowed.must_be));
  return axis;
}

}  // namespace

AnyNumber read_value(const Entry& entry, const ParameterField& field) {
  if (field.type == FieldType::of<Flag>()) return as_truth(entry) ? 1 : 0;
  if (const auto names = enumerators(field.type); !names.empty())
    return static_cast<AnyNumber>(as_one_of(entry, names));
  const AnyNumber value = is_whole(field) ? static_cast<AnyNumber>(as_whole_number(entry)) : as_number(entry);
  const auto rounded = static_cast<double>(value);
  require_allowed(entry, field, rounded, is_whole(field) ? fmt::format("{:.0f}", value) : fmt::format("{}", rounded));
  return value;
}

JointSample read_joint_sample(const Entry& entry) {
  const Keys keys = keys_of(entry, joint_keys);
  JointSample sample{.entry = entry, .method = 1};
  for (const Entry& name : elements(need(entry, keys, "of", joint_form))) sample.of.push_back(as_string(name));
  if (sample.of.empty()) refuse(entry, "'of' names no parameter");
  sample.count = as_count(need(entry, keys, "count", joint_form), 1, max_values);
  if (const Entry* method = find(keys, "method")) sample.method = as_one_of(*method, methods);
  if (const Entry* seed = find(keys, "seed")) sample.seed = as_count(*seed, 0, INT64_MAX);
  return sample;
}

Setting read_setting(const Entry& entry, const ParameterField& field, std::size_t sobol_dimension,
                     const JointSample* joint) {
  const auto names = enumerators(field.type);
  if (joint && !entry.node->is_table())
    refuse(entry, "sweep.sample samples it: give { from, to, scale }, or { sample = \"normal\", mean, sd }");
  if (entry.node->is_array()) return {entry, &field, Axis::list(read_list(entry, field)), true};
  if (entry.node->is_string() && names.empty()) {
    require_expression(entry);
    return {.entry = entry, .field = &field, .axis = Axis::list({0}), .expression = as_string(entry)};
  }
  if (!entry.node->is_table()) return {entry, &field, Axis::list({read_value(entry, field)})};
  if (field.type == FieldType::of<Flag>()) refuse(entry, "must be true or false, or a list of them");
  if (!names.empty()) refuse(entry, fmt::format("must be a name or a list of names: {}", alternatives(names)));
  const Keys keys = keys_of(entry, known_keys);
  const AxisTable form = read_form(entry, field, keys, joint);
  require_sensible(form);
  return {entry, &field, axis_of(entry, field, form, sobol_dimension), true, form.sample == SampleKind::sobol};
}

std::vector<KeyInfo> keys_of_axis() { return {known_keys.begin(), known_keys.end()}; }
std::vector<KeyInfo> keys_of_joint_sample() { return {joint_keys.begin(), joint_keys.end()}; }

}  // namespace sigmasweep::spec
