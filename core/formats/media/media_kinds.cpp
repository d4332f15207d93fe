#include <algorithm>
#include <array>

#include "core/formats/media/media_import.h"

namespace stillcut::record {
namespace {

// ADTS: twelve set bits, and the two of the layer clear. UTF-16 begins otherwise.
bool isAdts(std::string_view head) {
  const auto byte = [&head](std::size_t i) { return static_cast<unsigned char>(head[i]); };
  return byte(0) == 0xFFU && (byte(1) & 0xF6U) == 0xF0U;
}

}  // namespace

bool isMedia(std::string_view head) {
  constexpr std::size_t kFewest = 16;
  if (head.size() < kFewest) return false;
  constexpr auto kBoxes = std::to_array<std::string_view>({"ftyp", "moov", "mdat", "wide", "pnot"});
  constexpr auto kBeginnings =
      std::to_array<std::string_view>({"\x30\x26\xB2\x75\x8E\x66\xCF\x11", "\x1A\x45\xDF\xA3", "#!AMR", "caff", "OggS",
                                       "FLV\x01", "ADIF", ".RMF", "MAC "});
  const auto begins = [head](std::string_view magic) { return head.starts_with(magic); };
  const std::string_view box = head.substr(4, 4);
  return std::find(kBoxes.begin(), kBoxes.end(), box) != kBoxes.end() ||
         std::any_of(kBeginnings.begin(), kBeginnings.end(), begins) ||
         (head.starts_with("RIFF") && head.substr(8, 4) == "AVI ") || isAdts(head);
}

}  // namespace stillcut::record
