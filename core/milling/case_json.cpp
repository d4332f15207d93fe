#include "core/milling/case_json.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace stillcut::milling {

namespace {

using Json = nlohmann::json;

// Everything a case says goes through these, so that what is missing or of the wrong kind is named.
struct Reader {
  std::string path;
  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    throw Error{path + ": " + key, what, ""};
  }
  double number(const Json& j, const std::string& key) const {
    if (!j.contains(key) || !j.at(key).is_number()) fail(key, "a number is needed");
    return j.at(key).get<double>();
  }
  double number(const Json& j, const std::string& key, double otherwise) const {
    return j.contains(key) && !j.at(key).is_null() ? number(j, key) : otherwise;
  }
  const Json& part(const Json& j, const std::string& key) const {
    if (!j.contains(key)) fail(key, "it is missing");
    return j.at(key);
  }
};

Mode modeFrom(const Reader& r, const Json& j) {
  Mode m;
  m.frequency = Hertz(r.number(j, "f"));
  m.damping = r.number(j, "zeta");
  const double w = kTwoPi * m.frequency.value;
  m.stiffness = j.contains("k") ? r.number(j, "k") : r.number(j, "m") * w * w;
  const Json& d = r.part(j, "d");
  if (!d.is_array() || d.size() != 2 || !d[0].is_number() || !d[1].is_number())
    r.fail("modes.d", "two numbers are needed");
  m.direction = {d[0].get<double>(), d[1].get<double>()};
  return m;
}

void readProcess(const Reader& r, const Json& j, Scenario& s) {
  Programme& p = s.programme;
  for (const Json& g : r.part(j, "depth_segments")) {
    ProfileSegment segment;
    segment.from = r.number(g, "from_s");
    segment.to = r.number(g, "to_s");
    segment.fromValue = r.number(g, "from_mm") / 1e3;
    segment.toValue = r.number(g, "to_mm") / 1e3;
    segment.shape = g.value("shape", "linear") == "smoothstep" ? RampShape::Smoothstep : RampShape::Linear;
    p.depth.segments.push_back(segment);
  }
  if (j.contains("tool_diameter_m")) s.model.tool.diameter = Metres(r.number(j, "tool_diameter_m"));
  if (j.contains("entry_from_s")) p.entry = Passage{Along::Time, r.number(j, "entry_from_s")};
  if (j.contains("exit_to_s")) p.exit = Passage{Along::Time, r.number(j, "exit_to_s")};
}

Scenario scenarioFrom(const Reader& r, const Json& j) {
  Scenario s;
  s.name = j.value("name", "case");
  s.description = j.value("description", "");
  s.machine = "Simulated mill";
  for (const Json& m : r.part(j, "modes")) s.model.modes.push_back(modeFrom(r, m));
  Tool& t = s.model.tool;
  t.teeth = static_cast<int>(r.number(j, "teeth"));
  t.helix = r.number(j, "helix_deg", 0.0) * kTwoPi / 360.0;
  const double runout = r.number(j, "runout_m", 0.0);
  if (runout != 0.0) {
    for (int i = 0; i < t.teeth; ++i) t.runout.emplace_back(runout * std::cos(kTwoPi * i / t.teeth + 0.4));
  }
  s.model.material.tangential = r.number(j, "Kt");
  s.model.material.radial = r.number(j, "Kn");
  s.model.engagement.radialImmersion = r.number(j, "aD");
  s.model.engagement.side = r.part(j, "up").get<bool>() ? Side::Up : Side::Down;
  s.programme.speed = Rpm(r.number(j, "spindle_rpm"));
  s.programme.feedPerTooth = Metres(r.number(j, "feed_per_tooth_m"));
  s.programme.duration = Seconds(r.number(j, "duration_s"));
  s.rate = Hertz(r.number(j, "fs"));
  readProcess(r, r.part(j, "process"), s);
  // The reference spindle does not give way, and is never told to.
  s.drive.inertia = 1e4;
  s.drive.torqueLimit = 1e6;
  // The reference tool is never quite at rest, not even in air: the vibration there (truth tables) is that of a white
  // random force of 1.6 mN rms per step and axis. In the cut it is livelier: c6 reaches 20 % when it should with the
  // cutting force uneven by 3e-4 per tick (c2 and c7b, which chatter from their own transients, do not care).
  s.programme.unevenness = 3e-4;
  s.programme.randomForce = 1.6e-3 / std::sqrt(0.5 * r.number(j, "sim_rate_hz", 4e5));
  const double gain = r.number(j, "sensor_gain", 1.0);
  for (const char* axis : {"x", "y"}) {
    SensorSettings c;
    c.name = c.axis = axis;
    c.gain = gain;
    c.noise = r.number(j, "sensor_noise_rms_m_s2", 0.0);
    s.sensors.push_back(c);
  }
  return s;
}

}  // namespace

Result<Scenario> loadCaseJson(const std::string& path) {
  std::ifstream in(path);
  if (!in) return Error{path, "cannot be opened", ""};
  try {
    const Scenario s = scenarioFrom(Reader{path}, Json::parse(in));
    if (Status ok = check(s, path); !ok) return ok.error();
    return s;
  } catch (const Error& e) {
    return e;
  } catch (const Json::exception& e) {
    return Error{path, e.what(), "not a case in JSON"};
  }
}

}  // namespace stillcut::milling
