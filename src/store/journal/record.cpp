#include "store/journal/record.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstddef>
#include <cstring>
#include <type_traits>

#include "model/packing.hpp"
#include "sigmasweep/sweep/content_key.hpp"
#include "sigmasweep/sweep/sweep.hpp"
#include "store/build_info.hpp"

namespace sigmasweep {
namespace {

constexpr std::uint64_t magic = 0x0a4c4e524a575353;  // "SSWJRNL\n" on a little-endian machine

constexpr std::uint64_t max_description_size = 1 << 28;  // a spec of 4 MiB, each byte of which JSON may write as six

static_assert(std::has_unique_object_representations_v<JournalHeader>);

/// All fields of a row besides its index.
std::vector<Field> record_fields() {
  std::vector<Field> fields;
  for (const auto list : {parameter_fields(), result_fields(), timing_fields()})
    fields.insert(fields.end(), list.begin(), list.end());
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
  const std::vector<Field> fields = record_fields();
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

std::string why_unreadable(const JournalHeader& found, std::size_t size) {
  const JournalHeader wanted = make_header({});
  if (size < sizeof found || found.magic != wanted.magic) return "is not a journal of sigmasweep";
  if (found.format_version != wanted.format_version)
    return fmt::format("is a journal of another version of sigmasweep (format {}, this one reads {})",
                       found.format_version, wanted.format_version);
  if (found.checksum != checksum_of(found) || found.description_size > max_description_size)
    return "is a journal with a damaged header";
  if (found.record_size != wanted.record_size || found.layout != wanted.layout)
    return "is a journal of another version of sigmasweep (its rows hold other fields)";
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

RecordCodec::RecordCodec(const JournalHeader& header)
    : fields_(record_fields()), size_(record_size(fields_)), seed_(header.checksum), rows_(header.rows) {}

std::uint64_t RecordCodec::checksum(const std::byte* record, std::uint64_t number) const {
  return XXH3_64bits_withSeed(record, size_ - sizeof(std::uint64_t), seed_ + number);
}

void RecordCodec::encode(const Row& row, std::uint64_t number, std::byte* record) const {
  const std::uint64_t key = content_key(row.parameters);
  std::memcpy(record, &row.index, sizeof row.index);
  std::memcpy(record + sizeof row.index, &key, sizeof key);
  pack(fields_, row, record + sizeof row.index + sizeof key);
  const std::uint64_t sum = checksum(record, number);
  std::memcpy(record + size_ - sizeof sum, &sum, sizeof sum);
}

std::optional<Row> RecordCodec::decode(const std::byte* record, std::uint64_t number) const {
  std::uint64_t sum = 0, key = 0;
  std::memcpy(&sum, record + size_ - sizeof sum, sizeof sum);
  if (sum != checksum(record, number)) return std::nullopt;
  Row row;
  std::memcpy(&row.index, record, sizeof row.index);
  std::memcpy(&key, record + sizeof row.index, sizeof key);
  if (row.index >= rows_ || !unpack(fields_, record + sizeof row.index + sizeof key, row)) return std::nullopt;
  if (key != content_key(row.parameters)) return std::nullopt;
  return row;
}

}  // namespace sigmasweep
