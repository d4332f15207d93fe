#include "core/pipeline/spectrum_tap.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace stillcut::pipeline {
namespace {

constexpr double kColumnsPerSecond = 50.0;
constexpr double kWindowSeconds = 0.08;  // 12.5 Hz bins: side lines one spindle frequency apart stay apart
constexpr float kFloor_dB = -200.0F;

}  // namespace

void SpectrumTap::prepare(const CutSetup& setup) {
  rate_ = setup.rate.value;
  scales_.clear();
  for (const ChannelInfo& channel : setup.channels) scales_.push_back(channel.scale);
  if (scales_.empty()) scales_.push_back(1.0);
  channel_ = 0;
  hop_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(rate_ / kColumnsPerSecond)));
  window_ = std::bit_ceil(static_cast<std::size_t>(std::max(64.0, rate_ * kWindowSeconds)));
  spectrum_.prepare(static_cast<int>(window_), setup.rate, dsp::WindowKind::Hann);
  history_.assign(2 * window_, 0.0);
  filled_ = held_ = position_ = 0;
  gap_ = false;
  count_ = 0;
}

void SpectrumTap::feed(const SampleBlock& block, const Verdict& verdict) noexcept {
  if (block.has(kBlockGap)) {
    gap_ = true;
    held_ = filled_ = 0;
  }
  const int wanted = wanted_.load(std::memory_order_relaxed);
  const int channel = wanted >= 0 && wanted < std::min(block.channels, static_cast<int>(scales_.size())) ? wanted : 0;
  if (channel != channel_) {
    channel_ = channel;
    gap_ = true;
    held_ = filled_ = 0;
  }
  const std::span<const float> samples = block.channel(channel);
  const double scale = scales_[static_cast<std::size_t>(channel)];
  for (std::size_t i = 0; i < samples.size(); ++i) {
    history_[position_] = history_[position_ + window_] = static_cast<double>(samples[i]) * scale;
    position_ = (position_ + 1) % window_;
    held_ = std::min(held_ + 1, window_);
    if (++filled_ < hop_) continue;
    filled_ = 0;
    if (held_ < window_) continue;  // a window across a gap would show what was never there
    const double middle = (static_cast<double>(i) + 1.0 - 0.5 * static_cast<double>(window_)) / rate_;
    makeColumn(block.firstSample + toDuration(Seconds(middle)), verdict);
  }
}

void SpectrumTap::makeColumn(Instant time, const Verdict& verdict) noexcept {
  SpectrumColumn& column = columns_[count_ % kSpectrumColumns];
  column.number = count_++;
  column.channel = channel_;
  column.time = time;
  column.afterGap = gap_;
  gap_ = false;
  column.spindle = verdict.spindle;
  column.chatter = verdict.alarming() ? verdict.frequency : Hertz();

  spectrum_.transform(std::span<const double>(history_).subspan(position_, window_));

  // Several bins into one: the strongest, so that no line is lost; few bins into many: the nearest.
  const auto bins = static_cast<std::size_t>(spectrum_.bins() - 1);
  for (std::size_t b = 0; b < kSpectrumBins; ++b) {
    const std::size_t from = b * bins / kSpectrumBins;
    const std::size_t to = std::max(from + 1, (b + 1) * bins / kSpectrumBins);
    double strongest = 0.0;
    for (std::size_t i = from; i < to; ++i) strongest = std::max(strongest, spectrum_.amplitude(static_cast<int>(i)));
    const bool usable = std::isfinite(strongest) && strongest > 1e-10;
    column.level_dB[b] = usable ? static_cast<float>(20.0 * std::log10(strongest) - 3.0103) : kFloor_dB;
  }
}

}  // namespace stillcut::pipeline
