#include "store/hdf5/tree.hpp"

#include <algorithm>

#include "sigmasweep/base/errors.hpp"
#include "store/hdf5/open.hpp"

namespace sigmasweep::h5md {
namespace {

Handle property_list(hid_t kind) { return {H5Pcreate(kind), H5Pclose, "cannot make a property list"}; }

void put_attribute(hid_t object, const std::string& name, hid_t type, hid_t space, const void* value) {
  const std::string what = "cannot write attribute " + name;
  Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, what);
  check(H5Awrite(attribute, type, value), what);
  attribute.close(what);
}

Handle scalar() { return {H5Screate(H5S_SCALAR), H5Sclose, "cannot make a data space"}; }

Handle list(hsize_t length) { return {H5Screate_simple(1, &length, nullptr), H5Sclose, "cannot make a data space"}; }

/// The type of a text of fixed length, as H5MD 1.1 wants it; ASCII where that is enough.
Handle text_type(const std::string& text, std::size_t length) {
  const char* const what = "cannot make a text type";
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, what);
  check(H5Tset_size(type, std::max<std::size_t>(length, 1)), what);
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), what);
  const bool ascii = std::ranges::all_of(text, [](unsigned char c) { return c < 0x80; });
  check(H5Tset_cset(type, ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8), what);
  return type;
}

template <class Number>
void put_dataset(hid_t group, const std::string& name, hid_t type, std::span<const Number> values,
                 const std::vector<hsize_t>& extents, const std::string& unit) {
  const std::string what = "cannot write dataset " + name;
  const Handle creation = property_list(H5P_DATASET_CREATE);
  check(H5Pset_obj_track_times(creation, false), what);
  const Handle space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose, what);
  Handle dataset(H5Dcreate2(group, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose, what);
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), what);
  if (!unit.empty()) put_text(dataset, "unit", unit);
  dataset.close(what);
}

}  // namespace

Handle new_file() {
  const Handle access = property_list(H5P_FILE_ACCESS), creation = property_list(H5P_FILE_CREATE);
  constexpr std::size_t growth = std::size_t{1} << 18;
  check(H5Pset_fapl_core(access, growth, /*backing_store=*/false), "cannot choose a file in memory");
  check(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18), "cannot choose a file format");
  check(H5Pset_obj_track_times(creation, false), "cannot leave out times");
  return {H5Fcreate("trajectory", H5F_ACC_TRUNC, creation, access), H5Fclose, "cannot make a file in memory"};
}

/// Not copied by H5Fget_file_image: in HDF5 1.10 that changes a byte of the superblock but not its checksum.
std::vector<std::byte> image_of(hid_t file) {
  const char* const what = "cannot finish a file in memory";
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), what);
  const auto size = check(H5Fget_file_image(file, nullptr, 0), what);
  void* memory = nullptr;  // where the driver keeps the pointer
  check(H5Fget_vfd_handle(file, H5P_DEFAULT, &memory), what);
  const auto* const bytes = *static_cast<std::byte* const*>(memory);
  return {bytes, bytes + size};
}

Handle new_group(hid_t parent, const std::string& name) {
  const Handle creation = property_list(H5P_GROUP_CREATE);
  check(H5Pset_obj_track_times(creation, false), "cannot leave out times");
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose, "cannot make group " + name};
}

void put_text(hid_t object, const std::string& name, const std::string& text) {
  put_attribute(object, name, text_type(text, text.size()), scalar(), text.c_str());
}

void put_texts(hid_t object, const std::string& name, std::span<const std::string> texts) {
  const std::size_t length = std::ranges::max(texts, {}, &std::string::size).size();
  std::string all;
  for (const std::string& text : texts) all += text + std::string(length - text.size(), '\0');
  put_attribute(object, name, text_type(all, length), list(texts.size()), all.c_str());
}

void put_real(hid_t object, const std::string& name, double value) {
  put_attribute(object, name, H5T_NATIVE_DOUBLE, scalar(), &value);
}

void put_whole(hid_t object, const std::string& name, std::int64_t value) {
  put_attribute(object, name, H5T_NATIVE_INT64, scalar(), &value);
}

void put_version(hid_t object, int major, int minor) {
  const int version[] = {major, minor};
  put_attribute(object, "version", H5T_NATIVE_INT, list(2), version);
}

std::vector<std::string> get_texts(hid_t object, const std::string& name) {
  const std::string what = "cannot read attribute " + name;
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, what);
  const Handle type(H5Aget_type(attribute), H5Tclose, what), space(H5Aget_space(attribute), H5Sclose, what);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0)
    throw IoError("attribute " + name + " is not a text of fixed length");
  const auto count = static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space), what));
  const std::size_t length = H5Tget_size(type);
  // HDF5 itself limits attributes to 64 KiB in a file of this version.
  if (count * length > std::size_t{1} << 16) throw IoError("attribute " + name + " is too long");
  std::string all(count * length, '\0');
  check(H5Aread(attribute, type, all.data()), what);
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < count; ++k) {
    const std::string text = all.substr(k * length, length);
    texts.push_back(text.substr(0, text.find('\0')));
  }
  return texts;
}

std::string get_text(hid_t object, const std::string& name) {
  const std::vector<std::string> texts = get_texts(object, name);
  if (texts.size() != 1) throw IoError("attribute " + name + " is not one text");
  return texts.front();
}

void put_array(hid_t group, const std::string& name, std::span<const double> values, std::vector<hsize_t> extents,
               const std::string& unit) {
  put_dataset(group, name, H5T_NATIVE_DOUBLE, values, extents, unit);
}

void put_counts(hid_t group, const std::string& name, std::span<const std::int64_t> values) {
  put_dataset(group, name, H5T_NATIVE_INT64, values, {values.size()}, "");
}

std::vector<double> get_array(hid_t group, const std::string& name, std::vector<hsize_t>& extents) {
  const std::string what = "cannot read dataset " + name;
  const Handle dataset = open_dataset(group, name);
  const Handle type(H5Dget_type(dataset), H5Tclose, what), space(H5Dget_space(dataset), H5Sclose, what);
  std::vector<hsize_t> found(extents.size());
  bool right = H5Tget_class(type) == H5T_FLOAT && H5Sget_simple_extent_ndims(space) == static_cast<int>(extents.size());
  right = right && H5Sget_simple_extent_dims(space, found.data(), nullptr) >= 0;
  std::size_t count = 1;
  constexpr hsize_t most = hsize_t{1} << 40;
  for (std::size_t i = 0; right && i < extents.size(); ++i) {
    right = found[i] > 0 && found[i] <= most / count && (extents[i] == 0 || extents[i] == found[i]);
    count *= found[i];
  }
  if (!right) throw IoError("dataset " + name + " is not of the type or size expected");
  require_stored(dataset, count, H5Tget_size(type));
  extents = found;
  std::vector<double> values(count);
  check(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), what);
  return values;
}

}  // namespace sigmasweep::h5md
