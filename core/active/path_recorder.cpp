#include "core/active/path_recorder.h"

#include <cmath>
#include <numbers>
#include <string>

namespace stillcut::active {

namespace {

constexpr double kSweepTop = 0.45;  // of the rate

}  // namespace

Status PathRecorder::prepare(const RecordRequest& request,
                             const std::array<safety::ActuatorLimits, kActiveAxes>& limits, Hertz rate) {
  if (!(request.duration.value >= 0.5 && request.duration.value <= 60.0)) {
    return Error{message("identification"), message("must take half a second to a minute")};
  }
  if (!(request.rms > 0.0 && request.rms <= 0.3)) {
    return Error{message("identification"), message("'rms' must be above 0 and at most 0.3 of the stroke"),
                 message("peaks reach three times it")};
  }
  request_ = request;
  length_ = static_cast<std::size_t>(std::llround(request.duration.value * rate.value));
  at_ = 0;
  released_ = false;
  noise_ = milling::NoiseSource(request.seed);
  for (std::size_t a = 0; a < kActiveAxes; ++a) {
    if (Status ok = gates_[a].prepare(limits[a], rate); !ok) return ok;
    tallies_[a].prepare(rate, limits[a].amplitude);
    amplitude_[a] = limits[a].amplitude;
    output_[a].assign(length_, 0.0);
    reading_[a].assign(length_, 0.0);
    gates_[a].engage();
  }
  return Done{};
}

void PathRecorder::begin() STILLCUT_RT {
  for (safety::ActuatorGate& gate : gates_) gate.renew();
}

// A sweep rises in a straight line of frequency, in each axis' own half of the record.
double PathRecorder::wanted(std::size_t axis) STILLCUT_RT {
  const double rms = request_.rms * amplitude_[axis];
  if (request_.excitation == Excitation::Noise) return rms * noise_.normal();
  const std::size_t half = length_ / kActiveAxes;
  const std::size_t first = axis * half;
  if (at_ < first || at_ >= first + half) return 0.0;
  const auto n = static_cast<double>(at_ - first);
  const double turns = 0.5 * kSweepTop * n * n / static_cast<double>(half);
  return std::numbers::sqrt2 * rms * std::sin(kTwoPi * turns);
}

CommandPair PathRecorder::step(const AxisPair& errors) STILLCUT_RT {
  CommandPair commands{};
  const bool recording = at_ < length_ && !released_;
  for (std::size_t a = 0; a < kActiveAxes; ++a) {
    commands[a] = gates_[a].drive(recording ? wanted(a) : 0.0, errors[a]);
    const double stroke = commands[a].value();
    tallies_[a].add(errors[a], errors[a], stroke, gates_[a].limited());
    if (!recording) continue;
    output_[a][at_] = stroke;
    reading_[a][at_] = -errors[a];
    if (gates_[a].state() == ActuatorState::RampOut) released_ = true;
  }
  if (recording && ++at_ == length_) release();
  if (released_) release();
  return commands;
}

void PathRecorder::release() noexcept {
  for (safety::ActuatorGate& gate : gates_) gate.release();
}

void PathRecorder::cut() STILLCUT_RT {
  for (safety::ActuatorGate& gate : gates_) gate.cut();
  released_ = true;
}

bool PathRecorder::over() const noexcept {
  const bool off = std::ranges::all_of(gates_, [](const auto& g) { return g.state() == ActuatorState::Off; });
  return off && (released_ || at_ >= length_);
}

void PathRecorder::tell(std::array<ActiveAxis, kActiveAxes>& axes) const STILLCUT_RT {
  for (std::size_t a = 0; a < kActiveAxes; ++a) {
    axes[a].state = gates_[a].state();
    axes[a].release = gates_[a].why();
    tallies_[a].tell(axes[a]);
    axes[a].lineCount = 0;
  }
}

Status PathRecorder::complete() const {
  if (at_ >= length_) return Done{};
  for (const safety::ActuatorGate& gate : gates_) {
    if (gate.why() != ActuatorRelease::None && gate.why() != ActuatorRelease::Asked) {
      return Error{message("identification"), message("ended before the record was whole"),
                   foreign(std::string(actuatorReleaseText(gate.why())))};
    }
  }
  return Error{message("identification"), message("ended before the record was whole"), message("it was stopped")};
}

std::span<const double> PathRecorder::part(std::size_t axis, const std::vector<double>& of) const {
  if (request_.excitation == Excitation::Noise) return of;
  const std::size_t half = length_ / kActiveAxes;
  return std::span(of).subspan(axis * half, half);
}

}  // namespace stillcut::active
