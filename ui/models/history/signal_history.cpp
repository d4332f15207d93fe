#include "ui/models/history/signal_history.h"

#include <algorithm>
#include <cmath>

namespace stillcut::ui {
namespace {

constexpr double kDrift = 0.01;  // s: nobody sees less on half a minute

}  // namespace

void SignalHistory::prepare(const CutSetup& setup) {
  *this = SignalHistory();
  rate_ = setup.rate.value;
  if (!(rate_ > 0.0)) return;
  capacity_ = static_cast<std::size_t>(std::ceil(kKept.value * rate_));
  for (const ChannelInfo& channel : setup.channels) scales_.push_back(channel.scale);
  samples_.assign(scales_.size(), std::vector<float>(capacity_, 0.0F));
}

Instant SignalHistory::endOf(const Piece& piece) const {
  return piece.time + toDuration(Seconds(static_cast<double>(piece.count) / rate_));
}

void SignalHistory::add(const SampleBlock& block) {
  if (samples_.empty() || block.frames <= 0) return;
  // A clock that is being followed moves the stamps by parts of a block; a block that is missing, by a whole one.
  const double away = std::abs(secondsBetween(newest_, block.firstSample).value);
  // That is the screen's own loss, and no gap, unless the block says that samples are missing.
  const bool missed = block.has(kBlockGap) || away > 0.5 * block.frames / rate_;
  if (!pieces_.empty() && block.firstSample < pieces_.back().time) pieces_.clear();
  const bool drifted =
      !pieces_.empty() && std::abs(secondsBetween(endOf(pieces_.back()), block.firstSample).value) > kDrift;
  if (missed || drifted || pieces_.empty()) {
    pieces_.push_back({block.firstSample, frames_, 0, block.has(kBlockGap)});
  }
  newest_ = block.firstSample + toDuration(Seconds(block.frames / rate_));
  const int channels = std::min(block.channels, static_cast<int>(samples_.size()));
  for (int c = 0; c < channels; ++c) {
    const auto from = block.channel(c);
    auto& to = samples_[static_cast<std::size_t>(c)];
    const double scale = scales_[static_cast<std::size_t>(c)];
    for (std::size_t i = 0; i < from.size(); ++i) {
      to[(frames_ + i) % capacity_] = static_cast<float>(static_cast<double>(from[i]) * scale);
    }
  }
  frames_ += static_cast<std::uint64_t>(block.frames);
  pieces_.back().count += static_cast<std::uint64_t>(block.frames);
  forget();
}

void SignalHistory::forget() {
  const std::uint64_t oldest = frames_ > capacity_ ? frames_ - capacity_ : 0;
  while (!pieces_.empty() && pieces_.front().first + pieces_.front().count <= oldest) pieces_.pop_front();
  if (pieces_.empty() || pieces_.front().first >= oldest) return;
  Piece& front = pieces_.front();
  const std::uint64_t gone = oldest - front.first;
  front.time += toDuration(Seconds(static_cast<double>(gone) / rate_));
  front.first += gone;
  front.count -= gone;
}

Instant SignalHistory::begin() const {
  return pieces_.empty() ? Instant{} : pieces_.front().time;
}

Instant SignalHistory::end() const {
  return pieces_.empty() ? Instant{} : endOf(pieces_.back());
}

std::vector<Extent> SignalHistory::extents(int channel, Instant from, Instant to, int count) const {
  std::vector<Extent> out(static_cast<std::size_t>(std::max(count, 0)));
  if (channel < 0 || channel >= channels() || count < 1 || !(to > from)) return out;
  const auto& samples = samples_[static_cast<std::size_t>(channel)];
  const double step = secondsBetween(from, to).value / count;
  for (const Piece& piece : pieces_) {
    if (endOf(piece) <= from || piece.time >= to) continue;
    // Every step of the picture takes the samples that fall into it, and at least the one nearest to it.
    const double offset = secondsBetween(piece.time, from).value;
    const auto frameAt = [&](int k) { return static_cast<long>(std::floor((offset + k * step) * rate_)); };
    const auto total = static_cast<long>(piece.count);
    for (int k = 0; k < count; ++k) {
      const long first = std::max(frameAt(k), 0L);
      const long last = std::min(std::max(frameAt(k + 1), frameAt(k) + 1), total);
      if (first >= last) continue;
      Extent& extent = out[static_cast<std::size_t>(k)];
      std::size_t place = (piece.first + static_cast<std::uint64_t>(first)) % capacity_;
      if (!extent.present) extent = {samples[place], samples[place], true};
      for (long i = first; i < last; ++i) {
        extent.low = std::min(extent.low, samples[place]);
        extent.high = std::max(extent.high, samples[place]);
        if (++place == capacity_) place = 0;
      }
    }
  }
  return out;
}

std::vector<SignalHistory::Gap> SignalHistory::gaps() const {
  std::vector<Gap> out;
  for (std::size_t k = 1; k < pieces_.size(); ++k) {
    if (pieces_[k].afterGap) out.push_back({endOf(pieces_[k - 1]), pieces_[k].time});
  }
  return out;
}

}  // namespace stillcut::ui
