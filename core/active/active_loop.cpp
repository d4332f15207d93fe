#include "core/active/active_loop.h"

#include <string>

namespace stillcut::active {

Status ActiveLoop::prepare(const std::array<AxisOptions, kActiveAxes>& axes, Hertz rate) {
  for (std::size_t a = 0; a < kActiveAxes; ++a) {
    const AxisOptions& o = axes[a];
    if (Status ok = checkPath(o.path, std::string("path along ") + (a == 0 ? "x" : "y")); !ok) return ok;
    if (o.online.rms > 0.0 && leadingDelay(o.path) >= o.online.lags) {
      return Error{std::string("path along ") + (a == 0 ? "x" : "y"),
                   message("is later than on-line identification looks, %1 samples", std::to_string(o.online.lags)),
                   message("switch 'active.auxiliary' off, or take shorter blocks")};
    }
    axes_[a].controller.prepare(o.controller, o.path, rate);
    if (Status ok = axes_[a].gate.prepare(o.limits, rate); !ok) return ok;
    axes_[a].meter.prepare(o.lines, rate);
    axes_[a].tally.prepare(rate, o.limits.amplitude);
    axes_[a].before = ActuatorState::Off;
    axes_[a].online.prepare(o.online, rate);
    axes_[a].added.prepare(o.path);
    axes_[a].renewal.prepare(o.path, o.lines, rate);
    axes_[a].renewals = 0;
  }
  return Done{};
}

void ActiveLoop::engage() noexcept {
  for (Axis& axis : axes_) axis.gate.engage();
}

void ActiveLoop::release() noexcept {
  for (Axis& axis : axes_) axis.gate.release();
}

bool ActiveLoop::off() const noexcept {
  return std::ranges::all_of(axes_, [](const Axis& axis) { return axis.gate.state() == ActuatorState::Off; });
}

void ActiveLoop::begin() STILLCUT_RT {
  for (Axis& axis : axes_) axis.gate.renew();
}

safety::ActuatorCommand ActiveLoop::step(Axis& axis, double error) STILLCUT_RT {
  if (const PathModel* model = axis.renewed.read(); model != nullptr && axis.renewed.fresh()) {
    axis.controller.renew(*model);
    axis.added.renew(*model);
  }
  const double wanted = axis.controller.process(error);
  const double without = axis.controller.disturbance();
  double added = 0.0;
  const bool listening = axis.online.on() && axis.before == ActuatorState::On;
  if (listening) {
    axis.online.hear(error);
    added = axis.online.next();
  }
  // What we add ourselves is no fault of the control.
  const double uncontrolled = axis.online.on() ? without - axis.added.arrive() : without;
  const safety::ActuatorCommand command = axis.gate.pass(wanted + added, error, uncontrolled);
  const double stroke = command.value();
  if (axis.online.on()) axis.added.push(added);
  axis.controller.written(stroke, added);
  if (listening) axis.online.wrote(stroke);
  const ActuatorState state = axis.gate.state();
  // What an earlier time had learned, or had gone wrong, is no beginning. Also on letting go: weights that are no
  // numbers would end the next time in its first sample.
  const auto comes = [&](ActuatorState s) { return state == s && axis.before != s; };
  if (comes(ActuatorState::Off) || comes(ActuatorState::RampIn)) {
    axis.controller.reset();
    axis.online.reset();
    axis.added.reset();
  }
  if (comes(ActuatorState::RampIn)) {
    axis.meter.reset();
    axis.tally.reset();
  }
  axis.before = state;
  axis.meter.add(error, without);
  axis.tally.add(error, without, stroke, axis.gate.limited());
  return command;
}

void ActiveLoop::renewModels() {
  for (Axis& axis : axes_) {
    const std::vector<double>* impulse = axis.online.takeEstimate();
    if (impulse == nullptr) continue;
    auto model = axis.renewal.judge(*impulse);
    if (!model) continue;
    axis.renewed.back() = std::move(*model);
    axis.renewed.publish();
    ++axis.renewals;
  }
}

CommandPair ActiveLoop::step(const AxisPair& errors) STILLCUT_RT {
  CommandPair commands{};
  for (std::size_t a = 0; a < kActiveAxes; ++a) commands[a] = step(axes_[a], errors[a]);
  return commands;
}

void ActiveLoop::cut() STILLCUT_RT {
  for (Axis& axis : axes_) {
    axis.gate.cut();
    axis.controller.reset();
    axis.before = ActuatorState::Off;
  }
}

void ActiveLoop::setStep(double step) noexcept {
  for (Axis& axis : axes_) axis.controller.setStep(step);
}

void ActiveLoop::setLeak(double leak) noexcept {
  for (Axis& axis : axes_) axis.controller.setLeak(leak);
}

void ActiveLoop::tell(std::array<ActiveAxis, kActiveAxes>& axes) const STILLCUT_RT {
  for (std::size_t a = 0; a < kActiveAxes; ++a) {
    const Axis& from = axes_[a];
    ActiveAxis& to = axes[a];
    to.state = from.gate.state();
    to.release = from.gate.why();
    from.tally.tell(to);
    to.lineCount = from.meter.lines();
    for (int l = 0; l < to.lineCount; ++l) to.lines[static_cast<std::size_t>(l)] = from.meter.line(l);
  }
}

}  // namespace stillcut::active
