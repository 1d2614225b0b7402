#include "store/table/read.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "model/packing.hpp"
#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/handle.hpp"
#include "store/hdf5/open.hpp"
#include "store/hdf5/trial.hpp"
#include "store/table/checksum.hpp"
#include "store/table/info.hpp"
#include "store/table/types.hpp"

namespace sigmasweep {
namespace {

/// Whether every name of the HDF5 enumeration is one of `names`. HDF5 converts by name, but silently takes a name that
/// it does not find for another one.
bool has_only(hid_t enumeration, std::span<const std::string_view> names) {
  const auto members = static_cast<unsigned>(check(H5Tget_nmembers(enumeration), "cannot count the members"));
  for (unsigned i = 0; i < members; ++i)
    if (std::find(names.begin(), names.end(), member_name(enumeration, i)) == names.end()) return false;
  return true;
}

/// Whether a member of this HDF5 type can be read into a field of this type.
bool convertible(hid_t member, FieldType type) {
  const H5T_class_t found = H5Tget_class(member);
  if (type == FieldType::of<Flag>() && found == H5T_ENUM && has_only(member, flag_names)) return true;
  if (const auto names = enumerators(type); !names.empty()) return found == H5T_ENUM && has_only(member, names);
  return found == (type == FieldType::real ? H5T_FLOAT : H5T_INTEGER);
}

/// Whether a truth value of the compound has the names that earlier programs gave it.
bool has_earlier_flags(hid_t type, std::span<const Field> fields) {
  for (const Field& field : fields) {
    if (field.type != FieldType::of<Flag>()) continue;
    const std::int64_t i = check(H5Tget_member_index(type, std::string(field.name).c_str()), "cannot find a member");
    const Handle member(H5Tget_member_type(type, static_cast<unsigned>(i)), H5Tclose, "cannot read a member's type");
    if (has_only(member, enumerators(field.type))) return true;
  }
  return false;
}

/// Those of the `known` fields that the dataset has, in its order. Members of other names are ignored.
std::vector<Field> fields_in(hid_t type, const std::vector<Field>& known) {
  if (H5Tget_class(type) != H5T_COMPOUND) throw IoError("its rows are not compounds");
  std::vector<Field> fields;
  const auto members = static_cast<unsigned>(check(H5Tget_nmembers(type), "cannot count the members"));
  for (unsigned i = 0; i < members; ++i) {
    const std::string name = member_name(type, i);
    const auto field = std::find_if(known.begin(), known.end(), [&](const Field& f) { return f.name == name; });
    if (field == known.end()) continue;
    const Handle member(H5Tget_member_type(type, i), H5Tclose, "cannot read the type of member " + name);
    if (!convertible(member, field->type)) throw IoError("member " + name + " is not of the type expected");
    fields.push_back(*field);
  }
  return fields;
}

/// A small file may have many rows that are packed well.
void require_memory_for(std::uint64_t rows) {
  const double memory = double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGE_SIZE));
  if (double(rows) * double(sizeof(Row)) > memory)
    throw IoError(fmt::format("its {} rows do not fit into the memory of this machine", rows));
}

/// A dataset of a table that is open: the `known` members of its rows.
class OpenDataset {
 public:
  OpenDataset(hid_t file, const std::string& name, const std::vector<Field>& known, std::uint64_t rows)
      : name_(name),
        what_("cannot read dataset " + name),
        dataset_(open_dataset(file, name)),
        stored_(H5Dget_type(dataset_), H5Tclose, what_),
        space_(H5Dget_space(dataset_), H5Sclose, what_),
        rows_(rows) {
    if (H5Sget_simple_extent_ndims(space_) != 1 || H5Sget_simple_extent_npoints(space_) != static_cast<hssize_t>(rows))
      throw IoError(fmt::format("dataset {} has not the {} rows that it should have", name, rows));
    require_stored(dataset_, rows, H5Tget_size(stored_));
    fields_ = fields_in(stored_, known);
    if (fields_.empty()) throw IoError("dataset " + name + " has no member that is known");
    type_ = packed_type(fields_, has_earlier_flags(stored_, fields_));
  }

