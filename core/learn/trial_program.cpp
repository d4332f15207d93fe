#include "core/learn/trial_program.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace stillcut::learn {
namespace {

// Grbl ends the motion before a new S word acts: fewer, larger steps keep the marks of its stops apart.
constexpr double kStepLinuxCnc_s = 0.5;
constexpr double kStepGrbl_s = 1.0;

struct SweepStep {
  double speed = 0.0;  // [rev/min]
  double feed = 0.0;   // [mm/min]
  double to = 0.0;     // end of the step along X [mm]
};

double feedAt(const TrialProgram& t, double speed) {
  return 1e3 * t.feedPerTooth.value * t.teeth * speed;
}

std::vector<SweepStep> sweepSteps(const TrialProgram& t) {
  const double step = t.controller == Controller::Grbl ? kStepGrbl_s : kStepLinuxCnc_s;
  const double total = std::abs(std::log(t.lastSpeed / t.speed)) / std::log1p(t.sweepPerSecond);  // [s]
  const auto count = std::max(1, static_cast<int>(std::ceil(total / step)));
  std::vector<SweepStep> steps;
  double x = 0.0;
  for (int i = 0; i <= count; ++i) {
    SweepStep s;
    s.speed = t.speed.value * std::pow(t.lastSpeed / t.speed, static_cast<double>(i) / count);
    s.feed = feedAt(t, s.speed);
    x += s.feed / 60.0 * step;
    s.to = x;
    steps.push_back(s);
  }
  return steps;
}

std::string line(const char* form, double a, double b = 0.0, double c = 0.0) {
  char text[120];
  std::snprintf(text, sizeof text, form, a, b, c);
  return std::string(text) + "\n";
}

Status checkTrial(const TrialProgram& t) {
  const auto bad = [](Message what) { return Status(Error{message("trial"), std::move(what)}); };
  const auto above = [](double v, double most) { return std::isfinite(v) && v > 0.0 && v <= most; };
  if (t.teeth < 1 || t.teeth > 200) return bad(message("teeth must be 1 to 200"));
  if (!above(t.diameter.value, 1.0)) return bad(message("diameter must lie above 0 and up to 1000 mm"));
  if (!above(t.feedPerTooth.value, 0.01)) return bad(message("feed per tooth must lie above 0 and up to 10 mm"));
  if (!above(t.speed.value, 1e6)) return bad(message("speed must lie above 0 and up to 1e6 rpm"));
  if (!above(t.depth.value, 1.0)) return bad(message("depth must lie above 0 and up to 1000 mm"));
  if (!above(t.length.value, 100.0)) return bad(message("length must lie above 0 and up to 100 m"));
  if (!above(t.clearance.value, 1.0)) return bad(message("clearance must lie above 0 and up to 1000 mm"));
  if (t.kind == TrialKind::SpeedSweep) {
    if (!above(t.lastSpeed.value, 1e6)) return bad(message("a sweep needs the speed where it ends"));
    if (!above(t.sweepPerSecond, 0.2)) return bad(message("a sweep changes the speed by up to 20 % a second"));
    if (const Metres needed = lengthNeeded(t); needed > t.length) {
      return Error{message("trial"),
                   message("the sweep needs %1 mm of material", static_cast<long>(std::ceil(1e3 * needed.value))),
                   message("take a shorter range of speeds, or less feed")};
    }
  }
  if (t.kind == TrialKind::Incline && !(above(t.lastDepth.value, 1.0) && t.lastDepth > t.depth)) {
    return bad(message("an incline ends deeper than it begins"));
  }
  return Done{};
}

std::string heading(const TrialProgram& t) {
  const char* what = t.kind == TrialKind::Cut          ? "one straight cut"
                     : t.kind == TrialKind::SpeedSweep ? "sweep of the spindle speed at constant depth"
                                                       : "inclined cut, the depth rises along X";
  std::string text = std::string("(Stillcut trial: ") + what + ")\n";
  text += line("(from X0 to X%.3f at Y0, Z0 is the top of the stock)", 1e3 * t.length.value);
  text += line("(tool %.3f mm, with the work offset and the tool length that are in force)", 1e3 * t.diameter.value);
  text += "(run it in air first; hand on the feed hold)\n";
  if (t.kind == TrialKind::SpeedSweep) {
    text += t.controller == Controller::Grbl ? "(Grbl halts the axes for an instant at each new speed)\n"
                                             : "(the axes may hesitate at each new speed)\n";
  }
  return text;
}

// Of the tool's axis from the stock where the tool is clear of it [mm].
double clearOf(const TrialProgram& t) {
  return 1e3 * (0.5 * t.diameter.value + t.clearance.value);
}

std::string cutting(const TrialProgram& t) {
  const double end = 1e3 * t.length.value + clearOf(t);
  const double feed = feedAt(t, t.speed.value);
  std::string text;
  if (t.kind == TrialKind::Cut) text += line("G1 X%.3f F%.1f", end, feed);
  if (t.kind == TrialKind::Incline) {
    text += line("G1 X0.000 F%.1f", feed);
    text += line("G1 X%.3f Z%.4f F%.1f", 1e3 * t.length.value, -1e3 * t.lastDepth.value, feed);
    text += line("G1 X%.3f F%.1f", end, feed);
  }
  if (t.kind == TrialKind::SpeedSweep) {
    text += line("G1 X0.000 F%.1f", feed);
    for (const SweepStep& s : sweepSteps(t)) {
      text += line("S%.0f", s.speed);
      text += line("G1 X%.3f F%.1f", s.to, s.feed);
    }
    text += line("G1 X%.3f", end);
  }
  return text;
}

}  // namespace

Metres lengthNeeded(const TrialProgram& trial) {
  if (trial.kind != TrialKind::SpeedSweep || !(trial.speed.value > 0.0) || !(trial.lastSpeed.value > 0.0)) return {};
  return Metres(1e-3 * sweepSteps(trial).back().to);
}

Result<std::string> trialGCode(const TrialProgram& trial) {
  if (Status ok = checkTrial(trial); !ok) return ok.error();
  const double safe = 1e3 * trial.clearance.value;
  std::string text = heading(trial);
  text +=
      trial.controller == Controller::LinuxCnc ? "G21 G17 G40 G80 G90 G94\nG64 P0.01\n" : "G21 G17 G40 G80 G90 G94\n";
  text += line("G0 Z%.3f", safe);
  text += line("G0 X%.3f Y0.000", -clearOf(trial));
  text += line("S%.0f M3", trial.speed.value);
  text += line("G4 P%.1f", trial.runUp.value);
  text += line("G1 Z%.4f F%.1f", -1e3 * trial.depth.value, feedAt(trial, trial.speed.value));
  text += cutting(trial);
  text += line("G0 Z%.3f", safe);
  return text + "M5\nM2\n";
}

}  // namespace stillcut::learn
