#include "core/spindle/lone_line.h"

#include <cmath>

#include "core/dsp/order.h"

namespace stillcut::detect {
namespace {

constexpr double kLonePart = 0.6;
constexpr double kSuspectDrift = 0.02;
constexpr double kLoneDrift = 2.0;  // bins of the window from one to the next

}  // namespace

void LoneLine::prepare(int teeth, Hertz rate) {
  teeth_ = teeth;
  rate_ = rate.value;
  reset();
}

void LoneLine::reset() noexcept {
  suspect_ = {};
  forget();
}

void LoneLine::watch(const SpeedSearch& search, Hertz told, double range, bool measured, Hertz followed) noexcept {
  const SpeedSearch::Line line = search.strongest();
  const Hertz before = strongest_;
  strongest_ = line.part > kLonePart ? line.frequency : Hertz(0.0);
  line_ = {};
  if (teeth_ < 2 || !(told.value > 0.0) || !(strongest_.value > 0.0) || !(before.value > 0.0)) return;
  if (std::abs(strongest_.value - before.value) > kLoneDrift * rate_ / search.window()) return;
  if (search.mayBeForced(strongest_, told * (1.0 - range), told * (1.0 + range))) return;
  if (!measured) {
    if (search.mayBeForcedAt(strongest_, followed)) return;
    const double further = range + SpeedSearch::kRunAway;
    if (search.mayBeAmongOthers(strongest_, told * (1.0 - further), told * (1.0 + further))) return;
  }
  // A mode can make runout's harmonic the only line there is; a measured speed says where they are.
  const double orders = rate_ / (search.window() * told.value) + kReadBack * (strongest_ / told);
  if (measured && std::abs(dsp::orderOffset(strongest_, told)) < orders) return;
  line_ = suspect_ = strongest_;
  missed_ = 0;
}

void LoneLine::followSuspect(const SpeedSearch& search) noexcept {
  const SpeedSearch::Line line = search.strongest();
  if (std::abs(line.frequency / suspect_ - 1.0) < kSuspectDrift) {
    suspect_ = line.frequency;
    missed_ = 0;
  } else if (heard()) {
    ++missed_;
  }
}

}  // namespace stillcut::detect
