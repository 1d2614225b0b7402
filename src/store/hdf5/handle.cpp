#include "store/hdf5/handle.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "sigmasweep/base/errors.hpp"

namespace sigmasweep {
namespace {

/// HDF5 is opened before main(), and so before MPI_Init. Otherwise HDF5 ties its own end to MPI_Finalize and to the end
/// of the program; there HDF5 1.10 crashes if a file could not be closed before (disk full), and message and exit code
/// are lost.
const herr_t started = H5dont_atexit() < 0 ? -1 : H5open();

/// HDF5's description of its last failure: the outermost and the innermost message.
std::string last_error() {
  std::vector<std::string> descriptions;
  const auto collect = [](unsigned, const H5E_error2_t* error, void* list) -> herr_t {
    if (error->desc != nullptr) static_cast<std::vector<std::string>*>(list)->emplace_back(error->desc);
    return 0;
  };
  if (H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, collect, &descriptions) < 0 || descriptions.empty())
    return "HDF5 gives no reason";
  const auto& inner = descriptions.back();
  return descriptions.front() == inner ? inner : fmt::format("{} ({})", descriptions.front(), inner);
}

}  // namespace

Hdf5Session::Hdf5Session() {
  check(started, "cannot start HDF5");
  check(H5Eget_auto2(H5E_DEFAULT, &print_, &print_data_), "cannot ask HDF5 how it prints errors");
  check(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr), "cannot keep HDF5 from printing errors");
}

Hdf5Session::~Hdf5Session() { H5Eset_auto2(H5E_DEFAULT, print_, print_data_); }

std::int64_t check(std::int64_t status, const std::string& what) {
  if (status < 0) throw IoError(fmt::format("{}: {}", what, last_error()));
  return status;
}

Handle::Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}

Handle& Handle::operator=(Handle&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(close_, other.close_);
  return *this;
}

herr_t Handle::reset() noexcept {
  const hid_t id = std::exchange(id_, H5I_INVALID_HID);
  return id >= 0 ? close_(id) : 0;
}

}  // namespace sigmasweep
