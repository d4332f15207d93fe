#include "core/storage/hdf5_file.h"

#include <algorithm>

namespace stillcut::record {
namespace {

constexpr std::size_t kLongestText = 64U << 20U;

herr_t keepDescription(unsigned depth, const H5E_error2_t* error, void* out) {
  // Innermost first: the first description is the cause, all others are consequences.
  if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(out) = error->desc;
  return 0;
}

template <class T>
bool writeScalar(hid_t object, const char* name, hid_t type, const T* value) {
  const Hdf5Id space(H5Screate(H5S_SCALAR));
  const Hdf5Id attribute(H5Acreate2(object, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT));
  return attribute && H5Awrite(attribute.get(), type, value) >= 0;
}

bool isScalar(hid_t attribute) {
  const Hdf5Id space(H5Aget_space(attribute));
  return space && H5Sget_simple_extent_npoints(space.get()) == 1;
}

template <class T>
std::optional<T> readScalar(hid_t object, const char* name, hid_t type) {
  if (H5Aexists(object, name) <= 0) return std::nullopt;
  const Hdf5Id attribute(H5Aopen(object, name, H5P_DEFAULT));
  T value{};
  if (!attribute || !isScalar(attribute.get()) || H5Aread(attribute.get(), type, &value) < 0) return std::nullopt;
  return value;
}

}  // namespace

bool Hdf5Id::reset() {
  const hid_t id = std::exchange(id_, H5I_INVALID_HID);
  if (id < 0) return true;
  switch (H5Iget_type(id)) {
    case H5I_FILE:
      return H5Fclose(id) >= 0;
    case H5I_GROUP:
      return H5Gclose(id) >= 0;
    case H5I_DATATYPE:
      return H5Tclose(id) >= 0;
    case H5I_DATASPACE:
      return H5Sclose(id) >= 0;
    case H5I_DATASET:
      return H5Dclose(id) >= 0;
    case H5I_ATTR:
      return H5Aclose(id) >= 0;
    case H5I_GENPROP_LST:
      return H5Pclose(id) >= 0;
    default:
      return H5Idec_ref(id) >= 0;
  }
}

void quietHdf5() {
  thread_local bool quiet = false;
  if (!quiet) H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  quiet = true;
}

Message hdf5Cause() {
  std::string cause;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keepDescription, &cause);
  std::replace(cause.begin(), cause.end(), '\n', ' ');
  return cause.empty() ? Message() : message("HDF5: %1", cause);
}

bool writeText(hid_t object, const char* name, const std::string& text) {
  const Hdf5Id type(H5Tcopy(H5T_C_S1));
  // One byte more than the text: HDF5 knows no strings of length zero.
  if (H5Tset_size(type.get(), text.size() + 1) < 0 || H5Tset_cset(type.get(), H5T_CSET_UTF8) < 0) return false;
  return writeScalar(object, name, type.get(), text.c_str());
}

bool writeNumber(hid_t object, const char* name, double value) {
  return writeScalar(object, name, H5T_NATIVE_DOUBLE, &value);
}

bool writeInteger(hid_t object, const char* name, std::int64_t value) {
  return writeScalar(object, name, H5T_NATIVE_INT64, &value);
}

std::optional<std::string> readText(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return std::nullopt;
  const Hdf5Id attribute(H5Aopen(object, name, H5P_DEFAULT));
  if (!attribute || !isScalar(attribute.get())) return std::nullopt;
  const Hdf5Id type(H5Aget_type(attribute.get()));
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0) return std::nullopt;
  const std::size_t size = H5Tget_size(type.get());
  if (size == 0 || size > kLongestText) return std::nullopt;
  std::string text(size, '\0');
  if (H5Aread(attribute.get(), type.get(), text.data()) < 0) return std::nullopt;
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

std::optional<double> readNumber(hid_t object, const char* name) {
  return readScalar<double>(object, name, H5T_NATIVE_DOUBLE);
}

std::optional<std::int64_t> readInteger(hid_t object, const char* name) {
  return readScalar<std::int64_t>(object, name, H5T_NATIVE_INT64);
}

std::optional<std::uint64_t> lengthOf(hid_t dataset) {
  const Hdf5Id space(H5Dget_space(dataset));
  hsize_t length = 0;
  if (!space || H5Sget_simple_extent_ndims(space.get()) != 1) return std::nullopt;
  if (H5Sget_simple_extent_dims(space.get(), &length, nullptr) < 0) return std::nullopt;
  return length;
}

}  // namespace stillcut::record
