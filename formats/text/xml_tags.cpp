#include "ar3d/formats/text/xml_tags.h"

namespace ar3d {
namespace {
constexpr std::size_t kNowhere = std::string_view::npos;
}

bool XmlTags::skip_past(std::string_view terminator) {
  const std::size_t found = text_.find(terminator, at_);
  at_ = found == kNowhere ? text_.size() : found + terminator.size();
  return found != kNowhere;
}

/// Behind the '>' that is not inside a quoted value.
std::size_t XmlTags::end_of_tag() const {
  char quote = 0;
  for (std::size_t i = at_; i < text_.size(); ++i) {
    const char c = text_[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return i + 1;
    }
  }
  return kNowhere;
}

std::optional<XmlTag> XmlTags::next() {
  for (;;) {
    at_ = text_.find('<', at_);
    if (at_ == kNowhere) break;
    const std::string_view rest = text_.substr(at_);
    if (rest.starts_with("<!--")) {
      if (!skip_past("-->")) break;
    } else if (rest.starts_with("<![CDATA[")) {
      if (!skip_past("]]>")) break;
    } else if (rest.starts_with("<?")) {
      if (!skip_past("?>")) break;
    } else if (rest.starts_with("<!")) {
      if (!skip_past(">")) break;
    } else {
      const std::size_t end = end_of_tag();
      if (end == kNowhere) break;
      const bool close = rest.starts_with("</");
      const std::size_t name = at_ + (close ? 2 : 1);
      const std::size_t name_end = text_.find_first_of(" \t\r\n/>", name);
      XmlTag tag{close                   ? XmlTag::Kind::close
                 : text_[end - 2] == '/' ? XmlTag::Kind::empty
                                         : XmlTag::Kind::open,
                 text_.substr(name, name_end - name), at_, end};
      at_ = end;
      return tag;
    }
  }
  at_ = text_.size();
  return std::nullopt;
}

std::optional<std::string_view> attribute_of(std::string_view tag, std::string_view name) {
  constexpr std::string_view kSpace = " \t\r\n";
  std::size_t at = tag.find_first_of(kSpace);
  while (at != kNowhere) {
    const std::size_t begin = tag.find_first_not_of(kSpace, at);
    const std::size_t quote = tag.find_first_of("\"'", at);
    if (begin == kNowhere || quote == kNowhere) break;
    const std::size_t end = tag.find(tag[quote], quote + 1);
    if (end == kNowhere) break;
    const std::string_view found = tag.substr(begin, tag.find_first_of(" \t\r\n=", begin) - begin);
    if (found == name) return tag.substr(quote + 1, end - quote - 1);
    at = end + 1;
  }
  return std::nullopt;
}

}  // namespace ar3d
