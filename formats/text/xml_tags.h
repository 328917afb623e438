#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace ar3d {

/// A tag of an XML text: text[begin, end) is "<name …>", "</name>" or "<name …/>".
struct XmlTag {
  enum class Kind { open, close, empty };
  Kind kind = Kind::open;
  std::string_view name;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The value of an attribute of a tag as it is written (without quotes, entities left); nothing
/// without it.
std::optional<std::string_view> attribute_of(std::string_view tag, std::string_view name);

/// Finds the tags of an XML text one after the other; comments, CDATA and processing instructions
/// are passed over. It checks nothing: it is there to know where elements stand before and after a
/// real parser reads them.
class XmlTags {
 public:
  explicit XmlTags(std::string_view text) : text_(text) {}
  /// The next tag; nothing at the end of the text or where a tag is cut.
  std::optional<XmlTag> next();

 private:
  bool skip_past(std::string_view terminator);
  std::size_t end_of_tag() const;

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace ar3d
