// Writing a scenario as TOML; scenario_toml.cpp reads it back.
#include "core/milling/model_toml.h"
#include "core/milling/simulation/scenario.h"
#include "core/storage/atomic_file.h"

namespace stillcut::milling {

namespace {

constexpr double kMm = 1e3;
constexpr double kPercent = 1e2;
constexpr double kMs = 1e3;

std::string quoted(const std::string& text) {
  std::string s = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') s += '\\';
    s += c == '\n' ? ' ' : c;
  }
  return s + "\"";
}

std::string line(const char* key, double value, double perUnit = 1.0) {
  return std::string(key) + " = " + numberText(value, perUnit) + "\n";
}

std::string range(const char* key, double low, double high, double perUnit) {
  return std::string(key) + " = [" + numberText(low, perUnit) + ", " + numberText(high, perUnit) + "]\n";
}

std::string profileText(const char* table, const Schedule& p, double perUnit) {
  if (p.empty()) return {};
  const double position = p.along == Along::Time ? 1.0 : kMm;
  const std::string head = std::string("programme.") + table;
  std::string s = "[" + head + "]\nalong = " + (p.along == Along::Time ? "\"time\"\n\n" : "\"path\"\n\n");
  for (const ScheduleSegment& g : p.segments) {
    s += "[[" + head + ".segment]]\n" + line("from", g.from, position) + line("to", g.to, position);
    if (g.fromValue == g.toValue) {
      s += line("value", g.fromValue, perUnit);
    } else {
      s += line("from_value", g.fromValue, perUnit) + line("to_value", g.toValue, perUnit);
    }
    if (g.shape == RampShape::Smoothstep) s += "shape = \"smoothstep\"\n";
    s += "\n";
  }
  return s;
}

std::string passageText(const char* name, const std::optional<Passage>& p) {
  if (!p) return {};
  const std::string key(name);
  return p->along == Along::Time ? line((key + "_at_s").c_str(), p->at) : line((key + "_at_mm").c_str(), p->at, kMm);
}

std::string programmeText(const Programme& p) {
  return "[programme]\n" + line("speed_rpm", p.speed.value) + line("feed_per_tooth_mm", p.feedPerTooth.value, kMm) +
         line("duration_s", p.duration.value) + line("feed_lag_ms", p.feedLag.value, kMs) +
         line("random_force_n_per_sqrt_hz", p.randomForce) + line("unevenness_per_sqrt_hz", p.unevenness) +
         passageText("entry", p.entry) + passageText("exit", p.exit) + "\n" + profileText("depth_mm", p.depth, kMm) +
         profileText("immersion", p.immersion, 1.0) + profileText("programmed_speed_rpm", p.speedOverTime, 1.0) +
         profileText("programmed_feed_per_tooth_mm", p.feedPerToothOverTime, kMm);
}

std::string workHolderText(const WorkHolderSettings& w) {
  std::string lines;
  for (const Hertz f : w.quieten) lines += (lines.empty() ? "" : ", ") + numberText(f.value, 1.0);
  if (!lines.empty()) lines = "quieten_hz = [" + lines + "]\n";
  return "[work_holder]\n" + line("flexure_hz", w.flexure.value) + line("damping", w.damping) +
         line("stiffness_n_per_m", w.stiffness) + line("stroke_um", w.stroke.value, 1e6) +
         line("reconstruction_hz", w.reconstruction.value) + line("amplifier_hz", w.amplifier.value) +
         line("slew_m_per_s", w.slew) + lines + "\n";
}

std::string drivesText(const DriveSettings& d, const OverrideSettings& o) {
  return "[drive]\n" + line("inertia_kg_m2", d.inertia) + line("torque_limit_nm", d.torqueLimit) +
         line("bandwidth_hz", d.bandwidth.value) + line("torque_loop_hz", d.torqueLoop.value) +
         line("acceleration_rpm_per_s", d.acceleration) + line("torque_nm_per_a", d.torquePerAmpere) +
         line("friction_nm", d.frictionTorque) + "\n[overrides]\n" +
         range("speed_percent", o.lowestSpeed.value, o.highestSpeed.value, kPercent) +
         range("feed_percent", o.lowestFeed.value, o.highestFeed.value, kPercent) +
         line("resolution_percent", o.resolution.value, kPercent) +
         range("delay_ms", o.shortestDelay.value, o.longestDelay.value, kMs) + "\n";
}

std::string sensorText(const SensorSettings& c) {
  std::string s = "[[sensor]]\nname = " + quoted(c.name) + "\nquantity = \"" + std::string(name(c.quantity)) + "\"\n";
  if (!c.axis.empty()) s += "axis = " + quoted(c.axis) + "\n";
  if (!c.place.empty()) {
    s += "place = [";
    for (std::size_t i = 0; i < c.place.size(); ++i) s += (i > 0 ? ", " : "") + numberText(c.place[i]);
    s += "]\n";
  }
  s += line("gain", c.gain) + line("bandwidth_hz", c.bandwidth.value) + line("noise", c.noise) +
       line("full_scale", c.fullScale) + line("step", c.step) + line("counts_per_turn", c.counts);
  if (!c.echoes.empty()) {
    s += "echoes = [";
    for (std::size_t i = 0; i < c.echoes.size(); ++i) {
      const Echo& e = c.echoes[i];
      s += (i > 0 ? ", [" : "[") + numberText(e.delay.value, kMs) + ", " + numberText(e.gain) + "]";
    }
    s += "]\n";
  }
  if (c.fault != SensorFault::None) {
    s += std::string("fault = ") + (c.fault == SensorFault::Loose ? "\"loose\"\n" : "\"dead\"\n") +
         line("fault_from_s", c.faultFrom.value);
  }
  return s + "\n";
}

}  // namespace

std::string scenarioText(const Scenario& s) {
  std::string text = "name = " + quoted(s.name) + "\ndescription = " + quoted(s.description) +
                     "\nmachine = " + quoted(s.machine) + "\ntool_name = " + quoted(s.tool) + "\nexpect = \"" +
                     std::string(name(s.expect)) + "\"\nstrategy = " + quoted(s.strategy) +
                     "\ngrants_auto = " + (s.grantsAuto ? "true" : "false") + "\nseed = " + std::to_string(s.seed) +
                     "\n\n";
  text += modelText(s.model) + programmeText(s.programme) + drivesText(s.drive, s.overrides);
  if (s.workHolder) text += workHolderText(*s.workHolder);
  text += "[sampling]\n" + line("rate_hz", s.rate.value) + "block_frames = " + std::to_string(s.blockFrames) +
          "\nsteps_per_revolution = " + std::to_string(s.stepsPerRevolution) +
          "\nhelix_slices = " + std::to_string(s.helixSlices) + "\n\n";
  for (const SensorSettings& c : s.sensors) text += sensorText(c);
  if (!s.reference.empty()) text += "[reference]\n";
  for (const auto& [key, value] : s.reference) text += quoted(key) + " = " + quoted(value) + "\n";
  return text;
}

Status saveScenario(const Scenario& scenario, const std::string& path) {
  return writeFileAtomically(path, scenarioText(scenario));
}

}  // namespace stillcut::milling
