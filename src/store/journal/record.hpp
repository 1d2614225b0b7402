#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/row.hpp"

/// The bytes of a journal: one header, the description of the sweep (description.hpp), then records of one size.
/// Numbers are stored as the machine has them, because a journal is finished on machines of the kind where it was
/// begun. Records have no parameters, which follow from the spec and the number of the row. Those of format 2, which
/// this program reads but does not write, have all parameters and all results.
namespace sigmasweep {

inline constexpr std::uint32_t journal_format_version = 3, journal_format_with_parameters = 2;

/// The sweep that a journal belongs to. A journal of another identity is never used and never overwritten silently.
struct JournalIdentity {
  std::uint64_t spec_hash = 0;
  std::uint32_t physics_version = 0;
  std::uint64_t rows = 0;
  std::span<const Field> results{};  ///< that a record has; empty: all result_fields()
};

/// A row as a journal has it: with the default parameters instead of its own, which are those of the spec's row if they
/// have this content key.
struct JournalledRow {
  Row row;
  std::uint64_t content_key = 0;
};

/// The first bytes of a journal.
struct JournalHeader {
  std::uint64_t magic = 0;
  std::uint32_t format_version = 0;
  std::uint32_t record_size = 0;
  std::uint64_t layout = 0;  ///< hash of the names and types of the fields in a record
  std::uint64_t spec_hash = 0;
  std::uint64_t rows = 0;
  std::uint32_t physics_version = 0;
  std::uint32_t build =
      0;  ///< hash of compiler, its options and the program's version: the last digits depend on these
  std::uint64_t description_size = 0;      ///< bytes between header and records
  std::uint64_t description_checksum = 0;  ///< xxh3 of them
  std::uint64_t checksum = 0;              ///< xxh3 of all before
};

/// The header of this program's journal for the sweep, with the text that describes it.
JournalHeader make_header(const JournalIdentity& identity, std::string_view description = {});

/// Where the first record stands in the file.
std::uint64_t first_record(const JournalHeader& header);

/// Whether the bytes are the beginning of a journal of sigmasweep, of whatever version and sweep.
bool is_ours(const JournalHeader& found, std::size_t size);

/// Whether both are journals of one sweep, whose rows this program may mix.
bool is_of_same_sweep(const JournalHeader& a, const JournalHeader& b);

/// The fields of a record, if it has these results; nothing if that is not what the header tells.
std::optional<std::vector<Field>> record_fields(const JournalHeader& header, std::span<const Field> results);

/// Whether the text is the one that belongs to the header.
bool is_description_of(const JournalHeader& header, std::string_view description);

/// Why a journal is not readable whose records have fields that this program does not know.
inline constexpr const char* other_fields =
    "is a journal of another version of sigmasweep (its rows hold other fields)";

/// Why a file whose first `size` bytes are `found` is not a journal that this program can read, whatever the sweep;
/// empty if it is one.
std::string why_unreadable(const JournalHeader& found, std::size_t size);

/// Why a file whose first `size` bytes are `found` is not a journal of the sweep; empty if it is one.
std::string why_unusable(const JournalHeader& found, std::size_t size, const JournalIdentity& identity);

/// Makes records of rows and rows of records. A record consists of index, content key, fields of the row packed, and
/// checksum. The checksum is seeded with that of the header and with the number of the record in the file, so that a
/// record is valid only at its own place.
class RecordCodec {
 public:
  /// `fields` as record_fields() has them.
  RecordCodec(const JournalHeader& header, std::vector<Field> fields);
  std::size_t size() const { return size_; }
  void encode(const Row& row, std::uint64_t content_key, std::uint64_t number, std::byte* record) const;
  /// The row of a record; nothing if the record is damaged or does not belong to this sweep.
  std::optional<JournalledRow> decode(const std::byte* record, std::uint64_t number) const;
  /// The index of a record's row, which may be damaged.
  static std::uint64_t index_of(const std::byte* record);

 private:
  std::uint64_t checksum(const std::byte* record, std::uint64_t number) const;
  std::vector<Field> fields_;
  std::size_t size_;
  std::uint64_t seed_, rows_;
};

}  // namespace sigmasweep
