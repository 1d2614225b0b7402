#include "store/journal/record.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstddef>
#include <cstring>
#include <tuple>
#include <type_traits>
#include <utility>

#include "model/packing.hpp"
#include "store/build_info.hpp"

namespace sigmasweep {
namespace {

constexpr std::uint64_t magic = 0x0a4c4e524a575353;  // "SSWJRNL\n" on a little-endian machine

constexpr std::uint64_t max_description_size = 1 << 28;  // a spec of 4 MiB, each byte of which JSON may write as six

static_assert(std::has_unique_object_representations_v<JournalHeader>);

/// All fields of a record of this format besides index and content key.
std::vector<Field> fields_of(std::uint32_t format_version, std::span<const Field> results) {
  std::vector<Field> fields;
  const auto add = [&](std::span<const Field> list) { fields.insert(fields.end(), list.begin(), list.end()); };
  const bool has_all = format_version == journal_format_with_parameters;
  if (has_all) add(parameter_fields());
  add(has_all || results.empty() ? result_fields() : results);
  add(timing_fields());
  return fields;
}

std::size_t record_size(const std::vector<Field>& fields) {
  return packed_size(fields) + 3 * sizeof(std::uint64_t);  // index, content key, checksum
}

std::uint64_t layout_of(const std::vector<Field>& fields) {
  std::string layout;
  for (const Field& field : fields)
    layout += fmt::format("{}:{}:{};", field.name, static_cast<int>(field.type.storage),
                          fmt::join(enumerators(field.type), ","));
  return XXH3_64bits(layout.data(), layout.size());
}

std::uint64_t checksum_of(const JournalHeader& header) {
  return XXH3_64bits(&header, offsetof(JournalHeader, checksum));
}

std::uint32_t build_hash() {
  const std::string build = build_name();
  return static_cast<std::uint32_t>(XXH3_64bits(build.data(), build.size()));
}

}  // namespace

JournalHeader make_header(const JournalIdentity& identity, std::string_view description) {
  const std::vector<Field> fields = fields_of(journal_format_version, identity.results);
  JournalHeader header;
  header.magic = magic;
  header.format_version = journal_format_version;
  header.record_size = static_cast<std::uint32_t>(record_size(fields));
  header.layout = layout_of(fields);
  header.spec_hash = identity.spec_hash;
  header.rows = identity.rows;
  header.physics_version = identity.physics_version;
  header.build = build_hash();
  header.description_size = description.size();
  header.description_checksum = XXH3_64bits(description.data(), description.size());
  header.checksum = checksum_of(header);
  return header;
}

std::uint64_t first_record(const JournalHeader& header) { return sizeof header + header.description_size; }

bool is_description_of(const JournalHeader& header, std::string_view description) {
  return description.size() == header.description_size &&
         XXH3_64bits(description.data(), description.size()) == header.description_checksum;
}

bool is_ours(const JournalHeader& found, std::size_t size) { return size >= sizeof found && found.magic == magic; }

bool is_of_same_sweep(const JournalHeader& a, const JournalHeader& b) {
  return std::tie(a.spec_hash, a.rows, a.physics_version, a.build) ==
         std::tie(b.spec_hash, b.rows, b.physics_version, b.build);
}

std::optional<std::vector<Field>> record_fields(const JournalHeader& header, std::span<const Field> results) {
  std::vector<Field> fields = fields_of(header.format_version, results);
  if (header.record_size != record_size(fields) || header.layout != layout_of(fields)) return std::nullopt;
  return fields;
}

std::string why_unreadable(const JournalHeader& found, std::size_t size) {
  if (!is_ours(found, size)) return "is not a journal of sigmasweep";
  if (found.format_version != journal_format_version && found.format_version != journal_format_with_parameters)
    return fmt::format("is a journal of another version of sigmasweep (format {}, this one reads {} and {})",
                       found.format_version, journal_format_with_parameters, journal_format_version);
  if (found.checksum != checksum_of(found) || found.description_size > max_description_size)
    return "is a journal with a damaged header";
  if (found.format_version == journal_format_with_parameters && !record_fields(found, {})) return other_fields;
  return {};
}

std::string why_unusable(const JournalHeader& found, std::size_t size, const JournalIdentity& identity) {
  if (std::string why = why_unreadable(found, size); !why.empty()) return why;
  const JournalHeader wanted = make_header(identity);
  if (found.spec_hash != wanted.spec_hash)
    return fmt::format("belongs to another sweep spec or slice (its hash is {:016x}, this one's {:016x})",
                       found.spec_hash, wanted.spec_hash);
  if (found.physics_version != wanted.physics_version)
    return fmt::format("was begun with physics version {}, this program has {}", found.physics_version,
                       wanted.physics_version);
  if (found.build != wanted.build) return "was begun by another build of the program, whose last digits may differ";
  if (found.rows != wanted.rows)
    return fmt::format("is of a sweep of {} rows, this one has {}", found.rows, wanted.rows);
  return {};
}

RecordCodec::RecordCodec(const JournalHeader& header, std::vector<Field> fields)
    : fields_(std::move(fields)), size_(record_size(fields_)), seed_(header.checksum), rows_(header.rows) {}

std::uint64_t RecordCodec::checksum(const std::byte* record, std::uint64_t number) const {
  return XXH3_64bits_withSeed(record, size_ - sizeof(std::uint64_t), seed_ + number);
}

void RecordCodec::encode(const Row& row, std::uint64_t key, std::uint64_t number, std::byte* record) const {
  std::memcpy(record, &row.index, sizeof row.index);
  std::memcpy(record + sizeof row.index, &key, sizeof key);
  pack(fields_, row, record + sizeof row.index + sizeof key);
  const std::uint64_t sum = checksum(record, number);
  std::memcpy(record + size_ - sizeof sum, &sum, sizeof sum);
}

std::uint64_t RecordCodec::index_of(const std::byte* record) {
  std::uint64_t index = 0;
  std::memcpy(&index, record, sizeof index);
  return index;
}

std::optional<JournalledRow> RecordCodec::decode(const std::byte* record, std::uint64_t number) const {
  std::uint64_t sum = 0;
  std::memcpy(&sum, record + size_ - sizeof sum, sizeof sum);
  if (sum != checksum(record, number)) return std::nullopt;
  JournalledRow found;
  found.row.index = index_of(record);
  std::memcpy(&found.content_key, record + sizeof found.row.index, sizeof found.content_key);
  if (found.row.index >= rows_) return std::nullopt;
  if (!unpack(fields_, record + sizeof found.row.index + sizeof found.content_key, found.row)) return std::nullopt;
  found.row.parameters = {};
  return found;
}

}  // namespace sigmasweep
