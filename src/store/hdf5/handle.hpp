#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>

/// HDF5 identifiers with owners that close them, and HDF5 statuses that throw.
namespace sigmasweep {

/// Keeps HDF5 from printing its errors while it lives; they go into exceptions. Every public function that uses HDF5
/// begins with one.
class Hdf5Session {
 public:
  Hdf5Session();
  ~Hdf5Session();
  Hdf5Session(const Hdf5Session&) = delete;
  Hdf5Session& operator=(const Hdf5Session&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* print_data_ = nullptr;
};

/// Returns `status` unless it is negative, which is HDF5's sign of failure: then throws IoError with `what` and HDF5's
/// own words.
std::int64_t check(std::int64_t status, const std::string& what);

/// Owner of an HDF5 identifier of any kind.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  /// Owns the identifier that an HDF5 call returned. Throws IoError with `what` if the call failed.
  Handle(hid_t id, Close how, const std::string& what) : id_(check(id, what)), close_(how) {}
  ~Handle() { reset(); }
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) noexcept;
  operator hid_t() const { return id_; }
  /// Closes now. Throws IoError with `what`.
  void close(const std::string& what) { check(reset(), what); }

 private:
  herr_t reset() noexcept;
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

}  // namespace sigmasweep
