#include "engine/rows/row_collector.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/distribute/wire.hpp"
#include "engine/ledger/identity.hpp"
#include "mpi/exchange.hpp"
#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/sweep/content_key.hpp"

namespace sigmasweep {
namespace {

std::uint64_t row_size(const Sweep& sweep) {
  const PackedRows one(sweep.columns(), std::uint64_t{1});
  return one.results().row_size + one.timings().row_size;
}

}  // namespace

RowCollector::RowCollector(const RankGroup& ranks, const Sweep& sweep, const Slice& slice,
                           std::vector<std::string> journals, Limits limits)
    : ranks_(ranks),
      sweep_(sweep),
      slice_(slice),
      results_(journalled_results(sweep)),
      journals_(std::move(journals)),
      blocks_{slice.size(sweep.size()), static_cast<std::uint64_t>(ranks.size())},
      mine_(blocks_.of(static_cast<std::uint64_t>(ranks.rank()))),
      piece_rows_(std::max<std::uint64_t>(1, limits.piece_bytes / row_size(sweep))),
      pieces_((blocks_.of(0).count + piece_rows_ - 1) / piece_rows_),
      round_bytes_(std::max<std::uint64_t>(std::uint64_t{1} << 16, limits.round_bytes / blocks_.ranks)),
      one_(std::in_place, sweep.columns(), std::uint64_t{1}),
      to_each_(blocks_.ranks) {}

BlockInPieces RowCollector::block() {
  return {mine_.first, mine_.count, pieces_, [this] { return next_piece(); }};
}

PackedBlock RowCollector::next_piece() {
  ranks_.run_collective([&] { begin_piece(); });
  for (std::uint64_t ranks_left = 1; ranks_left > 0;) {
    bool is_left = false;
    ranks_.run_collective([&] { is_left = fill_round(); });
    const std::vector<std::byte> received = exchange(ranks_.comm(), to_each_);
    for (auto& bytes : to_each_) bytes.clear();
    ranks_.run_collective([&] { take(received); });
    ranks_left = ranks_.sum(is_left);
  }
  const auto missing = ranks_.sum(static_cast<std::uint64_t>(std::ranges::count(rank_of_, 0u)));
  ranks_.run_collective([&] {
    if (missing > 0)
      throw IoError(fmt::format("{} rows that were computed are not in the journals any more; run it again", missing));
  });
  return {mine_.first + offset_, *piece_, piece_->size()};
}

void RowCollector::begin_piece() {
  offset_ = std::min(piece_rows_ * next_piece_++, mine_.count);
  const std::uint64_t rows = std::min(piece_rows_, mine_.count - offset_);
  piece_.reset();  // the memory of the one before
  piece_.emplace(sweep_.columns(), rows);
  rank_of_.assign(rows, 0);
  next_journal_ = 0;
}

bool RowCollector::belongs_to_piece(std::uint64_t place) const {
  const std::uint64_t in_block = place - blocks_.of(blocks_.owner(place)).first;
  return in_block / piece_rows_ == next_piece_ - 1;
}

/// Reads until there is enough for a round. Returns whether there is more.
bool RowCollector::fill_round() {
  const auto is_wanted = [this](std::uint64_t index) {
    const auto place = index < sweep_.size() ? slice_.place(index) : std::nullopt;
    return place && *place < blocks_.items && belongs_to_piece(*place);
  };
  while (reader_ || open_next_journal()) {
    if (!reader_->read_some([this](const JournalledRow& found) { put(found); }, is_wanted)) reader_.reset();
    if (std::ranges::any_of(to_each_, [this](const auto& bytes) { return bytes.size() > round_bytes_; })) return true;
  }
  return false;
}

/// Returns false if there is none.
bool RowCollector::open_next_journal() {
  while (next_journal_ < journals_.size()) {
    journal_ = open_journal(journals_[next_journal_++], O_RDONLY);
    const JournalHeader ours = make_header(journal_identity(sweep_, slice_, results_));
    if (!journal_->is_there() || !is_of_same_sweep(journal_->header, ours)) continue;
    auto fields = journal_->fields(results_);
    if (!fields) continue;
    reader_.emplace(journal_->file, journal_->path, journal_->header, *std::move(fields));
    return true;
  }
  return false;
}

/// Puts a row into the message to its owner.
void RowCollector::put(const JournalledRow& found) {
  Row row = found.row;
  row.parameters = sweep_.at(row.index);
  if (content_key(row.parameters) != found.content_key) return;
  const std::uint64_t place = *slice_.place(row.index);
  auto& message = to_each_[blocks_.owner(place)];
  wire::append(message, place);
  wire::append(message, precedence_of(row));
  one_->set(0, row);
  for (const PackedRows::Section* section : {&one_->results(), &one_->timings()})
    message.insert(message.end(), section->bytes.begin(), section->bytes.end());
}

/// Takes rows that have come in to their places.
void RowCollector::take(std::span<const std::byte> rows) {
  while (!rows.empty()) {
    std::uint64_t place = 0, precedence = 0;
    wire::take(rows, place);
    wire::take(rows, precedence);
    const std::uint64_t k = place - mine_.first - offset_;
    if (k >= piece_->size()) throw wire::BadMessage();
    const bool counts = precedence > rank_of_[k];
    if (counts) rank_of_[k] = precedence;
    for (PackedRows::Section* section : {&piece_->results(), &piece_->timings()}) {
      if (rows.size() < section->row_size) throw wire::BadMessage();
      if (counts) std::ranges::copy(rows.first(section->row_size), section->at(k));
      rows = rows.subspan(section->row_size);
    }
  }
}

}  // namespace sigmasweep
