#include "core/formats/sound/wav_clock.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <functional>
#include <string_view>

#include "core/formats/wall_clock.h"

namespace stillcut::record {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} * 1024;  // of a chunk: what is asked for stands at its beginning

std::uint32_t littleEndian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

std::optional<int> digits(std::string_view text, std::size_t from, std::size_t count) {
  int value = 0;
  if (from + count > text.size()) return std::nullopt;
  const char* end = text.data() + from + count;
  const auto [stop, problem] = std::from_chars(text.data() + from, end, value);
  if (stop != end || problem != std::errc{} || value < 0) return std::nullopt;
  return value;
}

// "2026-11-25" and "08:59:59"; any sign may part the numbers. Samples since midnight tell the fraction of the second
// where they tell the same second: of a file that was cut out of another they may count from elsewhere.
std::optional<std::int64_t> broadcastTime(std::string_view date, std::string_view time, std::uint64_t samples,
                                          int rate) {
  const auto year = digits(date, 0, 4), month = digits(date, 5, 2), day = digits(date, 8, 2);
  const auto hour = digits(time, 0, 2), minute = digits(time, 3, 2), second = digits(time, 6, 2);
  if (!year || !month || !day || !hour || !minute || !second) return std::nullopt;
  constexpr double kSame = 2.0;  // [s]
  double seconds = 3600.0 * *hour + 60.0 * *minute + *second;
  const double counted = rate > 0 ? static_cast<double>(samples) / rate : 0.0;
  if (std::abs(counted - seconds) < kSame) seconds = counted;
  return wallTime(*year, *month, *day, seconds);
}

std::optional<std::int64_t> bextTime(std::string_view chunk, int rate) {
  constexpr std::size_t kDate = 320, kTime = 330, kSamples = 338, kLeast = 346;
  if (chunk.size() < kLeast) return std::nullopt;
  const std::uint64_t samples =
      littleEndian(chunk.substr(kSamples)) | std::uint64_t{littleEndian(chunk.substr(kSamples + 4))} << 32U;
  return broadcastTime(chunk.substr(kDate, 10), chunk.substr(kTime, 8), samples, rate);
}

// What stands between <tag> and </tag>; empty: it is not there.
std::string_view elementOf(std::string_view xml, const std::string& tag) {
  const std::size_t begin = xml.find("<" + tag + ">");
  if (begin == std::string_view::npos) return {};
  const std::size_t from = begin + tag.size() + 2, end = xml.find("</" + tag + ">", from);
  return end == std::string_view::npos ? std::string_view() : xml.substr(from, end - from);
}

std::uint64_t numberOf(std::string_view text) {
  std::uint32_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::optional<std::int64_t> ixmlTime(std::string_view xml, int rate) {
  const std::uint64_t samples =
      numberOf(elementOf(xml, "BWF_TIME_REFERENCE_LOW")) | numberOf(elementOf(xml, "BWF_TIME_REFERENCE_HIGH")) << 32U;
  return broadcastTime(elementOf(xml, "BWF_ORIGINATION_DATE"), elementOf(xml, "BWF_ORIGINATION_TIME"), samples, rate);
}

std::optional<std::int64_t> infoTime(std::string_view chunk) {
  if (!chunk.starts_with("INFO")) return std::nullopt;
  chunk.remove_prefix(4);
  while (chunk.size() >= 8) {
    const std::size_t size = std::min<std::size_t>(littleEndian(chunk.substr(4)), chunk.size() - 8);
    const std::string_view body = chunk.substr(8, size);
    if (chunk.starts_with("ICRD")) return wallTime(body.substr(0, body.find('\0')));
    chunk.remove_prefix(std::min(8 + size + (size & 1U), chunk.size()));
  }
  return std::nullopt;
}

// Every chunk, with its beginning; those behind the samples too, where their size is true.
void forEachChunk(std::ifstream& file, const RiffHeader& header,
                  const std::function<void(std::string_view id, std::string_view body)>& visit) {
  constexpr int kMostChunks = 1000;
  std::uint64_t at = 12;
  std::string body;
  for (int i = 0; i < kMostChunks; ++i) {
    std::array<char, 8> head{};
    file.clear();
    file.seekg(static_cast<std::streamoff>(at));
    if (!file.read(head.data(), head.size())) return;
    at += head.size();
    const std::string_view id(head.data(), 4);
    std::uint64_t size = littleEndian(std::string_view(head.data() + 4, 4));
    if (id == "data") {
      if (header.sizes != RiffHeader::Sizes::True) return;
      size = header.promised;
    } else if (id == "bext" || id == "iXML" || id == "LIST") {
      body.resize(std::min<std::uint64_t>(size, kMostBytes));
      file.read(body.data(), static_cast<std::streamsize>(body.size()));
      body.resize(static_cast<std::size_t>(file.gcount()));
      visit(id, body);
    }
    at += size + (size & 1U);
  }
}

}  // namespace

std::optional<std::int64_t> wavStarted(const std::string& path, const RiffHeader& header) {
  std::ifstream file(path, std::ios::binary);
  std::optional<std::int64_t> bext, ixml, info;
  forEachChunk(file, header, [&](std::string_view id, std::string_view body) {
    if (id == "bext" && !bext) bext = bextTime(body, header.rate);
    if (id == "iXML" && !ixml) ixml = ixmlTime(body, header.rate);
    if (id == "LIST" && !info) info = infoTime(body);
  });
  return bext ? bext : ixml ? ixml : info;
}

}  // namespace stillcut::record
