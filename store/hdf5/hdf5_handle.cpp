// HDF5's C interface with owners for its identifiers and exceptions for its errors. The innermost
// message of HDF5's stack is kept, because the outer ones say nothing.
#include <fmt/format.h>

#include <algorithm>

#include "ar3d/store/hdf5/hdf5_table.h"
#include "ar3d/store/hdf5/results_file.h"

namespace ar3d {
namespace {

constexpr std::size_t kLargestAttribute = 1 << 20;  // bytes of an attribute

// Called from the outermost to the innermost entry: the last one stays.
herr_t keep_description(unsigned, const H5E_error2_t* entry, void* data) {
  if (entry->desc != nullptr && *entry->desc != '\0')
    *static_cast<std::string*>(data) = entry->desc;
  return 0;
}

Hdf5Handle create_attribute(hid_t object, const std::string& name, hid_t type) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create a scalar");
  return {H5Acreate2(object, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
          "create an attribute"};
}

Hdf5Handle open_attribute(hid_t object, const std::string& name) {
  if (hdf5_checked(H5Aexists(object, name.c_str()), "look for an attribute") == 0) {
    throw Hdf5Error("attribute '" + name + "' is missing");
  }
  return {H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "open an attribute"};
}

}  // namespace

std::string hdf5_version() {
  unsigned major = 0;
  unsigned minor = 0;
  unsigned release = 0;
  hdf5_checked(H5get_libversion(&major, &minor, &release), "tell its version");
  return fmt::format("{}.{}.{}", major, minor, release);
}

void throw_hdf5_error(const char* what) {
  std::string cause = "unknown cause";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_description, &cause);
  H5Eclear2(H5E_DEFAULT);
  throw Hdf5Error(std::string("cannot ") + what + ": " + cause);
}

Hdf5Handle text_type(std::size_t size, H5T_cset_t charset) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "copy a type");
  hdf5_checked(H5Tset_size(type.get(), size), "size a string");
  hdf5_checked(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "pad a string");
  hdf5_checked(H5Tset_cset(type.get(), charset), "set a character set");
  return type;
}

void write_attribute(hid_t object, const std::string& name, const std::string& value) {
  const Hdf5Handle type = text_type(std::max<std::size_t>(1, value.size()), H5T_CSET_UTF8);
  const Hdf5Handle attribute = create_attribute(object, name, type.get());
  std::string padded = value;
  padded.resize(std::max<std::size_t>(1, value.size()), '\0');
  hdf5_checked(H5Awrite(attribute.get(), type.get(), padded.data()), "write an attribute");
}

void write_attribute(hid_t object, const std::string& name, long long value) {
  const Hdf5Handle attribute = create_attribute(object, name, H5T_STD_I64LE);
  hdf5_checked(H5Awrite(attribute.get(), H5T_NATIVE_LLONG, &value), "write an attribute");
}

std::string read_text_attribute(hid_t object, const std::string& name) {
  const Hdf5Handle attribute = open_attribute(object, name);
  const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose, "read an attribute's type");
  const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose, "read an attribute's shape");
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0 ||
      H5Sget_simple_extent_npoints(space.get()) != 1 ||
      H5Tget_size(type.get()) > kLargestAttribute) {
    throw Hdf5Error("attribute '" + name + "' is not one fixed-size string");
  }
  std::string text(H5Tget_size(type.get()), '\0');
  hdf5_checked(H5Aread(attribute.get(), type.get(), text.data()), "read an attribute");
  text.resize(std::min(text.size(), text.find('\0')));
  return text;
}

long long read_integer_attribute(hid_t object, const std::string& name) {
  const Hdf5Handle attribute = open_attribute(object, name);
  const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose, "read an attribute's type");
  const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose, "read an attribute's shape");
  if (H5Tequal(type.get(), H5T_STD_I64LE) <= 0 || H5Sget_simple_extent_npoints(space.get()) != 1) {
    throw Hdf5Error("attribute '" + name + "' is not one 64-bit integer");
  }
  long long value = 0;
  hdf5_checked(H5Aread(attribute.get(), H5T_NATIVE_LLONG, &value), "read an attribute");
  return value;
}

}  // namespace ar3d
