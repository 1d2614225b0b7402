#include "engine/rows/row_keeper.hpp"

#include <utility>

namespace sigmasweep {

RowKeeper::RowKeeper(JournalFile& journal, Attempts attempts) : journal_(journal), attempts_(std::move(attempts)) {}

template <class Step>
bool RowKeeper::attempt(Step step) noexcept {
  try {
    if (!failed_) step();
  } catch (...) {
    error_ = std::current_exception();
    failed_ = true;
  }
  return !failed_;
}

bool RowKeeper::keep(std::span<Row> rows) noexcept {
  const std::lock_guard lock(mutex_);
  return attempt([&] {
    if (rows.empty()) return;
    for (Row& row : rows) row.timing.attempt = next_attempt(attempts_, row.index);
    if (!journal_.is_there()) journal_.begin_alone();
    journal_.append(rows);
  });
}

bool RowKeeper::has_failed() noexcept {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock) attempt([&] { journal_.check(); });
  return failed_;
}

void RowKeeper::finish() {
  if (error_) std::rethrow_exception(error_);
  journal_.sync();
}

}  // namespace sigmasweep
