#include "store/journal/recover.hpp"

#include <algorithm>
#include <utility>

namespace sigmasweep {
namespace {

constexpr std::size_t records_at_a_time = 4096;

}  // namespace

RecordReader::RecordReader(const File& file, std::string path, const JournalHeader& header, std::vector<Field> fields)
    : file_(file),
      path_(std::move(path)),
      first_(first_record(header)),
      codec_(header, std::move(fields)),
      chunk_(records_at_a_time * codec_.size()) {}

bool RecordReader::read_some(const Visit& visit, const IsWanted& is_wanted) {
  const std::size_t size = codec_.size();
  const std::size_t got = read_at(file_.fd(), chunk_, first_ + number_ * size, path_);
  const std::size_t whole = got / size;
  for (std::size_t i = 0; i < whole; ++i, ++number_) {
    const std::byte* const record = chunk_.data() + i * size;
    if (is_wanted && !is_wanted(RecordCodec::index_of(record))) continue;
    if (const auto row = codec_.decode(record, number_)) {
      visit(*row);
      records_ = number_ + 1;
    } else {
      ++dropped_;
    }
  }
  if (got % size != 0) ++dropped_;
  return got == chunk_.size();
}

void RecordReader::read_all(const Visit& visit) {
  while (read_some(visit)) continue;
}

std::uint64_t precedence_of(const Row& row) {
  return (static_cast<std::uint64_t>(std::max(row.timing.attempt, 0)) << 1 | is_reproducible(row.result.status)) + 1;
}

void keep_one_of_each_index(std::vector<JournalledRow>& rows) {
  const auto index = [](const JournalledRow& found) { return found.row.index; };
  std::ranges::stable_sort(rows, {}, index);
  std::size_t kept = 0;
  for (const JournalledRow& found : rows) {
    if (kept == 0 || index(rows[kept - 1]) != index(found))
      rows[kept++] = found;
    else if (precedence_of(found.row) >= precedence_of(rows[kept - 1].row))
      rows[kept - 1] = found;
  }
  rows.resize(kept);
}

}  // namespace sigmasweep
