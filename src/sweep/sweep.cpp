#include "sigmasweep/sweep/sweep.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

#include <fmt/format.h>
#include <xxhash.h>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/relevance.hpp"
#include "sweep/spec/document.hpp"
#include "sweep/spec/trajectory.hpp"
#include "sweep/spec/with_points.hpp"
#include "sweep/spec/with_settings.hpp"
#include "sweep/toml/toml_guard.hpp"

namespace sigmasweep {
namespace {

std::vector<Field> columns_of(const spec::Tuples& tuples) {
  const auto some_tuple = [&](auto holds) { return std::ranges::any_of(tuples.representatives(), holds); };
  const auto& given = tuples.given();
  std::vector<Field> columns;
  for (const Field& field : parameter_fields()) {
    const bool is_given = std::ranges::find(given, field.name, &ParameterField::name) != given.end();
    if (is_given || (field.always_column && some_tuple(field.always_column->holds))) columns.push_back(field);
  }
  for (const Field& field : result_fields())
    if (some_tuple([&](const Parameters& tuple) { return applies_to(field, tuple); })) columns.push_back(field);
  return columns;
}

std::string read_text(const std::string& path) {
  errno = 0;
  std::ifstream stream(path == "-" ? "/dev/stdin" : path, std::ios::binary);
  std::string text(spec::max_text + 1, '\0');
  if (stream) stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream && !stream.eof()) {
    const int why = errno;
    throw InputNotFound(why == ENOENT ? fmt::format("there is no sweep spec {}", path)
                                      : fmt::format("cannot read the sweep spec {}: {}", path, std::strerror(why)));
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

/// What is no regular file, such as standard input, can be read once only, and a study loads its spec twice.
std::string text_of(const std::string& path) {
  if (path != "-" && std::filesystem::is_regular_file(path)) return read_text(path);
  static std::map<std::string, std::string> known;
  const auto found = known.find(path);
  return found != known.end() ? found->second : known.emplace(path, read_text(path)).first->second;
}

}  // namespace

struct Sweep::Impl {
  Impl(std::string_view text, const std::string& file)
      : document(text, file), hash(XXH3_64bits(text.data(), text.size())) {}
  const spec::Tuples& tuples() const { return *document.tuples; }

  spec::Document document;
  std::uint64_t hash;
  std::vector<Field> columns{};
  std::optional<TrajectorySpec> trajectory{};
};

Sweep::Sweep(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

Sweep Sweep::parse(std::string_view text, const std::string& file, Sections sections, bool any_section) {
  const auto impl = std::make_shared<Impl>(text, file);
  spec::Document& document = impl->document;
  spec::read_tables(document, sections, any_section);
  impl->columns = columns_of(impl->tuples());
  Sweep sweep(impl);
  spec::Mistakes mistakes;
  if (document.trajectory)
    mistakes.keep([&] { impl->trajectory = spec::read_trajectory(*document.trajectory, sweep); });
  for (const SpecSection& section : sections)
    if (const spec::Entry* table = sweep.section(section.name))
      mistakes.keep([&] { section.require_valid(*table, sweep); });
  mistakes.refuse_any(spec::Mistakes::readable);
  return sweep;
}

Sweep Sweep::parse(std::string_view text, const std::string& file, Sections sections) {
  return parse(text, file, sections, false);
}

Sweep Sweep::parse_stored(std::string_view text, const std::string& file) { return parse(text, file, {}, true); }

Sweep Sweep::load(const std::string& path, Sections sections, std::span<const std::string> settings) {
  const std::string text = text_of(path), file = path == "-" ? "standard input" : path;
  if (settings.empty()) return parse(spec::with_points(text, path), file, sections);
  return parse(spec::with_points(spec::with_settings(text, settings), path),
               fmt::format("--set {} in {}", fmt::join(settings, " --set "), file), sections);
}

const std::string& Sweep::title() const { return impl_->document.title; }
const std::string& Sweep::text() const { return impl_->document.text; }
std::uint64_t Sweep::hash() const { return impl_->hash; }
const std::vector<PlotSpec>& Sweep::plots() const { return impl_->document.plots; }
ManagerRole Sweep::manager() const { return impl_->document.run.manager; }
std::optional<double> Sweep::tuple_time_limit() const { return impl_->document.run.tuple_time_limit; }
const std::optional<TrajectorySpec>& Sweep::trajectory() const { return impl_->trajectory; }
const std::vector<std::string>& Sweep::axes() const { return impl_->tuples().axes(); }
const std::vector<std::uint64_t>& Sweep::axis_sizes() const { return impl_->tuples().axis_sizes(); }
const std::vector<Field>& Sweep::columns() const { return impl_->columns; }

const spec::Entry* Sweep::section(std::string_view name) const { return spec::find(impl_->document.sections, name); }

std::size_t Sweep::parts() const { return impl_->tuples().parts(); }
std::uint64_t Sweep::size() const { return impl_->tuples().size(); }

Parameters Sweep::at(std::uint64_t row) const {
  if (row >= size()) throw std::out_of_range(fmt::format("row {} of a sweep of {} rows", row, size()));
  return impl_->tuples().at(row);
}

}  // namespace sigmasweep
