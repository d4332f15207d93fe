#include "core/milling/simulation/scenario.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stillcut::milling {

namespace {
constexpr std::array<std::string_view, 3> kExpectations{"stable", "no-stable-speed", "hold"};

double highestMode(const CutModel& m) {
  double top = 0.0;
  for (const Mode& mode : m.modes) top = std::max(top, mode.frequency.value);
  return top;
}

Status checkSensor(const Scenario& s, const SensorSettings& c, const std::string& place) {
  const auto bad = [&](const Message& what) { return Status(Error{place, what}); };
  if (c.name.empty()) return bad(message("a sensor needs a name"));
  if (!c.axis.empty() && c.axis != "x" && c.axis != "y") return bad(message("axis must be x or y"));
  if (!c.place.empty() && c.place.size() != s.model.modes.size())
    return bad(message("place needs one weight per mode"));
  if (!(c.gain != 0.0) || !std::isfinite(c.gain)) return bad(message("gain must not be zero"));
  for (double v : {c.noise, c.fullScale, c.step, c.counts, c.bandwidth.value}) {
    if (!(v >= 0.0) || !std::isfinite(v))
      return bad(message("noise, full scale, step, counts and bandwidth must not be negative"));
  }
  for (const Echo& e : c.echoes) {
    if (!(e.delay.value >= 0.0) || e.delay.value > 1.0)
      return bad(message("an echo's delay must lie between 0 and 1 s"));
  }
  return Done{};
}

Status checkProgramme(const Scenario& s, const std::string& where) {
  const Programme& p = s.programme;
  const auto bad = [&](const Message& what) { return Status(Error{where, what}); };
  if (!(p.speed.value >= 1.0) || p.speed.value > 200000.0)
    return bad(message("speed must lie between 1 and 200000 rpm"));
  if (!(p.feedPerTooth.value >= 0.0) || p.feedPerTooth.value > 0.01)
    return bad(message("feed per tooth must lie between 0 and 10 mm"));
  if (!(p.duration.value > 0.0) || p.duration.value > 3600.0)
    return bad(message("duration must lie between 0 and 3600 s"));
  if (!(p.feedLag.value >= 0.0) || p.feedLag.value > 10.0) return bad(message("feed lag must lie between 0 and 10 s"));
  if (!(p.randomForce >= 0.0) || p.randomForce > 1e3)
    return bad(message("random force must lie between 0 and 1000 N/sqrt(Hz)"));
  if (!(p.unevenness >= 0.0) || p.unevenness > 0.01)
    return bad(message("unevenness must lie between 0 and 0.01 / sqrt(Hz)"));
  if (Status r = check(p.depth, 0.0, 1.0, where + ": depth"); !r) return r;
  if (Status r = check(p.immersion, 0.0, 1.0, where + ": immersion"); !r) return r;
  if (Status r = check(p.feedPerToothOverTime, 0.0, 0.01, where + ": feed per tooth"); !r) return r;
  return check(p.speedOverTime, 1.0, 200000.0, where + ": speed");
}

Status checkDrives(const Scenario& s, const std::string& where) {
  const DriveSettings& d = s.drive;
  const OverrideSettings& o = s.overrides;
  for (double v : {d.inertia, d.torqueLimit, d.bandwidth.value, d.acceleration, d.torquePerAmpere}) {
    if (!(v > 0.0) || !std::isfinite(v)) return Error{where + ": drive", message("every value must be above zero")};
  }
  if (!(d.torqueLoop.value >= 0.0) || !std::isfinite(d.torqueLoop.value)) {
    return Error{where + ": drive", message("the torque loop's bandwidth must not be negative")};
  }
  if (!(o.lowestSpeed.value > 0.0) || o.lowestSpeed > o.highestSpeed || o.highestSpeed.value > 3.0) {
    return Error{where + ": overrides", message("the speed range must rise from above 0 to at most 300 %")};
  }
  if (!(o.lowestFeed.value >= 0.0) || o.lowestFeed > o.highestFeed || o.highestFeed.value > 3.0) {
    return Error{where + ": overrides", message("the feed range must rise from 0 or more to at most 300 %")};
  }
  if (!(o.shortestDelay.value >= 0.0) || o.longestDelay < o.shortestDelay || o.longestDelay.value > 10.0) {
    return Error{where + ": overrides", message("the delays must rise from 0 or more to at most 10 s")};
  }
  return Done{};
}
}  // namespace

std::string_view name(Expectation e) {
  return kExpectations[static_cast<std::size_t>(e)];
}

MetresPerSecond Scenario::programmedFeed(Rpm at, double seconds, double path) const {
  const double perTooth = programme.feedPerToothOverTime.at(seconds, path, programme.feedPerTooth.value);
  return MetresPerSecond(perTooth * model.tool.teeth * at.value / 60.0);
}

CutSetup Scenario::cutSetup() const {
  CutSetup c;
  c.machine = machine;
  c.tool = tool;
  c.teeth = model.tool.teeth;
  c.toolDiameter = model.tool.diameter;
  c.nominalSpeed = programme.speed;
  c.nominalFeed = programmedFeed(programme.speed);
  c.rate = rate;
  c.blockFrames = blockFrames;
  for (const SensorSettings& s : sensors) c.channels.push_back({s.name, s.quantity, 1.0 / s.gain, s.axis});
  return c;
}

int Scenario::chosenSteps() const {
  const int unit = 32 * model.tool.teeth;
  double steps = stepsPerRevolution;
  if (stepsPerRevolution == 0) {
    const double slowest = programme.speedOverTime.lowest(programme.speed.value) / 60.0;
    steps = std::max({2048.0, 40.0 * highestMode(model) / slowest, 4.0 * rate.value / slowest});
  }
  return static_cast<int>(std::ceil(std::min(steps, 1e6) / unit)) * unit;
}

Status check(const Scenario& s, const std::string& where) {
  if (Status r = check(s.model, where); !r) return r;
  if (isShaped(s.model.tool)) {
    return Error{where + ": tool", message("the simulation takes no corner radius and no serration"),
                 message("lobes and advice do")};
  }
  if (s.workHolder) {
    if (Status r = check(*s.workHolder, where); !r) return r;
  }
  if (s.model.modes.size() + (s.workHolder ? 2 : 0) > kMaxModes) {
    return Error{where, message("at most %1 modes can be simulated", std::to_string(kMaxModes))};
  }
  if (Status r = checkProgramme(s, where + ": programme"); !r) return r;
  if (Status r = checkDrives(s, where); !r) return r;
  if (!(s.rate.value >= 10.0) || s.rate.value > 1e6)
    return Error{where, message("rate must lie between 10 Hz and 1 MHz")};
  if (s.blockFrames < 1 || s.blockFrames > 65536)
    return Error{where, message("block frames must lie between 1 and 65536")};
  if (s.sensors.empty() || s.sensors.size() > 32) return Error{where, message("1 to 32 sensors are needed")};
  for (std::size_t i = 0; i < s.sensors.size(); ++i) {
    if (Status r = checkSensor(s, s.sensors[i], where + ": sensor " + std::to_string(i + 1)); !r) return r;
  }
  if (s.stepsPerRevolution < 0 || s.stepsPerRevolution > 1000000) {
    return Error{where, message("steps per revolution must lie between 0 (automatic) and 1000000")};
  }
  if (s.helixSlices < 1 || s.helixSlices > 200) return Error{where, message("helix slices must lie between 1 and 200")};
  return Done{};
}

}  // namespace stillcut::milling
