#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "store/journal/journal.hpp"

/// The bytes of a journal: one header, then records of one size. Numbers are the machine's own (a journal is finished
/// where it was begun).
namespace sigmasweep {

inline constexpr std::uint32_t journal_format_version = 1;

/// What a journal starts with.
struct JournalHeader {
  std::uint64_t magic = 0;
  std::uint32_t format_version = 0;
  std::uint32_t record_size = 0;
  std::uint64_t layout = 0;  ///< hash of the names and types of the fields in a record
  std::uint64_t spec_hash = 0;
  std::uint64_t rows = 0;
  std::uint32_t physics_version = 0;
  std::uint32_t build = 0;  ///< hash of compiler, its options and the program's version: what the last digits hang on
  std::uint64_t checksum = 0;  ///< xxh3 of all before
};

/// The header of this program's journal for that sweep.
JournalHeader make_header(const JournalIdentity& identity);

/// Empty if `found`, the first `size` bytes of a file, is the header for that sweep; else what is wrong with the file.
std::string why_unusable(const JournalHeader& found, std::size_t size, const JournalIdentity& identity);

/// Rows to records and back. A record is: index, content key, every field of the row packed, checksum. The checksum
/// is seeded with the header's and with the record's number in the file, so a record is good only at its own place.
class RecordCodec {
 public:
  explicit RecordCodec(const JournalHeader& header);
  std::size_t size() const { return size_; }
  void encode(const Row& row, std::uint64_t number, std::byte* record) const;
  /// Nothing for a record that is damaged or does not belong to this sweep.
  std::optional<Row> decode(const std::byte* record, std::uint64_t number) const;

 private:
  std::uint64_t checksum(const std::byte* record, std::uint64_t number) const;
  std::vector<Field> fields_;
  std::size_t size_;
  std::uint64_t seed_, rows_;
};

}  // namespace sigmasweep