  const std::vector<Field>& fields() const { return fields_; }

  void check() const {
    if (checksum_of_layout(stored_) + checksum_of_stored_rows(dataset_, 0, rows_) != read_checksum(dataset_))
      throw IoError(fmt::format("dataset {} is damaged: its rows do not have its checksum", name_));
  }

  /// Sets the members of the rows from `first` on.
  void read(hsize_t first, std::span<Row> rows) const {
    const std::size_t size = packed_size(fields_);
    const hsize_t count = rows.size();
    std::vector<std::byte> buffer(size * count);
    const Handle in_memory(H5Screate_simple(1, &count, nullptr), H5Sclose, what_);
    sigmasweep::check(H5Sselect_hyperslab(space_, H5S_SELECT_SET, &first, nullptr, &count, nullptr), what_);
    sigmasweep::check(H5Dread(dataset_, type_, in_memory, space_, H5P_DEFAULT, buffer.data()), what_);
    for (hsize_t k = 0; k < count; ++k)
      if (!unpack(fields_, buffer.data() + k * size, rows[k]))
        throw IoError(fmt::format("row {} of dataset {} has a value that is none of its names", first + k, name_));
  }

 private:
  std::string name_, what_;
  Handle dataset_, stored_, space_, type_;
  std::uint64_t rows_;
  std::vector<Field> fields_;
};

constexpr std::uint64_t rows_at_a_time = 1 << 16;

/// A table that is open.
struct OpenTable {
  explicit OpenTable(const std::string& path)
      : file(open_file(path, "table")),
        stored(read_info(file)),
        results(file, "results", known_results(), stored.rows),
        timings(file, "timings", {timing_fields().begin(), timing_fields().end()}, stored.rows) {}

  static std::vector<Field> known_results() {
    std::vector<Field> known;
    for (const auto list : {parameter_fields(), result_fields()}) known.insert(known.end(), list.begin(), list.end());
    return known;
  }

  void read(std::uint64_t first, std::span<Row> rows) const {
    results.read(first, rows);
    timings.read(first, rows);
    for (std::uint64_t k = 0; k < rows.size(); ++k) rows[k].index = stored.info.slice.row(first + k);
  }

  Handle file;
  StoredInfo stored;
  OpenDataset results, timings;
};

Table read_open_table(const std::string& path) {
  const OpenTable open(path);
  open.results.check();
  open.timings.check();
  require_memory_for(open.stored.rows);
  Table table{open.stored.info, open.results.fields(), std::vector<Row>(open.stored.rows)};
  for (std::uint64_t first = 0; first < open.stored.rows; first += rows_at_a_time)
    open.read(first, std::span(table.rows).subspan(first, std::min(rows_at_a_time, open.stored.rows - first)));
  return table;
}

}  // namespace

struct TableRows::Impl {
  Hdf5Session session{};
  OpenTable open;
  std::uint64_t first = 0;
  std::vector<Row> rows{};  ///< from the first on

  explicit Impl(const std::string& path) : open(path) {}
};

TableRows::TableRows(const std::string& path) : impl_(std::make_unique<Impl>(path)) {}
TableRows::~TableRows() = default;
TableRows::TableRows(TableRows&&) noexcept = default;

std::uint64_t TableRows::size() const { return impl_->open.stored.rows; }

const Row& TableRows::operator[](std::uint64_t k) {
  Impl& table = *impl_;
  if (k < table.first || k >= table.first + table.rows.size()) {
    table.first = k;
    table.rows.assign(std::min(rows_at_a_time, size() - k), Row());
    table.open.read(k, table.rows);
  }
  return table.rows[k - table.first];
}

Table read_table(const std::string& path) {
  const Hdf5Session session;
  try {
    return read_after_trial(path, [&] { return read_open_table(path); });
  } catch (const IoError& error) {
    throw IoError(fmt::format("{} is not a whole table of sigmasweep: {}", path, error.what()));
  }
}

}  // namespace sigmasweep
