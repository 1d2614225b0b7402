#include "store/hdf5/long_text.hpp"

#include <cstdint>

#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/attributes.hpp"
#include "store/hdf5/handle.hpp"
#include "store/hdf5/open.hpp"

namespace sigmasweep {
namespace {

constexpr std::size_t longest_attribute = 60'000, longest_text = std::size_t{16} << 20;

Handle text_type(std::size_t size) {
  const char* const what = "cannot make a text type";
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, what);
  check(H5Tset_size(type, size), what);
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), what);
  check(H5Tset_cset(type, H5T_CSET_UTF8), what);
  return type;
}

}  // namespace

void create_long_text(hid_t object, const std::string& name, const std::string& text) {
  if (text.size() <= longest_attribute) return write_text(object, name, text);
  const std::string what = "cannot write dataset " + name;
  const Handle type = text_type(text.size()), space(H5Screate(H5S_SCALAR), H5Sclose, what);
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, what);
  check(H5Pset_obj_track_times(creation, false), what);
  check(H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY), what);
  check(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER), what);
  Handle dataset(H5Dcreate2(object, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose, what);
  dataset.close(what);
}

void fill_long_text(hid_t object, const std::string& name, const std::string& text) {
  if (text.size() <= longest_attribute) return;
  const std::string what = "cannot write dataset " + name;
  Handle dataset = open_dataset(object, name);
  check(H5Dwrite(dataset, text_type(text.size()), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), what);
  dataset.close(what);
}

std::string read_long_text(hid_t object, const std::string& name) {
  const std::string what = "cannot read " + name;
  if (check(H5Aexists(object, name.c_str()), what) > 0) return read_text(object, name);
  const Handle dataset = open_dataset(object, name);
  const Handle type(H5Dget_type(dataset), H5Tclose, what), space(H5Dget_space(dataset), H5Sclose, what);
  const std::size_t size = H5Tget_size(type);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 || size == 0 || size > longest_text ||
      H5Sget_simple_extent_npoints(space) != 1 || H5Dget_storage_size(dataset) == 0)
    throw IoError(name + " is not a text");
  std::string text(size, '\0');
  check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), what);
  return text;
}

}  // namespace sigmasweep
