#include "app/cli/force_file.h"

#include "core/session/open_recording.h"

namespace stillcut::app {
namespace {

// Which three channels; the file's own force channels where it names three.
Result<std::array<std::size_t, 3>> pickChannels(const record::RecordingFormat& format, const std::string& path) {
  if (format.channels.size() < 3) {
    return Error{path, message("has %1 channels", std::to_string(format.channels.size())),
                 message("forces in x, y and z are needed")};
  }
  std::vector<std::size_t> forces;
  for (std::size_t i = 0; i < format.channels.size(); ++i) {
    if (format.channels[i].info.quantity == SensorQuantity::Force) forces.push_back(i);
  }
  if (forces.size() == 3) return std::array<std::size_t, 3>{forces[0], forces[1], forces[2]};
  return std::array<std::size_t, 3>{0, 1, 2};
}

}  // namespace

Result<ForceFile> readForces(const std::string& path, const std::vector<int>& channels) {
  record::ReadOptions options;
  options.quantity = channels.empty() ? std::nullopt : std::optional(SensorQuantity::Force);
  options.channels = channels;
  auto reader = record::openRecording(path, options);
  if (!reader) return reader.error();
  const record::RecordingFormat& format = (*reader)->format();
  const auto picked = pickChannels(format, path);
  if (!picked) return picked.error();
  ForceFile out;
  out.rate = format.rate;
  SampleBlock block;
  block.allocate(static_cast<int>(format.channels.size()), format.blockFrames > 0 ? format.blockFrames : 4096);
  for (;;) {
    const auto more = (*reader)->read(block);
    if (!more) return more.error();
    if (!*more) return out;
    if (block.has(kBlockGap) && !out.force[0].empty()) return Error{path, message("samples are missing in between")};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t channel = (*picked)[axis];
      const double scale = format.channels[channel].info.scale;
      for (const float v : block.channel(static_cast<int>(channel))) {
        out.force[axis].push_back(scale * static_cast<double>(v));
      }
    }
  }
}

}  // namespace stillcut::app
