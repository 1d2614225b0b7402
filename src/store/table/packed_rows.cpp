#include "store/table/packed_rows.hpp"

#include <algorithm>
#include <utility>

#include "model/packing.hpp"

namespace sigmasweep {

PackedRows::Section::Section(std::span<const Field> of, std::uint64_t rows)
    : fields(of.begin(), of.end()), row_size(packed_size(of)), bytes(rows * row_size) {}

PackedRows::PackedRows(std::span<const Field> columns, std::uint64_t rows)
    : rows_(rows), results_(columns, rows), timings_(timing_fields(), rows) {
  const Row nothing;
  for (Section* section : {&results_, &timings_}) {
    std::vector<std::byte> packed(section->row_size);
    pack(section->fields, nothing, packed.data());
    for (std::uint64_t k = 0; k < rows; ++k) std::ranges::copy(packed, section->at(k));
  }
}

PackedRows::PackedRows(std::span<const Field> columns, std::span<const Row> rows)
    : rows_(rows.size()), results_(columns, rows.size()), timings_(timing_fields(), rows.size()) {
  for (std::uint64_t k = 0; k < rows_; ++k) set(k, rows[k]);
}

void PackedRows::set(std::uint64_t k, const Row& row) {
  pack(results_.fields, row, results_.at(k));
  pack(timings_.fields, row, timings_.at(k));
}

void PackedRows::get(std::uint64_t k, Row& row) const {
  unpack(results_.fields, results_.at(k), row);  // what set() has packed has names
  unpack(timings_.fields, timings_.at(k), row);
}

PackedBlock::PackedBlock(std::uint64_t first_place, const PackedRows& packed, std::uint64_t count)
    : first(first_place), rows(count) {
  for (std::size_t i = 0; const PackedRows::Section* section : {&packed.results(), &packed.timings()})
    sections[i++] = std::span(section->bytes).first(count * section->row_size);
}

BlockInPieces::BlockInPieces(std::uint64_t first_place, std::uint64_t count, std::uint64_t number_of_pieces,
                             std::function<PackedBlock()> next_piece)
    : first(first_place), rows(count), pieces(number_of_pieces), next(std::move(next_piece)) {}

BlockInPieces::BlockInPieces(const PackedBlock& whole)
    : BlockInPieces(whole.first, whole.rows, 1, [whole] { return whole; }) {}

}  // namespace sigmasweep
