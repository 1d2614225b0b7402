#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "sigmasweep/model/row.hpp"

namespace sigmasweep {

/// Rows that are made as they are asked for, so that not all of them need be in memory.
class RowSource {
 public:
  RowSource(std::uint64_t size, std::function<Row(std::uint64_t)> row) : size_(size), row_(std::move(row)) {}
  /// Of rows that stay where they are.
  RowSource(std::span<const Row> rows) : RowSource(rows.size(), [rows](std::uint64_t k) { return rows[k]; }) {}
  RowSource(const std::vector<Row>& rows) : RowSource(std::span(rows)) {}

  std::uint64_t size() const { return size_; }
  Row operator[](std::uint64_t k) const { return row_(k); }

 private:
  std::uint64_t size_;
  std::function<Row(std::uint64_t)> row_;
};

}  // namespace sigmasweep
