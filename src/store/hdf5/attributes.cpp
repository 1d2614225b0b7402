#include "store/hdf5/attributes.hpp"

#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/handle.hpp"

namespace sigmasweep {
namespace {

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "cannot make a text type");
  // Of variable size: a fixed size ends at 64 KiB, and is no str in h5py.
  check(H5Tset_size(type, H5T_VARIABLE), "cannot make a text type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "cannot make a text type");
  return type;
}

void write(hid_t object, const std::string& name, hid_t type, const void* value) {
  const std::string what = "cannot write attribute " + name;
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, what);
  Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, what);
  check(H5Awrite(attribute, type, value), what);
  attribute.close(what);
}

/// Opens a scalar attribute whose type is of this class.
Handle open(hid_t object, const std::string& name, H5T_class_t wanted) {
  const std::string what = "cannot read attribute " + name;
  Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, what);
  const Handle type(H5Aget_type(attribute), H5Tclose, what);
  const Handle space(H5Aget_space(attribute), H5Sclose, what);
  const bool scalar = H5Sget_simple_extent_npoints(space) == 1;
  const bool right = H5Tget_class(type) == wanted && (wanted != H5T_STRING || H5Tis_variable_str(type) > 0);
  if (!scalar || !right) throw IoError("attribute " + name + " is not of the type expected");
  return attribute;
}

}  // namespace

void write_text(hid_t object, const std::string& name, const std::string& text) {
  const char* characters = text.c_str();
  write(object, name, text_type(), &characters);
}

void replace_text(hid_t object, const std::string& name, const std::string& text) {
  const std::string what = "cannot write attribute " + name;
  const char* characters = text.c_str();
  Handle attribute = open(object, name, H5T_STRING);
  check(H5Awrite(attribute, text_type(), &characters), what);
  attribute.close(what);
}

void write_number(hid_t object, const std::string& name, std::uint64_t number) {
  write(object, name, H5T_NATIVE_UINT64, &number);
}

std::string read_text(hid_t object, const std::string& name) {
  const Handle attribute = open(object, name, H5T_STRING);
  const Handle type(H5Aget_type(attribute), H5Tclose, "cannot read attribute " + name);
  // Read in the file's own character set, because HDF5 does not convert between character sets.
  const Handle memory(H5Tcopy(type), H5Tclose, "cannot read attribute " + name);
  char* characters = nullptr;
  check(H5Aread(attribute, memory, &characters), "cannot read attribute " + name);
  std::string text = characters != nullptr ? characters : "";
  check(H5free_memory(characters), "cannot free memory");
  return text;
}

std::uint64_t read_number(hid_t object, const std::string& name) {
  const Handle attribute = open(object, name, H5T_INTEGER);
  std::uint64_t number = 0;
  check(H5Aread(attribute, H5T_NATIVE_UINT64, &number), "cannot read attribute " + name);
  return number;
}

}  // namespace sigmasweep
