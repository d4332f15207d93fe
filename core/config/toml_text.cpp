#include "core/config/toml_text.h"

#include <algorithm>
#include <map>

namespace stillcut::config {
namespace {

constexpr std::size_t kEnd = std::string_view::npos;

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<TomlSpot> spots() {
    if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;
    while (at_ < text_.size()) {
      lineBegin_ = at_;
      skipBlanks();
      const char c = peek();
      if (c == '[') {
        header();
      } else if (c != '#' && c != '\n' && c != '\0') {
        entry();
      }
      endLine();
    }
    return std::move(found_);
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  void skipBlanks() {
    while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
  }
  // To behind the line's end; a comment is noted with what was found last on this line.
  void endLine() {
    const std::size_t end = text_.find('\n', at_);
    const std::size_t next = end == kEnd ? text_.size() : end + 1;
    if (!found_.empty() && found_.back().lineEnd == 0) {
      const std::size_t comment = text_.find('#', at_);
      if (comment < next) found_.back().comment = comment;
      found_.back().lineEnd = next;
    }
    at_ = next;
  }

  // A string of any of the four kinds, from its first quote to behind its last.
  void skipString() {
    const char quote = peek();
    const bool block = peek(1) == quote && peek(2) == quote;
    at_ += block ? 3 : 1;
    while (at_ < text_.size()) {
      if (quote == '"' && peek() == '\\') {
        at_ += 2;
      } else if (peek() == quote && (!block || (peek(1) == quote && peek(2) == quote))) {
        at_ += block ? 3 : 1;
        while (block && peek() == quote) ++at_;  // up to two quotes of its own may stand before the closing ones
        return;
      } else {
        ++at_;
      }
    }
    at_ = std::min(at_, text_.size());
  }

  std::string key() {
    const std::size_t begin = at_;
    if (peek() == '"' || peek() == '\'') {
      skipString();
      return std::string(text_.substr(begin + 1, at_ - begin >= 2 ? at_ - begin - 2 : 0));
    }
    while (at_ < text_.size() && std::string_view(" \t\r\n.=]#").find(text_[at_]) == kEnd) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }
  // Keys joined by dots; gives where the last one begins.
  std::size_t keys(TomlPath& path) {
    std::size_t last = at_;
    while (true) {
      skipBlanks();
      last = at_;
      path.push_back(key());
      skipBlanks();
      if (peek() != '.') return last;
      ++at_;
    }
  }

  // Elements of arrays of tables stand in the path with the number of the newest.
  TomlPath withNumbers(const TomlPath& path, bool element) {
    TomlPath full;
    for (std::size_t i = 0; i < path.size(); ++i) {
      full.push_back(path[i]);
      if (element && i + 1 == path.size()) {
        full.push_back(std::to_string(elements_[full]++));
      } else if (const auto array = elements_.find(full); array != elements_.end()) {
        full.push_back(std::to_string(array->second - 1));
      }
    }
    return full;
  }

  void header() {
    TomlSpot spot;
    spot.what = TomlSpot::What::Header;
    spot.lineBegin = lineBegin_;
    spot.valueBegin = at_;
    spot.element = peek(1) == '[';
    at_ += spot.element ? 2 : 1;
    TomlPath path;
    keys(path);
    while (peek() == ']') ++at_;
    spot.valueEnd = at_;
    table_ = withNumbers(path, spot.element);
    spot.path = table_;
    found_.push_back(std::move(spot));
  }

  void entry() {
    TomlSpot spot;
    spot.lineBegin = lineBegin_;
    spot.path = table_;
    spot.keyEnd = keys(spot.path);
    if (peek() == '=') ++at_;
    skipBlanks();
    spot.valueBegin = at_;
    spot.valueEnd = value();
    found_.push_back(std::move(spot));
  }
  // Over a value of any kind; gives the end of its last byte.
  std::size_t value() {
    int depth = 0;
    std::size_t end = at_;
    while (at_ < text_.size()) {
      const char c = peek();
      if (c == '"' || c == '\'') {
        skipString();
        end = at_;
        continue;
      }
      if (depth == 0 && (c == '#' || c == '\n')) break;
      if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
        continue;
      }
      if (c == '[' || c == '{') ++depth;
      if (c == ']' || c == '}') --depth;
      ++at_;
      if (!isBlank(c) && c != '\n') end = at_;
    }
    return end;
  }

  std::string_view text_;
  std::size_t at_ = 0, lineBegin_ = 0;
  TomlPath table_;                    // that the entries stand in
  std::map<TomlPath, int> elements_;  // of each array of tables, so far
  std::vector<TomlSpot> found_;
};

}  // namespace

std::vector<TomlSpot> tomlSpots(std::string_view text) {
  return Scanner(text).spots();
}

}  // namespace stillcut::config
