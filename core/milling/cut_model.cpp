#include "core/milling/cut_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

namespace stillcut::milling {

namespace {

constexpr double kNoMotion = 1e-9;  // of a mode's size: rounding

double sizeOf(const Mode& m) {
  return std::hypot(m.direction[0], m.direction[1], m.directionZ);
}

}  // namespace

double helixOf(const Tool& tool, int tooth) {
  return tool.toothHelix.empty() ? tool.helix : tool.toothHelix[static_cast<std::size_t>(tooth)];
}

double pitchAfter(const Tool& tool, int tooth) {
  return tool.pitch.empty() ? kTwoPi / tool.teeth : tool.pitch[static_cast<std::size_t>(tooth)];
}

double Engagement::startAngle() const {
  if (offset) return std::acos(std::clamp(*offset + radialImmersion, -1.0, 1.0));
  return side == MillingDirection::Up ? 0.0 : std::numbers::pi - std::acos(1.0 - 2.0 * radialImmersion);
}

double Engagement::exitAngle() const {
  if (offset) return std::acos(std::clamp(*offset - radialImmersion, -1.0, 1.0));
  return side == MillingDirection::Up ? std::acos(1.0 - 2.0 * radialImmersion) : std::numbers::pi;
}

double processDampingOf(double indentationPerVolume, Metres wearLand) {
  return 0.5 * indentationPerVolume * wearLand.value * wearLand.value;
}

Engagement engagementBetween(double startAngle, double exitAngle) {
  const double from = std::cos(startAngle), to = std::cos(exitAngle);
  const double offset = 0.5 * (from + to);
  return {0.5 * (from - to), offset >= 0.0 ? MillingDirection::Up : MillingDirection::Down, offset};
}

bool isShaped(const Tool& tool) {
  return tool.cornerRadius.value > 0.0 || tool.serration.has_value();
}

bool takesPart(const Mode& mode) {
  return mode.direction[0] != 0.0 || mode.direction[1] != 0.0;
}

bool changesWithSpeed(const CutModel& model) {
  return std::any_of(model.modes.begin(), model.modes.end(), [](const Mode& m) { return !m.atSpeeds.empty(); });
}

CutModel modelAt(CutModel model, Rpm speed) {
  for (Mode& m : model.modes) {
    const std::vector<ModeAtSpeed> table = std::exchange(m.atSpeeds, {});
    if (table.empty()) continue;
    std::size_t next = 0;
    while (next < table.size() && table[next].speed < speed) ++next;
    const ModeAtSpeed& high = table[std::min(next, table.size() - 1)];
    const ModeAtSpeed& low = table[next > 0 ? next - 1 : 0];
    const double into = high.speed > low.speed ? std::min(1.0, (speed - low.speed) / (high.speed - low.speed)) : 0.0;
    m.frequency = low.frequency + into * (high.frequency - low.frequency);
    m.damping = low.damping + into * (high.damping - low.damping);
    m.stiffness = low.stiffness + into * (high.stiffness - low.stiffness);
  }
  return model;
}

double chipPerFeed(const CutModel& model) {
  return model.turning ? std::sin(model.turning->edgeAngle) : 1.0;
}

CutModel standingTooth(const CutModel& model) {
  if (!model.turning) return model;
  CutModel standing = model;
  const double kappa = model.turning->edgeAngle;
  for (Mode& m : standing.modes) {
    const double across = std::sin(kappa) * m.direction[0] + std::cos(kappa) * m.direction[1];
    m.direction = {std::abs(across) < kNoMotion * sizeOf(m) ? 0.0 : across, m.directionZ};
    m.directionZ = 0.0;
  }
  Material& k = standing.material;
  for (double* force : {&k.tangential, &k.radial, &k.tangentialEdge, &k.radialEdge, &k.processDamping}) {
    *force /= std::sin(kappa);
  }
  return standing;
}

namespace {

Status checkEngagement(const Engagement& e, const std::string& place) {
  if (!(e.radialImmersion > 0.0) || e.radialImmersion > 1.0) {
    return Error{place, message("radial immersion must lie in (0, 1]")};
  }
  if (e.offset && !(std::abs(*e.offset) + e.radialImmersion <= 1.0 + 1e-9)) {
    return Error{place, message("with this offset a part of the cut lies beyond the tool")};
  }
  return Done{};
}

Status checkMode(const Mode& m, const std::string& place) {
  const auto bad = [&](const Message& what) { return Status(Error{place, what}); };
  if (!(m.frequency.value > 0.0) || !isFinite(m.frequency)) return bad(message("frequency must be above zero"));
  if (!(m.damping > 0.0) || !(m.damping < 1.0)) return bad(message("damping ratio must lie between 0 and 1"));
  if (!(m.stiffness > 0.0) || !std::isfinite(m.stiffness)) return bad(message("stiffness must be above zero"));
  const double size = sizeOf(m);
  if (!(size > 0.0) || !std::isfinite(size)) return bad(message("direction must not be zero"));
  for (std::size_t i = 0; i < m.atSpeeds.size(); ++i) {
    const ModeAtSpeed& row = m.atSpeeds[i];
    const bool rises = i == 0 ? row.speed.value >= 0.0 : row.speed > m.atSpeeds[i - 1].speed;
    if (!rises || !isFinite(row.speed)) return bad(message("the speeds of a mode must rise from 0 or more"));
    const Mode one{row.frequency, row.damping, row.stiffness, m.direction, m.directionZ};
    if (Status s = checkMode(one, place); !s) return s;
  }
  return Done{};
}

Status checkShape(const Tool& t, const std::string& place) {
  const auto bad = [&](const Message& what) { return Status(Error{place, what}); };
  const double radius = 0.5 * t.diameter.value;
  if (!(t.cornerRadius.value >= 0.0) || t.cornerRadius.value > radius * (1.0 + 1e-9)) {
    return bad(message("the corner radius must lie between 0 and half the diameter"));
  }
  if (!t.serration) return Done{};
  const Serration& s = *t.serration;
  if (!(s.amplitude.value > 0.0) || s.amplitude.value > 0.5 * radius) {
    return bad(message("the serration's amplitude must be above zero and below a quarter of the diameter"));
  }
  if (!(s.length.value > 0.0) || !isFinite(s.length))
    return bad(message("the serration's wave length must be above zero"));
  if (!s.phase.empty() && s.phase.size() != static_cast<std::size_t>(t.teeth)) {
    return bad(message("the serration needs one phase per tooth"));
  }
  for (double phase : s.phase) {
    if (!std::isfinite(phase)) return bad(message("the serration's phases must be finite"));
  }
  return Done{};
}

Status checkTool(const Tool& t, const std::string& place) {
  const auto bad = [&](const Message& what) { return Status(Error{place, what}); };
  const auto teeth = static_cast<std::size_t>(t.teeth);
  if (t.teeth < 1 || t.teeth > kMostTeeth) {
    return bad(message("teeth must be 1 to %1, not %2", std::to_string(kMostTeeth), std::to_string(t.teeth)));
  }
  if (!(t.diameter.value > 0.0) || !isFinite(t.diameter)) return bad(message("diameter must be above zero"));
  if (!t.pitch.empty()) {
    if (t.pitch.size() != teeth) return bad(message("pitch needs one angle per tooth"));
    for (double p : t.pitch) {
      if (!(p > 0.0)) return bad(message("pitch angles must be above zero"));
    }
    if (std::abs(std::accumulate(t.pitch.begin(), t.pitch.end(), 0.0) - kTwoPi) > 1e-6) {
      return bad(message("pitch angles must sum to 360 degrees"));
    }
  }
  if (!t.runout.empty() && t.runout.size() != teeth) return bad(message("runout needs one value per tooth"));
  for (Metres r : t.runout) {
    if (!isFinite(r)) return bad(message("runout must be finite"));
  }
  if (!t.toothHelix.empty() && t.toothHelix.size() != teeth) return bad(message("helix needs one angle per tooth"));
  for (int j = 0; j < t.teeth; ++j) {
    const double helix = helixOf(t, j);
    if (!std::isfinite(helix) || std::abs(helix) > 1.4) return bad(message("helix must lie within 80 degrees"));
  }
  return checkShape(t, place);
}

Status checkTurning(const CutModel& model, const std::string& place) {
  const auto bad = [&](const Message& what, const Message& why = {}) { return Status(Error{place, what, why}); };
  constexpr double kLeast = 5.0 / 360.0 * kTwoPi, kMost = 150.0 / 360.0 * kTwoPi;
  const double kappa = model.turning->edgeAngle;
  if (!(kappa >= kLeast) || kappa > kMost)
    return bad(message("the edge's angle to the feed must lie in 5 to 150 degrees"));
  const Tool& t = model.tool;
  if (!t.pitch.empty() || !t.toothHelix.empty() || !t.runout.empty() || t.helix != 0.0 || isShaped(t)) {
    return bad(message("edges that stand have no pitch, helix or runout"));
  }
  for (const Mode& m : model.modes) {
    if (t.teeth == 1 || m.direction[1] == 0.0) continue;
    return bad(message("with several edges the modes may move along the feed and the cutting speed only"),
               message("what one edge feels across, the edge opposite feels the other way"));
  }
  return Done{};
}

}  // namespace

Status check(const CutModel& model, const std::string& where) {
  if (model.modes.empty()) return Error{where, message("at least one mode is needed")};
  for (std::size_t i = 0; i < model.modes.size(); ++i) {
    if (Status s = checkMode(model.modes[i], where + ": mode " + std::to_string(i + 1)); !s) return s;
  }
  if (Status s = checkTool(model.tool, where + ": tool"); !s) return s;
  const Material& m = model.material;
  for (double k : {m.tangential, m.radial, m.tangentialEdge, m.radialEdge, m.processDamping}) {
    if (!std::isfinite(k)) return Error{where + ": material", message("cutting coefficients must be finite")};
  }
  if (!(m.tangential > 0.0))
    return Error{where + ": material", message("the tangential coefficient must be above zero")};
  if (!(m.exponent > 0.0) || m.exponent > 1.0)
    return Error{where + ": material", message("exponent must lie in (0, 1]")};
  const CutModel standing = standingTooth(model);
  if (std::none_of(standing.modes.begin(), standing.modes.end(), takesPart)) {
    return model.turning ? Error{where, message("no mode moves the edge across the cut or along the cutting speed"),
                                 message("a direction is three numbers: along the feed, into the part, along the "
                                         "cutting speed")}
                         : Error{where, message("no mode moves the tool along x or y")};
  }
  if (model.turning) return checkTurning(model, where + ": turning");
  return checkEngagement(model.engagement, where + ": engagement");
}

}  // namespace stillcut::milling
