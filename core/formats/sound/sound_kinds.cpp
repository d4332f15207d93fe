#include "core/formats/sound/sound_kinds.h"

#include <array>

namespace stillcut::record {

bool isMpegAudio(std::string_view head) {
  if (head.starts_with("ID3")) return true;
  if (head.size() < 2) return false;
  const auto first = static_cast<unsigned char>(head[0]);
  const auto second = static_cast<unsigned char>(head[1]);
  return first == 0xFFU && (second & 0xE0U) == 0xE0U && (second & 0x06U) == 0x02U;
}

bool isSound(std::string_view head) {
  constexpr auto kMagics = std::to_array<std::string_view>(
      {"RIFF", "RIFX", "RF64", "fLaC", "FORM", "OggS", "riff", ".snd", "dns.", "caff", "Creative Voice File", "2BIT",
       "NIST_1A", "fap ", " paf", "\x64\xA3\x01", "\x64\xA3\x02", "\x64\xA3\x03", "\x64\xA3\x04"});
  for (const std::string_view magic : kMagics) {
    if (head.starts_with(magic)) return true;
  }
  return isMpegAudio(head);
}

}  // namespace stillcut::record
