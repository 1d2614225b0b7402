#pragma once

#include <string>
#include <vector>

/// The names of a sweep's journals. Rank 0 writes TABLE.h5.journal, rank 7 writes TABLE.h5.journal.7: a file has one
/// writer, so that no file system need keep writers apart. Which rank wrote a row is of no importance to those who read
/// it.
namespace sigmasweep {

std::string journal_of_rank(const std::string& table_path, int rank);

/// The other ranks whose journals are there, ascending.
std::vector<int> other_ranks_with_journals(const std::string& table_path);

/// The journals of all ranks that are there, in the order of ranks.
std::vector<std::string> journals_beside(const std::string& table_path);

}  // namespace sigmasweep
