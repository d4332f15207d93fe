#include "core/formats/text/text_bytes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/text/xlsx_text.h"
#include "core/formats/utf_text.h"

namespace stillcut::record {
namespace {

class PlainBytes final : public TextBytes {
 public:
  PlainBytes(std::string path, std::ifstream file) : path_(std::move(path)), file_(std::move(file)) {}
  Result<std::size_t> read(char* into, std::size_t most) override {
    file_.read(into, static_cast<std::streamsize>(most));
    if (file_.bad()) return Error{path_, message("cannot be read"), message("input/output error")};
    return static_cast<std::size_t>(file_.gcount());
  }

 private:
  std::string path_;
  std::ifstream file_;
};

// A letter takes two bytes here and at most three in UTF-8; a pair of halves is kept together.
class Utf16Bytes final : public TextBytes {
 public:
  Utf16Bytes(std::unique_ptr<TextBytes> raw, bool bigEndian) : raw_(std::move(raw)), bigEndian_(bigEndian) {}
  Result<std::size_t> read(char* into, std::size_t most) override {
    while (at_ == text_.size()) {
      const auto more = fill();
      if (!more) return more.error();
      if (!*more) return std::size_t{0};
    }
    const std::size_t count = std::min(most, text_.size() - at_);
    std::memcpy(into, text_.data() + at_, count);
    at_ += count;
    return count;
  }

 private:
  Result<bool> fill() {
    const auto got = raw_->read(bytes_.data() + kept_, bytes_.size() - kept_);
    if (!got) return got.error();
    if (*got == 0 && kept_ == 0) return false;
    const std::size_t held = kept_ + *got;
    letters_.clear();
    for (std::size_t i = 0; i + 1 < held; i += 2) {
      const auto low = static_cast<unsigned char>(bytes_[i + (bigEndian_ ? 1 : 0)]);
      const auto high = static_cast<unsigned char>(bytes_[i + (bigEndian_ ? 0 : 1)]);
      letters_.push_back(static_cast<std::uint16_t>(low | high << 8U));
    }
    std::size_t used = letters_.size() * 2;
    const bool half = !letters_.empty() && (letters_.back() & 0xFC00U) == 0xD800U;
    if (half && *got > 0) {
      letters_.pop_back();
      used -= 2;
    }
    kept_ = *got > 0 ? held - used : 0;
    std::memmove(bytes_.data(), bytes_.data() + used, kept_);
    text_ = fromUtf16(letters_);
    at_ = 0;
    return true;
  }

  std::unique_ptr<TextBytes> raw_;
  bool bigEndian_;
  std::array<char, 8192> bytes_{};
  std::size_t kept_ = 0;  // bytes of a letter that is not whole yet
  std::vector<std::uint16_t> letters_;
  std::string text_;
  std::size_t at_ = 0;
};

}  // namespace

Result<std::unique_ptr<TextBytes>> openText(const std::string& path) {
  std::error_code none;
  if (const std::size_t place = path.rfind(":/"); place != std::string::npos && !std::filesystem::exists(path, none)) {
    return openXlsxText(path.substr(0, place), path.substr(place + 2));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{path, message("cannot be opened"), foreign(std::strerror(errno))};
  std::array<char, 4> bytes{};
  file.read(bytes.data(), bytes.size());
  const std::string_view head(bytes.data(), static_cast<std::size_t>(file.gcount()));
  if (head.starts_with("PK\x03\x04") && isXlsx(path)) return openXlsxText(path);
  file.clear();
  const bool little = head.starts_with("\xFF\xFE"), big = head.starts_with("\xFE\xFF");
  file.seekg(little || big ? 2 : 0);
  auto plain = std::make_unique<PlainBytes>(path, std::move(file));
  if (!little && !big) return std::unique_ptr<TextBytes>(std::move(plain));
  return std::unique_ptr<TextBytes>(new Utf16Bytes(std::move(plain), big));
}

}  // namespace stillcut::record
