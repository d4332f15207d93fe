#include "core/config/toml_writer.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/storage/atomic_file.h"
#include "core/units/number_text.h"

namespace stillcut::config {
namespace {

bool isBareKey(std::string_view key) {
  const auto bare = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  };
  return !key.empty() && std::all_of(key.begin(), key.end(), bare);
}

std::string quoted(std::string_view value) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string s = "\"";
  for (const char c : value) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      s += '\\';
      s += c;
    } else if (code < 0x20 || code == 0x7f) {
      s += "\\u00";
      s += kHex[code >> 4U];
      s += kHex[code & 15U];
    } else {
      s += c;
    }
  }
  return s + '"';
}

// Whether the text, written bare, is read back as the same text.
bool isPlainNumber(std::string_view text) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool number = code == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
  return number && text != "-0" && numberText(value) == text;
}

std::string inDigits(double value) {
  char digits[40];
  const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 12);
  return {digits, end.ptr};
}

}  // namespace

void TomlWriter::line(std::string_view key, std::string_view value) {
  content_ += isBareKey(key) ? std::string(key) : quoted(key);
  content_ += " = ";
  content_ += value;
  content_ += '\n';
}

void TomlWriter::comment(std::string_view line) {
  content_ += "# " + std::string(line) + '\n';
}

void TomlWriter::table(std::string_view path) {
  content_ += (content_.empty() ? "[" : "\n[") + std::string(path) + "]\n";
}

void TomlWriter::arrayElement(std::string_view path) {
  content_ += (content_.empty() ? "[[" : "\n[[") + std::string(path) + "]]\n";
}

void TomlWriter::number(std::string_view key, double value) {
  line(key, inDigits(value));
}

void TomlWriter::numbers(std::string_view key, std::span<const double> values) {
  std::string list;
  for (const double value : values) list += (list.empty() ? "" : ", ") + inDigits(value);
  line(key, '[' + list + ']');
}

void TomlWriter::integer(std::string_view key, int value) {
  line(key, std::to_string(value));
}

void TomlWriter::boolean(std::string_view key, bool value) {
  line(key, value ? "true" : "false");
}

void TomlWriter::text(std::string_view key, std::string_view value) {
  line(key, quoted(value));
}

void TomlWriter::scalar(std::string_view key, std::string_view value) {
  const bool bare = value == "true" || value == "false" || isPlainNumber(value);
  line(key, bare ? std::string(value) : quoted(value));
}

Status TomlWriter::save(const std::filesystem::path& path) const {
  return writeFileAtomically(path, content_);
}

}  // namespace stillcut::config
