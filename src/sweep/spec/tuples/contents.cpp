#include "sweep/spec/tuples/contents.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>

#include <fmt/format.h>

#include "sigmasweep/base/errors.hpp"
#include "sweep/spec/tuples/points.hpp"
#include "sweep/spec/tuples/zips.hpp"
#include "sweep/toml/mistakes.hpp"

namespace sigmasweep::spec {
namespace {

/// Keys of [sweep] that are not parameters.
constexpr auto other_keys = std::to_array<KeyInfo>({
    {"zip", KeyForm::groups, "groups of axes that advance together", "all axes multiply"},
    {"where", KeyForm::condition, "condition on the parameters of the tuples that are computed", "all tuples"},
    {"points", KeyForm::text, "a CSV file of tuples, its columns parameters; or its text, with line ends", "none"},
    {.name = "sample",
     .form = KeyForm::table,
     .meaning = "one sample of several parameters",
     .usual = "none",
     .keys = keys_of_joint_sample},
});

void require_known(const Entry& key) {
  std::vector<std::string_view> known;
  for (const Field& field : parameter_fields()) known.push_back(field.name);
  for (const KeyInfo& other : other_keys) known.push_back(other.name);
  if (std::ranges::find(known, key.name) == known.end()) refuse_unknown(key, known);
}

/// The keys of a part: those of [defaults] that it does not have itself, then its own.
std::vector<Entry> keys_of(const Entry& sweep, const std::vector<Entry>& defaults) {
  const auto own = entries(as_table(sweep), *sweep.file, sweep.path);
  std::vector<Entry> keys;
  std::ranges::copy_if(defaults, std::back_inserter(keys), [&](const Entry& key) { return !find(own, key.name); });
  std::ranges::copy(own, std::back_inserter(keys));
  return keys;
}

/// Reads the settings of a part, and which of them advance together.
class Reader {
 public:
  explicit Reader(std::vector<Entry> keys) : keys_(std::move(keys)) {}

  SweepKeys contents() {
    SweepKeys& all = contents_;
    if (const Entry* zip = find(keys_, "zip")) all.zip = *zip;
    if (const Entry* where = find(keys_, "where")) all.where = *where;
    if (const Entry* key = find(keys_, "points")) mistakes_.keep([this, points = *key] { read_points_of(points); });
    if (const Entry* sample = find(keys_, "sample")) mistakes_.keep([&] { read_sample(*sample); });
    if (all.zip) mistakes_.keep([&] { read_zips(*all.zip, all.zips); });
    for (const Entry& key : keys_) mistakes_.keep([&] { read(key); });
    if (all.where) mistakes_.keep([&] { condition_of(*all.where); });
    mistakes_.refuse_any();
    return std::move(all);
  }

 private:
  void read_points_of(const Entry& entry) {
    points_ = read_points(entry);
    Zip names;
    for (const Setting& setting : points_) {
      std::erase_if(keys_, [&](const Entry& key) { return key.name == setting.field->name && is_default(key); });
      if (const Entry* key = find(keys_, setting.field->name))
        refuse(*key, fmt::format("is given by the points in line {}", entry.line));
      names.emplace_back(setting.field->name);
    }
    if (names.size() > 1) contents_.zips.push_back(std::move(names));
  }

  void read_sample(const Entry& entry) {
    joint_ = read_joint_sample(entry);
    for (const std::string& name : joint_->of) {
      if (find(keys_, name) == nullptr || find_parameter(name) == nullptr)
        refuse(entry, fmt::format("'{}' is not a parameter in [sweep]", name));
      if (zip_of(contents_.zips, name)) refuse(entry, fmt::format("'{}' is zipped already", name));
    }
    if (std::set<std::string>(joint_->of.begin(), joint_->of.end()).size() < joint_->of.size())
      refuse(entry, "'of' names a parameter twice");
    if (joint_->of.size() > 1) contents_.zips.push_back(joint_->of);
  }

  void read(const Entry& key) {
    require_known(key);
    if (key.name == "points") std::ranges::copy(points_, std::back_inserter(contents_.settings));
    const ParameterField* field = find_parameter(key.name);
    if (field == nullptr) return;
    const Zip* zip = zip_of(contents_.zips, key.name);
    const bool is_joint = joint_ && std::ranges::find(joint_->of, key.name) != joint_->of.end();
    contents_.settings.push_back(read_setting(key, *field, zip ? sobol_axes_[zip] : 0, is_joint ? &*joint_ : nullptr));
    if (contents_.settings.back().is_sobol) ++sobol_axes_[zip];
  }

  std::vector<Entry> keys_;
  SweepKeys contents_;
  std::vector<Setting> points_;
  std::optional<JointSample> joint_;
  std::map<const Zip*, std::size_t> sobol_axes_;  ///< zipped Sobol axes are dimensions of one sequence
  Mistakes mistakes_;
};

}  // namespace

bool is_default(const Entry& key) { return key.path.starts_with("defaults."); }

ParameterWhere condition_of(const Entry& entry) {
  try {
    return {as_string(entry), fields_of_parameters()};
  } catch (const UsageError& error) {
    refuse_value(entry, error.what());
  }
}

SweepKeys read_contents(const Entry& sweep, const std::vector<Entry>& defaults) {
  return Reader(keys_of(sweep, defaults)).contents();
}

std::vector<KeyInfo> keys_of_sweep() { return {other_keys.begin(), other_keys.end()}; }

}  // namespace sigmasweep::spec
