#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "store/journal/description.hpp"
#include "store/journal/record.hpp"

namespace sigmasweep {

/// A journal that was opened, with what stands at its beginning.
struct OpenJournal {
  std::string path;
  File file{};
  int error = 0;  ///< errno, where the file cannot be opened
  JournalHeader header{};
  std::size_t header_size = 0;                      ///< the bytes of the header that are there
  std::optional<JournalDescription> description{};  ///< nothing: damaged

  bool is_there() const { return file.is_open(); }
  bool is_ours() const { return sigmasweep::is_ours(header, header_size); }
  /// Why its rows cannot be read; empty if they can. `results` are those of its records if the description is damaged.
  std::string why_unreadable(std::span<const Field> results = {}) const;
  /// The fields of its records, if it is readable.
  std::optional<std::vector<Field>> fields(std::span<const Field> results = {}) const;
};

/// Opens the journal of this path with open(2)'s flags; of a file that is no journal, or that cannot be opened, only
/// what there is. A FIFO of that name is not waited for, and a link not followed. Throws IoError if reading fails.
OpenJournal open_journal(const std::string& path, int flags);

}  // namespace sigmasweep
