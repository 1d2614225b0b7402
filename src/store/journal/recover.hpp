#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "store/journal/record.hpp"

namespace sigmasweep {

/// Reads the records of a journal from the first to the last, some thousands at a time, so that memory is bounded.
/// Another process may append at the same moment: a record that is not whole yet is passed over as a torn one.
class RecordReader {
 public:
  using Visit = std::function<void(const JournalledRow&)>;
  using IsWanted = std::function<bool(std::uint64_t index)>;

  /// The file must outlive the object.
  RecordReader(const File& file, std::string path, const JournalHeader& header, std::vector<Field> fields);
  /// Hands on the good ones of the next records in their order; of unwanted ones nothing is looked at but their index.
  /// Returns false when there are no further records. Throws IoError.
  bool read_some(const Visit& visit, const IsWanted& is_wanted = {});

  /// The same with all that are left.
  void read_all(const Visit& visit);

  std::uint64_t records() const { return records_; }  ///< one past the last good record
  std::uint64_t dropped() const { return dropped_; }  ///< number of damaged and torn records

 private:
  const File& file_;
  std::string path_;
  std::uint64_t first_;
  RecordCodec codec_;
  std::vector<std::byte> chunk_;
  std::uint64_t number_ = 0;  ///< of the next record in the file
  std::uint64_t records_ = 0, dropped_ = 0;
};

/// How much a record of a row counts beside other records of that row: the largest number counts, of equal ones the one
/// found last. The last attempt has it; of two copies of one attempt the one with a result that every computation has.
/// Never 0.
std::uint64_t precedence_of(const Row& row);

/// Keeps of each index the row that counts, in order of index.
void keep_one_of_each_index(std::vector<JournalledRow>& rows);

}  // namespace sigmasweep
