#include "core/evaluate/sensor_tally.h"

#include <algorithm>
#include <cmath>

namespace stillcut::evaluate {
namespace {

constexpr int kClippedRun = 3;                 // so many equal extremes in a row are no coincidence
constexpr std::uint64_t kClippedSamples = 12;  // and so many in all are no accident
constexpr double kFaint = 1e-3;                // of the strongest channel of its quantity

}  // namespace

SensorTally::SensorTally(const std::vector<record::RecordedChannel>& channels) {
  for (const record::RecordedChannel& channel : channels) {
    Sums sums;
    sums.channel = channel;
    all_.push_back(sums);
  }
}

// Welford (1962), and runs of the extreme value: a new extreme forgets those of the one before.
void SensorTally::addSample(Sums& sums, double value) {
  sums.count += 1.0;
  const double off = value - sums.mean;
  sums.mean += off / sums.count;
  sums.m2 += off * (value - sums.mean);
  const bool first = sums.count < 1.5;
  if (first || value > sums.highest) sums.highest = value;
  if (first || value < sums.lowest) sums.lowest = value;
  const double size = std::abs(value);
  if (first || size > sums.limitValue) {
    sums.limitValue = size;
    sums.atLimit = 0;
    sums.run = 1;
  } else if (size < sums.limitValue) {
    sums.run = 0;
  } else if (++sums.run >= kClippedRun) {
    ++sums.atLimit;
  }
}

void SensorTally::add(const SampleBlock& block) {
  clipped_ = clipped_ || block.has(kBlockClipped);
  for (std::size_t c = 0; c < all_.size(); ++c) {
    const std::span<const float> samples = block.channel(static_cast<int>(c));
    const double scale = all_[c].channel.info.scale;
    double sum = 0.0;
    double squares = 0.0;
    for (const float v : samples) {
      const double value = scale * static_cast<double>(v);
      addSample(all_[c], value);
      sum += value;
      squares += value * value;
    }
    if (c > 0 || samples.empty()) continue;
    const auto n = static_cast<double>(samples.size());
    blockRms_ = std::sqrt(std::max(0.0, squares / n - sum / n * sum / n));
  }
}

std::vector<SensorSummary> SensorTally::finish() const {
  std::vector<SensorSummary> all;
  for (const Sums& sums : all_) {
    SensorSummary s;
    s.info = sums.channel.info;
    s.calibrated = sums.channel.quantityKnown;
    s.mean = sums.mean;
    s.rms = sums.count > 0.0 ? std::sqrt(sums.m2 / sums.count) : 0.0;
    s.peak = std::max(sums.highest - sums.mean, sums.mean - sums.lowest);
    const bool force = s.info.quantity == SensorQuantity::Force || s.info.quantity == SensorQuantity::SpindleSpeed;
    if (!(sums.highest > sums.lowest)) {
      s.health = SensorHealth::Dead;
    } else if (sums.atLimit >= kClippedSamples || (clipped_ && all_.size() == 1)) {
      s.health = SensorHealth::Clipped;
    } else if (!force && std::abs(s.mean) > s.peak) {  // a force has a mean by right
      s.health = SensorHealth::Offset;
    }
    all.push_back(std::move(s));
  }
  for (SensorSummary& s : all) {
    double strongest = 0.0;
    for (const SensorSummary& other : all) {
      if (other.info.quantity == s.info.quantity) strongest = std::max(strongest, other.rms);
    }
    if (s.health == SensorHealth::InOrder && s.rms < kFaint * strongest) s.health = SensorHealth::Faint;
  }
  return all;
}

}  // namespace stillcut::evaluate
