#include "core/formats/sound/sound_length.h"

#include <sndfile.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <string_view>
#include <vector>

namespace stillcut::record {
namespace {

bool isPacked(int format) {
  const int major = format & SF_FORMAT_TYPEMASK, coding = format & SF_FORMAT_SUBMASK;
  return major == SF_FORMAT_FLAC || major == SF_FORMAT_OGG || coding == SF_FORMAT_MPEG_LAYER_I ||
         coding == SF_FORMAT_MPEG_LAYER_II || coding == SF_FORMAT_MPEG_LAYER_III;
}

std::int64_t decodable(const std::string& path, const RiffHeader* header) {
  constexpr int kAtOnce = 4096;
  const SoundFile file(path, header);
  if (file.handle() == nullptr || file.info().channels < 1) return 0;
  std::vector<float> frames(static_cast<std::size_t>(kAtOnce) * static_cast<std::size_t>(file.info().channels));
  std::int64_t all = 0;
  while (true) {
    const sf_count_t got = sf_readf_float(file.handle(), frames.data(), kAtOnce);
    if (got <= 0) return all;
    all += got;
  }
}

// libsndfile keeps a log of what it read in the header: "Data Size : 192000 (should be 99968)". The first such pair
// where the file holds less.
std::optional<Message> shortBytes(SNDFILE* file) {
  std::array<char, 16384> log{};
  sf_command(file, SFC_GET_LOG_INFO, log.data(), static_cast<int>(log.size()) - 1);
  constexpr std::string_view kShould = " (should be ";
  std::string_view rest(log.data());
  for (std::size_t at = rest.find(kShould); at != std::string_view::npos; at = rest.find(kShould)) {
    const std::size_t begin = rest.substr(0, at).find_last_of(' ') + 1;
    std::uint64_t promised = 0, held = 0;
    std::from_chars(rest.data() + begin, rest.data() + at, promised);
    rest.remove_prefix(at + kShould.size());
    std::from_chars(rest.data(), rest.data() + rest.size(), held);
    constexpr std::uint64_t kPadding = 16;  // bytes that writers count or not
    if (held > 0 && promised > held + kPadding)
      return message("the header promises %1 bytes, the file holds %2, which are read: its recorder did not end it",
                     promised, held);
  }
  return std::nullopt;
}

}  // namespace

SoundLength lengthOf(const std::string& path, const SoundFile& file, const RiffHeader* header) {
  const SF_INFO& info = file.info();
  if (!isPacked(info.format)) {
    // WAV has its own rules for sizes that are not true.
    return {info.frames, header != nullptr ? std::nullopt : shortBytes(file.handle())};
  }
  const std::int64_t frames = decodable(path, header);
  constexpr std::int64_t kPadding = 4608;  // frames that coders add at either end
  if (frames + kPadding >= info.frames) return {frames, std::nullopt};
  std::array<char, 32> seconds{};
  std::snprintf(seconds.data(), seconds.size(), "%.2f", static_cast<double>(frames) / std::max(info.samplerate, 1));
  return {frames, message("is damaged %1 s from its beginning: what is before is read", seconds.data())};
}

}  // namespace stillcut::record
