// Scenarios as TOML. Keys carry their unit; what a key means stands in scenario.h and sensors.h.

#include "core/config/quantity_toml.h"
#include "core/config/toml_reader.h"
#include "core/milling/model_toml.h"
#include "core/milling/simulation/scenario.h"

namespace stillcut::milling {

namespace {

using config::TomlTable;

constexpr double kMm = 1e3;       // per metre
constexpr double kUm = 1e6;       // per metre
constexpr double kPercent = 1e2;  // per one
constexpr double kMs = 1e3;       // per second

// One table for reading and writing where a number stands and in what unit.
Schedule readProfile(const TomlTable& t, double perUnit) {
  Schedule p;
  if (!t.present()) return p;
  p.along = t.choiceOr("along", 0, {"time", "path"}) == 0 ? Along::Time : Along::Path;
  const double position = p.along == Along::Time ? 1.0 : kMm;
  for (const TomlTable& g : t.tables("segment")) {
    ScheduleSegment s;
    s.from = inSi(g.number("from"), position);
    s.to = inSi(g.number("to"), position);
    if (g.has("value")) {
      s.fromValue = s.toValue = inSi(g.number("value"), perUnit);
    } else {
      s.fromValue = inSi(g.number("from_value"), perUnit);
      s.toValue = inSi(g.number("to_value"), perUnit);
    }
    s.shape = g.choiceOr("shape", 0, {"linear", "smoothstep"}) == 0 ? RampShape::Linear : RampShape::Smoothstep;
    p.segments.push_back(s);
  }
  return p;
}

std::optional<Passage> readPassage(const TomlTable& t, const char* atTime, const char* atPath) {
  if (t.has(atTime)) return Passage{Along::Time, t.number(atTime)};
  if (t.has(atPath)) return Passage{Along::Path, inSi(t.number(atPath), kMm)};
  return std::nullopt;
}

Programme readProgramme(const TomlTable& t) {
  Programme p;
  p.speed = Rpm(t.number("speed_rpm", 1.0, 2e5));
  p.feedPerTooth = Metres(inSi(t.number("feed_per_tooth_mm", 0.0, 10.0), kMm));
  p.duration = Seconds(t.number("duration_s", 1e-3, 3600.0));
  p.feedLag = Seconds(inSi(t.numberOr("feed_lag_ms", 30.0, 0.0, 1e4), kMs));
  p.randomForce = t.numberOr("random_force_n_per_sqrt_hz", 0.0, 0.0, 1e3);
  p.unevenness = t.numberOr("unevenness_per_sqrt_hz", 0.0, 0.0, 0.01);
  p.entry = readPassage(t, "entry_at_s", "entry_at_mm");
  p.exit = readPassage(t, "exit_at_s", "exit_at_mm");
  p.depth = readProfile(t.tableOr("depth_mm"), kMm);
  p.immersion = readProfile(t.tableOr("immersion"), 1.0);
  p.speedOverTime = readProfile(t.tableOr("programmed_speed_rpm"), 1.0);
  p.feedPerToothOverTime = readProfile(t.tableOr("programmed_feed_per_tooth_mm"), kMm);
  return p;
}

std::optional<WorkHolderSettings> readWorkHolder(const TomlTable& t) {
  if (!t.present()) return std::nullopt;
  WorkHolderSettings w;
  w.flexure = Hertz(t.numberOr("flexure_hz", w.flexure.value, 1.0, 1e5));
  w.damping = t.numberOr("damping", w.damping, 1e-4, 0.99);
  w.stiffness = t.numberOr("stiffness_n_per_m", w.stiffness, 1.0, 1e15);
  w.stroke = Metres(inSi(t.numberOr("stroke_um", w.stroke.value * kUm, 1e-3, 1000.0), kUm));
  w.reconstruction = Hertz(t.numberOr("reconstruction_hz", w.reconstruction.value, 1.0, 1e6));
  w.amplifier = Hertz(t.numberOr("amplifier_hz", w.amplifier.value, 1.0, 1e6));
  w.slew = t.numberOr("slew_m_per_s", w.slew, 1e-9, 1e3);
  if (t.has("quieten_hz")) {
    for (const double line : t.numbers("quieten_hz")) w.quieten.emplace_back(line);
  }
  return w;
}

DriveSettings readDrive(const TomlTable& t) {
  DriveSettings d;
  if (!t.present()) return d;
  d.inertia = t.numberOr("inertia_kg_m2", d.inertia);
  d.torqueLimit = t.numberOr("torque_limit_nm", d.torqueLimit);
  d.bandwidth = Hertz(t.numberOr("bandwidth_hz", d.bandwidth.value));
  d.torqueLoop = Hertz(t.numberOr("torque_loop_hz", d.torqueLoop.value, 0.0));
  d.acceleration = t.numberOr("acceleration_rpm_per_s", d.acceleration);
  d.torquePerAmpere = t.numberOr("torque_nm_per_a", d.torquePerAmpere);
  d.frictionTorque = t.numberOr("friction_nm", d.frictionTorque, 0.0, 1e6);
  return d;
}

// Two numbers, lowest and highest.
void readRange(const TomlTable& t, const char* key, double perUnit, double& low, double& high) {
  if (!t.has(key)) return;
  const std::vector<double> v = t.numbers(key);
  if (v.size() != 2) {
    t.refuse(key, message("a range is two numbers, lowest and highest"));
    return;
  }
  low = inSi(v[0], perUnit);
  high = inSi(v[1], perUnit);
}

OverrideSettings readOverrides(const TomlTable& t) {
  OverrideSettings o;
  if (!t.present()) return o;
  readRange(t, "speed_percent", kPercent, o.lowestSpeed.value, o.highestSpeed.value);
  readRange(t, "feed_percent", kPercent, o.lowestFeed.value, o.highestFeed.value);
  readRange(t, "delay_ms", kMs, o.shortestDelay.value, o.longestDelay.value);
  o.resolution = Ratio(inSi(t.numberOr("resolution_percent", o.resolution.value * kPercent, 0.0, 50.0), kPercent));
  return o;
}

SensorSettings readSensor(const TomlTable& t) {
  SensorSettings s;
  s.name = t.text("name");
  s.quantity = config::readQuantity(t);
  s.axis = t.textOr("axis", "");
  s.place = t.numbersOr("place", {});
  s.gain = t.numberOr("gain", 1.0);
  s.bandwidth = Hertz(t.numberOr("bandwidth_hz", 0.0, 0.0));
  s.noise = t.numberOr("noise", 0.0, 0.0);
  s.fullScale = t.numberOr("full_scale", 0.0, 0.0);
  s.step = t.numberOr("step", 0.0, 0.0);
  s.counts = t.numberOr("counts_per_turn", 0.0, 0.0);
  for (const std::vector<double>& e : t.has("echoes") ? t.rows("echoes") : std::vector<std::vector<double>>{}) {
    if (e.size() == 2) {
      s.echoes.push_back({Seconds(inSi(e[0], kMs)), e[1]});
    } else {
      t.refuse("echoes", message("an echo is two numbers, delay in ms and gain"));
    }
  }
  s.fault = static_cast<SensorFault>(t.choiceOr("fault", 0, {"none", "loose", "dead"}));
  s.faultFrom = Seconds(t.numberOr("fault_from_s", 0.0, 0.0));
  return s;
}

Scenario readScenario(const TomlTable& root) {
  Scenario s;
  s.name = root.text("name");
  s.description = root.textOr("description", "");
  s.machine = root.textOr("machine", "Simulated mill");
  s.tool = root.textOr("tool_name", "");
  s.expect = static_cast<Expectation>(root.choice("expect", {"stable", "no-stable-speed", "hold"}));
  s.strategy = root.textOr("strategy", s.strategy);
  s.grantsAuto = root.booleanOr("grants_auto", false);
  s.seed = static_cast<std::uint64_t>(root.integerOr("seed", 1, 1));
  s.model = readModel(root);
  s.programme = readProgramme(root.table("programme"));
  s.drive = readDrive(root.tableOr("drive"));
  s.workHolder = readWorkHolder(root.tableOr("work_holder"));
  s.overrides = readOverrides(root.tableOr("overrides"));
  const TomlTable sampling = root.table("sampling");
  s.rate = Hertz(sampling.number("rate_hz", 10.0, 1e6));
  s.blockFrames = sampling.integerOr("block_frames", s.blockFrames, 1, 65536);
  s.stepsPerRevolution = sampling.integerOr("steps_per_revolution", 0, 0, 1000000);
  s.helixSlices = sampling.integerOr("helix_slices", s.helixSlices, 1, 200);
  for (const TomlTable& t : root.tables("sensor")) s.sensors.push_back(readSensor(t));
  const TomlTable reference = root.tableOr("reference");
  for (const std::string& key : reference.keys()) s.reference[key] = reference.text(key);
  return s;
}

}  // namespace

Result<Scenario> loadScenario(const std::string& path) {
  const config::TomlReader in = config::TomlReader::file(path);
  if (in.error()) return *in.error();
  const Scenario s = readScenario(in.root());
  if (Status ok = in.finish(); !ok) return ok.error();
  if (Status ok = check(s, path); !ok) return ok.error();
  return s;
}

}  // namespace stillcut::milling
