#include "core/formats/text/xml_scan.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <utility>
#include <vector>

#include "core/formats/utf_text.h"

namespace stillcut::record {
namespace {

constexpr int kNone = -1;

std::string letterOf(std::uint32_t code) {
  if (code < 0x10000U) {
    const std::uint16_t one = static_cast<std::uint16_t>(code);
    return fromUtf16({&one, 1});
  }
  const std::uint32_t rest = code - 0x10000U;
  const std::array<std::uint16_t, 2> pair{static_cast<std::uint16_t>(0xD800U | (rest >> 10U & 0x3FFU)),
                                          static_cast<std::uint16_t>(0xDC00U | (rest & 0x3FFU))};
  return fromUtf16(pair);
}

}  // namespace

int XmlScan::get() {
  if (at_ == filled_) {
    const std::size_t now = static_cast<std::size_t>(std::min<std::uint64_t>(left_, buffer_.size()));
    if (now == 0) return kNone;
    if (!stream_->read(std::span(buffer_).first(now))) {
      broken_ = true;
      left_ = 0;
      return kNone;
    }
    left_ -= now;
    filled_ = now;
    at_ = 0;
  }
  return buffer_[at_++];
}

// From behind '<' to behind '>'; what stands between quotes may hold either.
bool XmlScan::readTag() {
  tag_.clear();
  int quote = 0;
  for (int c = get(); c != kNone; c = get()) {
    if (quote == 0 && c == '>') {
      if (!tag_.starts_with("!--") || tag_.ends_with("--")) return true;
    }
    if (quote != 0 && c == quote) {
      quote = 0;
    } else if (quote == 0 && (c == '"' || c == '\'') && !tag_.starts_with("!--")) {
      quote = c;
    }
    tag_ += static_cast<char>(c);
    if (tag_.size() > kLongest) break;
  }
  broken_ = true;
  return false;
}

XmlScan::Kind XmlScan::next() {
  if (std::exchange(closes_, false)) return Kind::Close;
  text_.clear();
  while (true) {
    const int c = get();
    if (c == kNone) return broken_ ? Kind::Damaged : text_.empty() ? Kind::End : Kind::Text;
    if (c != '<') {
      text_ += static_cast<char>(c);
      if (text_.size() > kLongest) return Kind::Damaged;
      continue;
    }
    if (!text_.empty()) {
      --at_;  // the tag comes next time; its '<' is in the buffer
      text_ = resolvedEntities(text_);
      return Kind::Text;
    }
    if (!readTag()) return Kind::Damaged;
    if (tag_.empty() || tag_[0] == '?' || tag_.starts_with("!--")) continue;
    if (tag_[0] == '!') return Kind::Damaged;
    const bool close = tag_[0] == '/';
    const std::string_view body = std::string_view(tag_).substr(close ? 1 : 0);
    std::string_view full = body.substr(0, body.find_first_of(" \t\r\n/"));
    if (const std::size_t colon = full.find(':'); colon != std::string_view::npos) full.remove_prefix(colon + 1);
    name_ = full;
    closes_ = !close && tag_.ends_with('/');
    return close ? Kind::Close : Kind::Open;
  }
}

std::string XmlScan::attribute(std::string_view key) const {
  std::string_view rest = tag_;
  while (true) {
    const std::size_t at = rest.find(key);
    if (at == std::string_view::npos) return {};
    const bool begins = at > 0 && std::strchr(" \t\r\n:", rest[at - 1]) != nullptr;
    std::string_view value = rest.substr(at + key.size());
    value.remove_prefix(std::min(value.find_first_not_of(" \t\r\n"), value.size()));
    if (begins && value.size() > 2 && value[0] == '=') {
      value.remove_prefix(1);
      value.remove_prefix(std::min(value.find_first_not_of(" \t\r\n"), value.size()));
      if (!value.empty() && (value[0] == '"' || value[0] == '\''))
        return resolvedEntities(value.substr(1, value.find(value[0], 1) - 1));
    }
    rest.remove_prefix(at + key.size());
  }
}

std::string resolvedEntities(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t at = text.find('&');
    out += text.substr(0, at);
    if (at == std::string_view::npos) break;
    text.remove_prefix(at + 1);
    const std::size_t end = text.find(';');
    constexpr std::size_t kLongestName = 10;
    if (end == std::string_view::npos || end > kLongestName) {
      out += '&';
      continue;
    }
    const std::string_view name = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (name == "lt") {
      out += '<';
    } else if (name == "gt") {
      out += '>';
    } else if (name == "amp") {
      out += '&';
    } else if (name == "quot") {
      out += '"';
    } else if (name == "apos") {
      out += '\'';
    } else if (name.starts_with('#')) {
      const bool hex = name.size() > 1 && (name[1] == 'x' || name[1] == 'X');
      const std::string_view digits = name.substr(hex ? 2 : 1);
      std::uint32_t code = 0;
      std::from_chars(digits.data(), digits.data() + digits.size(), code, hex ? 16 : 10);
      out += letterOf(code);
    }
  }
  return out;
}

}  // namespace stillcut::record
