#include "core/milling/simulation/work_holder.h"

#include <algorithm>
#include <cmath>

namespace stillcut::milling {

Status check(const WorkHolderSettings& s, const std::string& where) {
  const auto positive = [](double v) { return std::isfinite(v) && v > 0.0; };
  if (!positive(s.flexure.value) || !positive(s.stiffness) || !(s.damping > 0.0 && s.damping < 1.0)) {
    return Error{where, message("the work-holder needs a flexure with frequency, damping and stiffness")};
  }
  if (!positive(s.stroke.value) || s.stroke.value > 1e-3) {
    return Error{where, message("the work-holder's stroke must be above zero and at most 1 mm")};
  }
  if (!positive(s.reconstruction.value) || !positive(s.amplifier.value) || !positive(s.slew)) {
    return Error{where, message("the work-holder's filter and amplifier need a bandwidth and a slew limit")};
  }
  if (s.quieten.size() > 8 || !std::ranges::all_of(s.quieten, [&](Hertz f) { return positive(f.value); })) {
    return Error{where, message("the work-holder's lines to quieten must be positive frequencies"),
                 message("at most 8")};
  }
  return Done{};
}

std::array<Mode, 2> workHolderModes(const WorkHolderSettings& s) {
  const Mode x{s.flexure, s.damping, s.stiffness, {1.0, 0.0}};
  const Mode y{s.flexure, s.damping, s.stiffness, {0.0, 1.0}};
  return {x, y};
}

WorkHolderAxis::WorkHolderAxis(const WorkHolderSettings& settings, Hertz rate)
    : settings_(settings),
      follow_(1.0 - std::exp(-kTwoPi * settings.amplifier.value / rate.value)),
      most_(settings.slew / rate.value) {
  filter_.prepare(Hertz(std::min(settings.reconstruction.value, 0.45 * rate.value)), rate);
}

double WorkHolderAxis::step(double command) STILLCUT_RT {
  const double wanted = filter_.run(command);
  const double end = settings_.stroke.value;
  const double move = follow_ * (std::clamp(wanted, -end, end) - stroke_);
  const double moved = std::clamp(move, -most_, most_);
  saturated_ = std::abs(wanted) > end || moved != move;
  stroke_ += moved;
  return settings_.stiffness * stroke_;
}

}  // namespace stillcut::milling
