#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>

#include "store/journal/journal.hpp"
#include "support/store_samples.hpp"

/// A journal in a directory of its own, for tests.
namespace sigmasweep {

inline constexpr JournalIdentity identity{.spec_hash = 0x1234567890abcdef, .physics_version = 7, .rows = 5000};
inline constexpr std::size_t head_size = 72;  // the header alone; the description of the sweep follows

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class JournalTest : public testing::Test {
 protected:
  samples::Directory directory;
  std::string table = directory.file("t.h5"), path = directory.file("t.h5.journal");
  const std::size_t header_size = size_without_records();  // description included

  void write(std::initializer_list<std::uint64_t> indices) {
    Journal journal(table, identity, true);
    for (const auto index : indices) journal.append(samples::row(index));
  }
  std::size_t size_without_records() const {
    Journal journal(table, identity, true);
    const std::size_t size = samples::bytes_of(path).size();
    journal.remove();
    return size;
  }
  std::size_t record_size() {
    write({0});
    return samples::bytes_of(path).size() - header_size;
  }
};

}  // namespace sigmasweep
