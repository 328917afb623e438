#pragma once

// The one place where HDF5's C API meets C++: every handle closes itself, every failure becomes an
// exception whose message is the innermost cause of HDF5's error stack.

#include <hdf5.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

namespace ar3d {

class Hdf5Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// @throws Hdf5Error "cannot <what>: <innermost cause>".
[[noreturn]] void throw_hdf5_error(const char* what);

/// Passes a result of the C API through. @throws Hdf5Error if it is negative.
template <class Result>
Result hdf5_checked(Result result, const char* what) {
  if (result < 0) throw_hdf5_error(what);
  return result;
}

/// Owns one HDF5 identifier.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  /// @throws Hdf5Error if id is negative, that is: if the call that made it failed.
  Hdf5Handle(hid_t id, Close close, const char* what)
      : id_(hdf5_checked(id, what)), close_(close) {}
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;

  hid_t get() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// Writes an attribute of an object: a UTF-8 string, or a 64-bit integer.
void write_attribute(hid_t object, const std::string& name, const std::string& value);
void write_attribute(hid_t object, const std::string& name, long long value);
/// @throws Hdf5Error if it is missing or of another type.
std::string read_text_attribute(hid_t object, const std::string& name);
long long read_integer_attribute(hid_t object, const std::string& name);

/// Returns a fixed-size, null-padded string type of `size` >= 1 bytes.
Hdf5Handle text_type(std::size_t size, H5T_cset_t charset);

/// Writes an HDF5 file into an open, empty, readable and writable one: calls fill(the file). HDF5
/// never sees a write fail: it would not give the file up. The first failure is kept here instead,
/// what comes after it is dropped.
/// @return 0, or the errno of the first write that failed.
int write_hdf5_file(int descriptor, const std::function<void(hid_t file)>& fill);

}  // namespace ar3d
