#include "store/journal/recover.hpp"

#include <algorithm>
#include <cstddef>

namespace sigmasweep {
namespace {

/// Keeps one row of each index, the last one, in order of index.
void keep_last_of_each_index(std::vector<Row>& rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.index < b.index; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (i + 1 == rows.size() || rows[i + 1].index != rows[i].index) rows[kept++] = rows[i];
  rows.resize(kept);
}

}  // namespace

RecoveredRecords recover_records(const File& file, const std::string& path, const JournalHeader& header,
                                 const std::function<void(const Row&)>& visit) {
  const RecordCodec codec(header);
  const std::size_t record_size = codec.size();
  RecoveredRecords recovered;
  std::vector<std::byte> chunk(4096 * record_size);
  std::uint64_t number = 0;  // of the record in the file
  std::size_t got = 0;
  do {
    got = read_at(file.fd(), chunk, first_record(header) + number * record_size, path);
    const std::size_t whole = got / record_size;
    for (std::size_t i = 0; i < whole; ++i, ++number) {
      if (const auto row = codec.decode(chunk.data() + i * record_size, number)) {
        visit(*row);
        recovered.records = number + 1;
      } else {
        ++recovered.dropped;
      }
    }
    if (got % record_size != 0) ++recovered.dropped;
  } while (got == chunk.size());
  return recovered;
}

std::vector<Row> recover_rows(const File& file, const std::string& path, const JournalHeader& header) {
  std::vector<Row> rows;
  recover_records(file, path, header, [&](const Row& row) { rows.push_back(row); });
  keep_last_of_each_index(rows);
  return rows;
}

}  // namespace sigmasweep
