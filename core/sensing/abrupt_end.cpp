#include "core/sensing/abrupt_end.h"

#include <algorithm>
#include <cstddef>

namespace stillcut::detect {
namespace {

constexpr std::size_t kFewestFrames = 8;
constexpr double kLoud = 0.1;      // 10 dB
constexpr double kGone = 0.001;    // 30 dB
constexpr std::size_t kAfter = 2;  // milliseconds

// Both windows in a row, a millisecond at a time.
class Milliseconds {
 public:
  Milliseconds(std::span<const double> before, std::span<const double> now, std::size_t hop)
      : before_(before), now_(now), hop_(hop) {}
  std::size_t inBefore() const { return before_.size() / hop_; }
  std::size_t count() const { return (before_.size() + now_.size()) / hop_; }
  double variance(std::size_t index) const {
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t f = index * hop_; f < (index + 1) * hop_; ++f) {
      const double x = f < before_.size() ? before_[f] : now_[f - before_.size()];
      sum += x;
      squares += x * x;
    }
    const double count = static_cast<double>(hop_);
    return squares / count - sum * sum / (count * count);
  }

 private:
  std::span<const double> before_, now_;
  std::size_t hop_;
};

}  // namespace

bool endsAbruptly(std::span<const double> before, std::span<const double> now, int hop) noexcept {
  if (hop < static_cast<int>(kFewestFrames)) return false;
  const Milliseconds pieces(before, now, static_cast<std::size_t>(hop));
  double usual = 0.0;  // before the end
  std::size_t some = 0;
  double largest = 0.0;
  for (std::size_t i = 0; i < pieces.inBefore(); ++i) largest = std::max(largest, pieces.variance(i));
  for (std::size_t i = 0; i < pieces.inBefore(); ++i) {
    const double v = pieces.variance(i);
    if (v < kGone * largest) continue;
    usual += v;
    ++some;
  }
  if (some == 0) return false;
  usual /= static_cast<double>(some);
  std::size_t last = pieces.count();
  for (std::size_t i = 0; i < pieces.count(); ++i) {
    if (pieces.variance(i) > kLoud * usual) last = i;
  }
  if (last + kAfter + 1 >= pieces.count()) return false;
  return pieces.variance(last + kAfter) < kGone * usual && pieces.variance(last + kAfter + 1) < kGone * usual;
}

}  // namespace stillcut::detect
