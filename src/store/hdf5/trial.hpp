#pragma once

#include <functional>
#include <string>

/// HDF5 1.10 itself crashes over some damage, or never comes to an end. A seal tells of damage before HDF5 sees it, but
/// files that other programs made or changed have none. These are read twice: by a child process first.
namespace sigmasweep {

/// Lets a child process call `read` where the file has no seal. Throws IoError if the child crashes or takes too long.
/// An Error that `read` throws there is not passed on: the caller meets it again. Files that cannot be opened are the
/// caller's as well.
void try_unsealed(const std::string& path, const std::function<void()>& read);

/// What `read` returns, after a trial.
template <class Read>
auto read_after_trial(const std::string& path, Read read) {
  try_unsealed(path, [&read] { read(); });
  return read();
}

}  // namespace sigmasweep
