#include "core/sensing/pair_watch.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace stillcut::detect {
namespace {

constexpr double kSame = 1e-8;     // part of the power that proportion leaves: 80 dB
constexpr double kRounding = 1.5;  // of a mean of 64 squares and more, whose own scatter is a tenth
constexpr double kAbove = 1e4;     // 40 dB
constexpr double kSeconds = 0.1;
constexpr int kFewest = 64;  // samples
constexpr int kLooks = 3;

std::string_view axisOf(const ChannelInfo& channel) {
  const bool named = channel.name == "x" || channel.name == "y" || channel.name == "z";
  return channel.axis.empty() && named ? channel.name : channel.axis;
}

void learnStep(double change, double& step) noexcept {
  if (change != 0.0 && (step == 0.0 || std::abs(change) < step)) step = std::abs(change);
}

}  // namespace

void PairWatch::prepare(const CutSetup& setup) {
  pairs_.clear();
  const auto& channels = setup.channels;
  for (std::size_t a = 0; a < channels.size(); ++a) {
    for (std::size_t b = a + 1; b < channels.size(); ++b) {
      const std::string_view first = axisOf(channels[a]);
      const std::string_view second = axisOf(channels[b]);
      const bool claimed = !first.empty() && !second.empty();
      if (claimed && first != second && channels[a].quantity == channels[b].quantity) {
        pairs_.push_back({static_cast<int>(a), static_cast<int>(b), {}});
      }
    }
  }
  window_ = std::max(kFewest, static_cast<int>(kSeconds * setup.rate.value));
  reset();
}

void PairWatch::reset() noexcept {
  for (Pair& pair : pairs_) pair.same = {};
  turn_ = 0;
  begin();
}

void PairWatch::begin() noexcept {
  frames_ = 0;
  xStep_ = yStep_ = 0.0;
  x_ = y_ = xx_ = yy_ = xy_ = 0.0;
}

void PairWatch::push(const SampleBlock& block) noexcept {
  if (pairs_.empty()) return;
  Pair& pair = pairs_[turn_];
  const std::span<const float> first = block.channel(pair.first);
  const std::span<const float> second = block.channel(pair.second);
  if (frames_ == 0) {  // keeps an offset out of the sums
    x0_ = static_cast<double>(first[0]);
    y0_ = static_cast<double>(second[0]);
  }
  for (std::size_t f = 0; f < first.size(); ++f) {
    const double x = static_cast<double>(first[f]) - x0_;
    const double y = static_cast<double>(second[f]) - y0_;
    learnStep(x, xStep_);
    learnStep(y, yStep_);
    if (f > 0) {
      learnStep(static_cast<double>(first[f]) - static_cast<double>(first[f - 1]), xStep_);
      learnStep(static_cast<double>(second[f]) - static_cast<double>(second[f - 1]), yStep_);
    }
    x_ += x;
    y_ += y;
    xx_ += x * x;
    yy_ += y * y;
    xy_ += x * y;
  }
  frames_ += block.frames;
  if (frames_ < window_) return;
  judge(pair);
  begin();
  turn_ = (turn_ + 1) % pairs_.size();
}

void PairWatch::judge(Pair& pair) noexcept {
  const double xx = xx_ - x_ * x_ / frames_;
  const double yy = yy_ - y_ * y_ / frames_;
  const double xy = xy_ - x_ * y_ / frames_;
  const bool moves = xx > 0.0 && yy > 0.0;
  const double gain = moves ? xy / xx : 0.0;
  const double left = yy - gain * xy;
  const double rounding = kRounding * frames_ / 12.0 * (yStep_ * yStep_ + gain * gain * xStep_ * xStep_);
  const bool rounded = left < rounding && yy > kAbove * rounding;
  pair.same.see(moves && (left < kSame * yy || rounded), kLooks, kLooks);
}

int PairWatch::twinOf(int channel) const noexcept {
  for (const Pair& pair : pairs_) {
    if (pair.same.stands() && pair.second == channel) return pair.first;
  }
  return -1;
}

}  // namespace stillcut::detect
