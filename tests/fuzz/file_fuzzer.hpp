#pragma once

#include <cstdint>
#include <string>

#include "sigmasweep/base/errors.hpp"
#include "support/store_samples.hpp"

namespace sigmasweep::fuzz {

/// Lets a reader of files have these bytes. Without its seal a file gets past the first look, so that half of the
/// inputs lose theirs. The reader may refuse the file; nothing else may happen.
template <class Read>
void read_file(const std::uint8_t* data, std::size_t size, Read read) {
  static const samples::Directory directory;
  static const std::string path = directory.file("file.h5");
  constexpr std::size_t seal = 16;
  const bool keeps_seal = size == 0 || data[size - 1] % 2 == 0;
  std::string bytes(reinterpret_cast<const char*>(data), size);
  if (!keeps_seal && size > seal) bytes.resize(size - seal);
  samples::put_bytes(path, bytes);
  try {
    read(path);
  } catch (const Error&) {
  }
}

}  // namespace sigmasweep::fuzz
