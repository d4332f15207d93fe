#include "core/milling/simulation/case_json.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/milling/simulation/case_process.h"

namespace stillcut::milling {

namespace {

using Json = nlohmann::json;

// Per step of the reference; see the header.
constexpr double kRandomForce = 1.8e-3;  // [N]
constexpr double kUnevenness = 6e-4;     // of the cutting force

double numberOr(const Json& j, const std::string& key, const std::string& where, double otherwise) {
  return j.contains(key) && !j.at(key).is_null() ? caseNumber(j, key, where) : otherwise;
}

Mode modeFrom(const Json& j, const std::string& where) {
  Mode m;
  m.frequency = Hertz(caseNumber(j, "f", where));
  m.damping = caseNumber(j, "zeta", where);
  const double w = kTwoPi * m.frequency.value;
  m.stiffness = j.contains("k") ? caseNumber(j, "k", where) : caseNumber(j, "m", where) * w * w;
  const Json d = j.value("d", Json());
  if (!d.is_array() || d.size() != 2 || !d[0].is_number() || !d[1].is_number())
    throw Error{where + ".d", message("two numbers are needed")};
  m.direction = {d[0].get<double>(), d[1].get<double>()};
  return m;
}

void readModel(const Json& j, const std::string& where, CutModel& model) {
  if (!j.contains("modes") || !j.at("modes").is_array()) throw Error{where + "modes", message("a list is needed")};
  for (const Json& m : j.at("modes")) {
    model.modes.push_back(modeFrom(m, where + "modes[" + std::to_string(model.modes.size()) + "]"));
  }
  Tool& t = model.tool;
  t.teeth = static_cast<int>(caseNumber(j, "teeth", where));
  t.helix = numberOr(j, "helix_deg", where, 0.0) * kTwoPi / 360.0;
  const double runout = numberOr(j, "runout_m", where, 0.0);
  if (runout != 0.0) {
    for (int i = 0; i < t.teeth; ++i) t.runout.emplace_back(runout * std::cos(kTwoPi * i / t.teeth + 0.4));
  }
  model.material.tangential = caseNumber(j, "Kt", where);
  model.material.radial = caseNumber(j, "Kn", where);
  model.engagement.radialImmersion = caseNumber(j, "aD", where);
  if (!j.contains("up") || !j.at("up").is_boolean()) throw Error{where + "up", message("true or false is needed")};
  model.engagement.side = j.at("up").get<bool>() ? MillingDirection::Up : MillingDirection::Down;
}

// Leaves of the document as text, but for those that have become part of the scenario.
void keep(const Json& node, const std::string& key, std::map<std::string, std::string>& out) {
  static const std::set<std::string> kTaken{"name",
                                            "description",
                                            "fs",
                                            "teeth",
                                            "spindle_rpm",
                                            "feed_per_tooth_m",
                                            "runout_m",
                                            "helix_deg",
                                            "Kt",
                                            "Kn",
                                            "aD",
                                            "up",
                                            "modes",
                                            "duration_s",
                                            "sensor_gain",
                                            "process-entry_from_s",
                                            "process-exit_to_s",
                                            "process-tool_diameter_m",
                                            "sensor_noise_rms_m_s2"};
  if (kTaken.contains(key) || (key.starts_with("process-") && key.ends_with("_segments"))) return;
  if (node.is_structured()) {
    for (const auto& item : node.items()) keep(item.value(), key.empty() ? item.key() : key + "-" + item.key(), out);
    return;
  }
  out[key] = node.is_string() ? node.get<std::string>() : node.dump();
}

// Spindle and feed are where the programme says, whatever the cut does.
void followTheProgramme(Scenario& s) {
  s.programme.feedLag = Seconds(0.0);
  s.drive.inertia = 1e4;
  s.drive.torqueLimit = 1e12;
  s.drive.acceleration = 1e9;
}

Scenario scenarioFrom(const Json& j, const std::string& path) {
  const std::string where = path + ": ";
  Scenario s;
  s.name = j.value("name", "case");
  s.description = j.value("description", "");
  s.machine = "Simulated mill";
  readModel(j, where, s.model);
  s.programme.speed = Rpm(caseNumber(j, "spindle_rpm", where));
  s.programme.feedPerTooth = Metres(caseNumber(j, "feed_per_tooth_m", where));
  s.programme.duration = Seconds(caseNumber(j, "duration_s", where));
  s.rate = Hertz(caseNumber(j, "fs", where));
  readCaseProcess(j.value("process", Json()), where + "process", s);
  followTheProgramme(s);
  const double perStep = 1.0 / std::sqrt(0.5 * numberOr(j, "sim_rate_hz", where, 16.0 * s.rate.value));
  s.programme.unevenness = kUnevenness * perStep;
  s.programme.randomForce = kRandomForce * perStep;
  for (const char* axis : {"x", "y"}) {
    SensorSettings c;
    c.name = c.axis = axis;
    c.gain = numberOr(j, "sensor_gain", where, 1.0);
    c.noise = numberOr(j, "sensor_noise_rms_m_s2", where, 0.0);
    s.sensors.push_back(c);
  }
  keep(j, "", s.reference);
  return s;
}

}  // namespace

Result<Scenario> loadCaseJson(const std::string& path) {
  std::ifstream in(path);
  if (!in) return Error{path, message("cannot be opened")};
  try {
    const Scenario s = scenarioFrom(Json::parse(in), path);
    if (Status ok = check(s, path); !ok) return ok.error();
    return s;
  } catch (const Error& e) {
    return e;
  } catch (const Json::exception& e) {
    return Error{path, foreign(e.what()), message("not a case in JSON")};
  }
}

}  // namespace stillcut::milling
