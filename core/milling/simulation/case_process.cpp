#include "core/milling/simulation/case_process.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string_view>

namespace stillcut::milling {

namespace {

using Json = nlohmann::json;

[[noreturn]] void fail(const std::string& place, Message what) {
  throw Error{place, what};
}

enum class Quantity { Depth, Immersion, Speed, Feed };

std::optional<Quantity> quantityOf(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Quantity>, 14> kNames{{{"depth", Quantity::Depth},
                                                                          {"axial_depth", Quantity::Depth},
                                                                          {"immersion", Quantity::Immersion},
                                                                          {"radial_immersion", Quantity::Immersion},
                                                                          {"radial_depth", Quantity::Immersion},
                                                                          {"aD", Quantity::Immersion},
                                                                          {"ae", Quantity::Immersion},
                                                                          {"speed", Quantity::Speed},
                                                                          {"spindle", Quantity::Speed},
                                                                          {"spindle_speed", Quantity::Speed},
                                                                          {"spindle_rpm", Quantity::Speed},
                                                                          {"rpm", Quantity::Speed},
                                                                          {"feed", Quantity::Feed},
                                                                          {"feed_per_tooth", Quantity::Feed}}};
  const auto* it = std::find_if(kNames.begin(), kNames.end(), [&](const auto& n) { return n.first == name; });
  if (it == kNames.end()) return std::nullopt;
  return it->second;
}

// Value of one end in the unit that the profile counts in (m, ratio, rev/min, m per tooth).
double inProfileUnit(Quantity q, double value, const std::string& unit, const Scenario& s, const std::string& place) {
  const bool mm = unit == "mm" || unit == "mm_per_tooth", metres = unit == "m" || unit == "m_per_tooth";
  const double length = unit == "um" ? value / 1e6 : mm ? value / 1e3 : value;
  switch (q) {
    case Quantity::Depth:
      if (mm || metres || unit == "um") return length;
      break;
    case Quantity::Immersion:
      if (mm || metres) return length / s.model.tool.diameter.value;
      if (unit == "percent") return value / 1e2;
      if (unit == "aD" || unit == "ratio" || unit == "immersion" || unit == "radial_immersion") return value;
      break;
    case Quantity::Speed:
      if (unit == "rpm" || unit == "rev_min") return value;
      if (unit == "hz") return value * 60.0;
      break;
    case Quantity::Feed:
      if (mm || metres || unit == "um") return length;
      if (unit == "m_per_s") return value / (s.model.tool.teeth * s.programme.speed.value / 60.0);
      break;
  }
  fail(place, message("the unit '%1' is not understood", unit));
}

// The unit of "from_mm" is "mm"; times are counted in s and set apart.
std::string unitOf(const Json& segment, const std::string& place) {
  for (const auto& item : segment.items()) {
    const std::string& key = item.key();
    if (key.starts_with("from_") && key != "from_s") return key.substr(5);
  }
  fail(place, message("a value from_UNIT is needed"));
}

RampShape shapeOf(const Json& segment, const std::string& place) {
  const std::string shape = segment.value("shape", "linear");
  if (shape == "smoothstep") return RampShape::Smoothstep;
  if (shape != "linear" && shape != "constant") fail(place, message("the shape '%1' is not understood", shape));
  return RampShape::Linear;
}

Schedule readSegments(Quantity q, const Json& list, const std::string& where, const Scenario& s) {
  if (!list.is_array()) fail(where, message("a list is needed"));
  Schedule p;
  for (const Json& g : list) {
    const std::string place = where + "[" + std::to_string(p.segments.size()) + "]";
    const std::string unit = unitOf(g, place);
    const auto end = [&](const std::string& which) {
      return inProfileUnit(q, caseNumber(g, which + unit, place), unit, s, place);
    };
    p.segments.push_back(
        {caseNumber(g, "from_s", place), caseNumber(g, "to_s", place), end("from_"), end("to_"), shapeOf(g, place)});
  }
  return p;
}

// The angles must be those of an up or down cut, which is what an engagement can say.
void readAngles(const Json& process, const std::string& where, Engagement& e) {
  const double start = caseNumber(process, "phi_st_in_cut", where), exit = caseNumber(process, "phi_ex_in_cut", where);
  constexpr double kClose = 1e-9;
  if (std::abs(start) < kClose) {
    e = {0.5 * (1.0 - std::cos(exit)), MillingDirection::Up};
  } else if (std::abs(exit - std::numbers::pi) < kClose) {
    e = {0.5 * (1.0 + std::cos(start)), MillingDirection::Down};
  } else {
    fail(where + ".phi_st_in_cut", message("the cut must begin at 0 or end at pi"));
  }
}

bool changesTheCut(const Json& value) {
  return value.is_array() && !value.empty() && value.front().is_structured();
}

}  // namespace

double caseNumber(const Json& object, const std::string& key, const std::string& where) {
  if (!object.contains(key) || !object.at(key).is_number()) fail(where + "." + key, message("a number is needed"));
  return object.at(key).get<double>();
}

void readCaseProcess(const Json& process, const std::string& where, Scenario& s) {
  Programme& p = s.programme;
  if (!process.is_object() || !process.contains("depth_segments"))
    fail(where + ".depth_segments", message("it is missing"));
  if (process.contains("tool_diameter_m")) {
    s.model.tool.diameter = Metres(caseNumber(process, "tool_diameter_m", where));
  }
  if (process.contains("phi_st_in_cut")) {
    const double said = s.model.engagement.radialImmersion;
    readAngles(process, where, s.model.engagement);
    // The same to within rounding: what the file says in plain numbers stays as it is.
    if (std::abs(s.model.engagement.radialImmersion - said) < 1e-9) s.model.engagement.radialImmersion = said;
  }
  if (process.contains("entry_from_s")) p.entry = Passage{Along::Time, caseNumber(process, "entry_from_s", where)};
  if (process.contains("exit_to_s")) p.exit = Passage{Along::Time, caseNumber(process, "exit_to_s", where)};
  constexpr std::string_view kSegments = "_segments";
  for (const auto& item : process.items()) {
    const std::string place = where + "." + item.key();
    const auto quantity = item.key().ends_with(kSegments)
                              ? quantityOf(item.key().substr(0, item.key().size() - kSegments.size()))
                              : std::nullopt;
    if (!quantity) {
      if (changesTheCut(item.value())) fail(place, message("this kind of list is not understood"));
      continue;
    }
    const Schedule profile = readSegments(*quantity, item.value(), place, s);
    switch (*quantity) {
      case Quantity::Depth:
        p.depth = profile;
        break;
      case Quantity::Immersion:
        p.immersion = profile;
        break;
      case Quantity::Speed:
        p.speedOverTime = profile;
        break;
      case Quantity::Feed:
        p.feedPerToothOverTime = profile;
        break;
    }
  }
}

}  // namespace stillcut::milling
