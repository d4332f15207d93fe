// Everything a recording holds, for tests that compare whole files.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/session/open_recording.h"

namespace stillcut::record {

struct WholeRecording {
  RecordingFormat format;
  std::vector<std::vector<double>> values;  // [channel][frame], SI units
  std::string error;                        // why it ended early; empty: it did not
};

inline WholeRecording readAll(const std::string& path, const ReadOptions& options = {}, int capacity = 777) {
  WholeRecording all;
  auto reader = openRecording(path, options);
  if (!reader) {
    all.error = reader.error().line();
    return all;
  }
  all.format = (*reader)->format();
  all.values.resize(all.format.channels.size());
  SampleBlock block;
  block.allocate(static_cast<int>(all.format.channels.size()), std::max(capacity, all.format.blockFrames));
  while (true) {
    const Result<bool> more = (*reader)->read(block);
    if (!more) all.error = more.error().line();
    if (!more || !*more) return all;
    for (std::size_t c = 0; c < all.values.size(); ++c) {
      const double scale = all.format.channels[c].info.scale;
      for (const float v : block.channel(static_cast<int>(c))) all.values[c].push_back(scale * static_cast<double>(v));
    }
  }
}

}  // namespace stillcut::record
