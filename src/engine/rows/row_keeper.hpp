#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <span>

#include "engine/ledger/attempts.hpp"
#include "sigmasweep/model/row.hpp"
#include "store/journal/file.hpp"

namespace sigmasweep {

/// Keeps the rows that this rank computes in this rank's journal. One thread gives it rows; others may ask whether it
/// has failed.
class RowKeeper {
 public:
  /// `journal` must outlive the object. If there is no file yet, the first row begins it. `attempts` are those at rows
  /// that were tried before.
  RowKeeper(JournalFile& journal, Attempts attempts);

  /// Sets the rows' attempts, and appends the rows. Returns false if this or an earlier call has failed: then the rows
  /// are not to be called done.
  bool keep(std::span<Row> rows) noexcept;
  /// Whether nothing can be kept any more, because of a failed write or sync.
  bool has_failed() noexcept;
  /// Brings the rows to the disk. Throws what went wrong. Not while another thread keeps rows.
  void finish();

 private:
  template <class Step>
  bool attempt(Step step) noexcept;

  JournalFile& journal_;
  Attempts attempts_;
  std::mutex mutex_;  ///< of the journal and the error
  std::exception_ptr error_;
  std::atomic<bool> failed_ = false;
};

}  // namespace sigmasweep
