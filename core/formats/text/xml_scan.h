// XmlScan: tags and text of an XML file one after the other, with bounded memory: enough for the parts of a
// spreadsheet. No document types, no entities but the five that are always there; a file that needs more is refused as
// damaged. Thread: one; not real-time.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "core/formats/byte_stream.h"

namespace stillcut::record {

class XmlScan {
 public:
  enum class Kind { Open, Close, Text, End, Damaged };

  // `size`: bytes that the stream has.
  XmlScan(std::unique_ptr<ByteStream> stream, std::uint64_t size) : stream_(std::move(stream)), left_(size) {}

  // An element that closes itself is Open, then Close.
  Kind next();
  // Of an element, without its prefix; of Text: the text, with its entities resolved.
  std::string_view name() const { return name_; }
  const std::string& text() const { return text_; }
  // Of the newest Open; empty: not there.
  std::string attribute(std::string_view key) const;

 private:
  static constexpr std::size_t kLongest = std::size_t{1} << 20U;  // of a tag, of a text
  int get();
  bool readTag();

  std::unique_ptr<ByteStream> stream_;
  std::uint64_t left_;
  std::array<unsigned char, 16384> buffer_{};
  std::size_t at_ = 0, filled_ = 0;
  std::string tag_, name_, text_;
  bool closes_ = false;  // the newest Open closes itself
  bool broken_ = false;
};

// "&lt;" and its kin, "&#10;", "&#xA;" resolved.
std::string resolvedEntities(std::string_view text);

}  // namespace stillcut::record
