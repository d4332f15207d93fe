#include "core/session/file/session_samples.h"

#include <algorithm>
#include <cstdio>

#include "core/formats/sensor_notes.h"
#include "core/session/file/session_layout.h"

namespace stillcut::record {

std::string pyramidPath(int channel, int level) {
  char text[48];
  std::snprintf(text, sizeof text, "pyramid/%02d/%llu", channel, static_cast<unsigned long long>(bucketFrames(level)));
  return text;
}

bool SampleWriter::create(hid_t file, int channel, const ChannelInfo& info) {
  if (!samples_.create(file, samplesPath(channel), 1, kSampleChunk)) return false;
  for (int level = 0; level < kPyramidLevels; ++level) {
    const std::uint64_t chunk = level == 0 ? 1024 : 128;
    if (!levels_[static_cast<std::size_t>(level)].table.create(file, pyramidPath(channel, level), 2, chunk))
      return false;
  }
  const hid_t dataset = samples_.dataset();
  return writeText(dataset, "name", info.name) && writeText(dataset, "quantity", std::string(name(info.quantity))) &&
         writeText(dataset, "unit", std::string(siUnit(info.quantity))) && writeNumber(dataset, "scale", info.scale) &&
         writeText(dataset, "axis", info.axis) && writeSensor(dataset, info);
}

void SampleWriter::add(std::span<const float> samples) {
  pending_.insert(pending_.end(), samples.begin(), samples.end());
  for (const float s : samples) put(0, {s, s});
}

void SampleWriter::put(int level, MinMax part) {
  Level& l = levels_[static_cast<std::size_t>(level)];
  l.open.add(part);
  if (++l.filled < (level == 0 ? kPyramidBase : kPyramidFactor)) return;
  const MinMax done = l.open.value();
  l.filled = 0;
  l.open.clear();
  l.pending.push_back(done.min);
  l.pending.push_back(done.max);
  if (level + 1 < kPyramidLevels) put(level + 1, done);
}

bool SampleWriter::write() {
  if (pending_.empty()) return true;
  if (!samples_.append(pending_) || !samples_.flush()) return false;
  pending_.clear();
  for (Level& l : levels_) {
    if (l.pending.empty()) continue;
    if (!l.table.append(l.pending) || !l.table.flush()) return false;
    l.pending.clear();
  }
  return true;
}

void SampleWriter::close() {
  samples_.close();
  for (Level& l : levels_) l.table.close();
}

bool SampleReader::open(hid_t file, int channel) {
  return samples_.open(file, samplesPath(channel), 1);
}

bool SampleReader::read(std::uint64_t first, std::span<float> out) {
  if (first > frames() || out.size() > frames() - first) return false;
  const bool inside = first >= windowFirst_ && first + out.size() <= windowFirst_ + window_.size();
  if (!inside) {
    window_.resize(std::min(std::max<std::uint64_t>(out.size(), 4 * kSampleChunk), frames() - first));
    windowFirst_ = first;
    if (!samples_.read(first, window_)) {
      window_.clear();
      return false;
    }
  }
  std::copy_n(window_.begin() + static_cast<std::ptrdiff_t>(first - windowFirst_), out.size(), out.begin());
  return true;
}

}  // namespace stillcut::record
