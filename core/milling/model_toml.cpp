#include "core/milling/model_toml.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/milling/material_table.h"

namespace stillcut::milling {

namespace {

constexpr double kPerMetreMm = 1e3;
constexpr double kPerMetreUm = 1e6;
constexpr double kPercent = 1e2;
constexpr double kPerRadian = 360.0 / kTwoPi;

std::vector<double> inSi(std::vector<double> values, double perUnit) {
  for (double& v : values) v = milling::inSi(v, perUnit);
  return values;
}

Tool readTool(const config::TomlTable& t) {
  Tool tool;
  tool.teeth = t.integer("teeth", 1, kMostTeeth);
  tool.diameter = Metres(milling::inSi(t.numberOr("diameter_mm", 10.0, 0.01, 1000.0), kPerMetreMm));
  tool.helix = milling::inSi(t.numberOr("helix_deg", 0.0, -80.0, 80.0), kPerRadian);
  tool.toothHelix = inSi(t.numbersOr("tooth_helix_deg", {}), kPerRadian);
  tool.pitch = inSi(t.numbersOr("pitch_deg", {}), kPerRadian);
  const double radius = 0.5 * kPerMetreMm * tool.diameter.value;
  tool.cornerRadius = Metres(milling::inSi(t.numberOr("corner_radius_mm", 0.0, 0.0, radius), kPerMetreMm));
  if (const config::TomlTable s = t.tableOr("serration"); s.present()) {
    Serration serration;
    serration.amplitude = Metres(milling::inSi(s.number("amplitude_mm", 1e-4, 100.0), kPerMetreMm));
    serration.length = Metres(milling::inSi(s.number("wavelength_mm", 1e-2, 1000.0), kPerMetreMm));
    serration.phase = inSi(s.numbersOr("phase_deg", {}), kPerRadian);
    serration.feedPerTooth = Metres(milling::inSi(s.numberOr("feed_per_tooth_mm", 0.0, 0.0, 10.0), kPerMetreMm));
    tool.serration = std::move(serration);
  }
  for (double r : t.numbersOr("runout_um", {})) tool.runout.emplace_back(milling::inSi(r, kPerMetreUm));
  return tool;
}

// Edges that stand: no [tool] and no [engagement].
void readTurning(const config::TomlTable& root, CutModel& model) {
  for (const char* table : {"tool", "engagement"}) {
    if (root.has(table)) root.refuse(table, message("a turning cut has no tool that turns: [turning] says it all"));
  }
  const config::TomlTable t = root.table("turning");
  model.turning = Turning{milling::inSi(t.numberOr("edge_angle_deg", 90.0, 5.0, 150.0), kPerRadian)};
  model.tool.teeth = t.integerOr("edges", 1, 1, kMostTeeth);
  model.tool.diameter = Metres(milling::inSi(t.number("diameter_mm", 0.1, 10000.0), kPerMetreMm));
}

MillingDirection readSide(const config::TomlTable& e, bool needed) {
  const int side = needed ? e.choice("side", {"up", "down"}) : e.choiceOr("side", 0, {"up", "down"});
  return side == 0 ? MillingDirection::Up : MillingDirection::Down;
}

// By its angles; a radial immersion beside them must be theirs.
Engagement readAngles(const config::TomlTable& e) {
  const double start = milling::inSi(e.number("start_deg", 0.0, 180.0), kPerRadian);
  const double exit = milling::inSi(e.number("exit_deg", 0.0, 180.0), kPerRadian);
  Engagement engagement = engagementBetween(start, std::max(start, exit));
  if (!(exit > start)) e.refuse("exit_deg", message("the exit angle must lie above the start angle"));
  const double said = e.numberOr("radial_immersion", engagement.radialImmersion, 1e-6, 1.0);
  if (std::abs(said - engagement.radialImmersion) > 0.005) {
    e.refuse("radial_immersion",
             message("the angles make it %1", numberText(1e-4 * std::round(1e4 * engagement.radialImmersion))));
  }
  readSide(e, false);
  return engagement;
}

Engagement readEngagement(const config::TomlTable& e, Metres diameter) {
  if (e.has("start_deg") || e.has("exit_deg")) return readAngles(e);
  Engagement engagement;
  engagement.radialImmersion = e.number("radial_immersion", 1e-6, 1.0);
  const bool offset = e.has("offset_mm") || e.has("offset_radii");
  engagement.side = readSide(e, !offset);
  if (e.has("offset_mm")) {
    engagement.offset = milling::inSi(e.number("offset_mm", -1e3, 1e3), kPerMetreMm) / (0.5 * diameter.value);
  } else if (offset) {
    engagement.offset = e.number("offset_radii", -1.0, 1.0);
  }
  return engagement;
}

std::string list(const std::vector<double>& values, double perUnit) {
  std::string s = "[";
  for (std::size_t i = 0; i < values.size(); ++i) s += (i > 0 ? ", " : "") + numberText(values[i], perUnit);
  return s + "]";
}

// One column of the table that a mode then is.
std::vector<double> column(const config::TomlTable& t, const char* key, std::size_t rows) {
  std::vector<double> values = t.numbers(key);
  if (values.size() != rows) t.refuse(key, message("one number for each of the speeds is needed"));
  values.resize(rows, 1.0);
  return values;
}

void readAtSpeeds(const config::TomlTable& t, Mode& mode) {
  const std::vector<double> speeds = t.numbers("speeds_rpm");
  const auto frequencies = column(t, "frequency_hz", speeds.size());
  const auto dampings = column(t, "damping", speeds.size());
  const auto stiffnesses = column(t, "stiffness_n_per_m", speeds.size());
  if (speeds.empty()) t.refuse("speeds_rpm", message("at least one speed is needed"));
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    mode.atSpeeds.push_back({Rpm(speeds[i]), Hertz(frequencies[i]), dampings[i], stiffnesses[i]});
  }
  if (speeds.empty()) return;
  mode.frequency = mode.atSpeeds.front().frequency;
  mode.damping = mode.atSpeeds.front().damping;
  mode.stiffness = mode.atSpeeds.front().stiffness;
}

}  // namespace

std::vector<Mode> readModes(const config::TomlTable& root) {
  std::vector<Mode> modes;
  for (const config::TomlTable& t : root.tables("mode")) {
    Mode m;
    if (t.has("speeds_rpm")) {
      readAtSpeeds(t, m);
    } else {
      m.frequency = Hertz(t.number("frequency_hz", 0.01, 1e6));
      m.damping = t.number("damping", 1e-6, 0.999);
      m.stiffness = t.number("stiffness_n_per_m", 1.0, 1e15);
    }
    const std::vector<double> d = t.numbers("direction");
    if (d.size() == 2 || d.size() == 3) {
      m.direction = {d[0], d[1]};
      if (d.size() == 3) m.directionZ = d[2];
    } else {
      t.refuse("direction", message("a direction is two or three numbers, along x, y and z"));
    }
    m.ofPart = t.choiceOr("of", 0, {"tool", "part"}) == 1;
    modes.push_back(m);
  }
  return modes;
}

namespace {

Material named(const config::TomlTable& t, const char* key) {
  const Result<Material> material = materialNamed(t.text(key), t.place(key));
  if (material) return material.value();
  t.refuse(key, material.error().what, material.error().why);
  return {};
}

}  // namespace

Material readMaterial(const config::TomlTable& t) {
  Material m;
  if (t.has("name")) {
    m = named(t, "name");
    m.tangential = t.numberOr("tangential_n_per_m2", m.tangential, 0.0, 1e15);
    m.radial = t.numberOr("radial_n_per_m2", m.radial, -1e15, 1e15);
  } else {
    m.tangential = t.number("tangential_n_per_m2", 0.0, 1e15);
    m.radial = t.number("radial_n_per_m2", -1e15, 1e15);
  }
  m.tangentialEdge = t.numberOr("tangential_edge_n_per_m", m.tangentialEdge, -1e9, 1e9);
  m.radialEdge = t.numberOr("radial_edge_n_per_m", m.radialEdge, -1e9, 1e9);
  m.exponent = t.numberOr("exponent", m.exponent, 0.01, 1.0);
  m.processDamping = t.numberOr("process_damping_n_per_m", m.processDamping, 0.0, 1e12);
  m.spread = milling::inSi(t.numberOr("spread_percent", kPercent * m.spread, 0.0, 50.0), kPercent);
  m.dampingSpread =
      milling::inSi(t.numberOr("process_damping_spread_percent", kPercent * m.dampingSpread, 0.0, 50.0), kPercent);
  m.usualChip =
      Metres(milling::inSi(t.numberOr("usual_chip_mm", kPerMetreMm * m.usualChip.value, 0.0, 1.0), kPerMetreMm));
  if (t.has("indentation_n_per_m3") || t.has("wear_land_mm")) {
    if (t.has("process_damping_n_per_m")) {
      t.refuse("process_damping_n_per_m", message("it follows from the indentation coefficient and the wear land"));
    }
    const double perVolume = t.number("indentation_n_per_m3", 0.0, 1e16);
    m.processDamping = processDampingOf(perVolume, Metres(inSi(t.number("wear_land_mm", 0.0, 2.0), kPerMetreMm)));
  }
  return m;
}

CutModel readModel(const config::TomlTable& root, const ModelParts& parts) {
  CutModel model;
  if (parts.modes.empty() || root.has("mode")) model.modes = readModes(root);
  if (!parts.modes.empty()) model.modes = parts.modes;
  if (root.has("turning")) {
    readTurning(root, model);
  } else {
    model.tool = readTool(root.table("tool"));
    model.engagement = readEngagement(root.table("engagement"), model.tool.diameter);
  }
  if (root.has("material") && !root.isTable("material")) {
    model.material = named(root, "material");
  } else if (!parts.material || root.has("material")) {
    model.material = readMaterial(root.table("material"));
  }
  if (parts.material) model.material = *parts.material;
  for (const char* notes : {"modal_fit", "force_fit"}) root.tableOr(notes).keys();
  return model;
}

namespace {

std::string modeLines(const Mode& m) {
  return "frequency_hz = " + numberText(m.frequency.value) + "\ndamping = " + numberText(m.damping) +
         "\nstiffness_n_per_m = " + numberText(m.stiffness) + "\n";
}

std::string tableLines(const Mode& m) {
  std::vector<double> speeds, frequencies, dampings, stiffnesses;
  for (const ModeAtSpeed& row : m.atSpeeds) {
    speeds.push_back(row.speed.value);
    frequencies.push_back(row.frequency.value);
    dampings.push_back(row.damping);
    stiffnesses.push_back(row.stiffness);
  }
  return "speeds_rpm = " + list(speeds, 1.0) + "\nfrequency_hz = " + list(frequencies, 1.0) +
         "\ndamping = " + list(dampings, 1.0) + "\nstiffness_n_per_m = " + list(stiffnesses, 1.0) + "\n";
}

}  // namespace

std::string modesText(const std::vector<Mode>& modes) {
  std::string s;
  for (const Mode& m : modes) {
    s += "[[mode]]\n" + (m.atSpeeds.empty() ? modeLines(m) : tableLines(m)) + "direction = [" +
         numberText(m.direction[0]) + ", " + numberText(m.direction[1]) +
         (m.directionZ != 0.0 ? ", " + numberText(m.directionZ) : "") + "]\n" + (m.ofPart ? "of = \"part\"\n\n" : "\n");
  }
  return s;
}

namespace {

std::string spreadText(const Material& m) {
  std::string s;
  if (m.spread > 0.0) s += "spread_percent = " + numberText(m.spread, kPercent) + "\n";
  if (m.dampingSpread > 0.0) s += "process_damping_spread_percent = " + numberText(m.dampingSpread, kPercent) + "\n";
  if (m.usualChip.value > 0.0) s += "usual_chip_mm = " + numberText(m.usualChip.value, kPerMetreMm) + "\n";
  return s;
}

}  // namespace

std::string materialText(const Material& m) {
  return "[material]\ntangential_n_per_m2 = " + numberText(m.tangential) +
         "\nradial_n_per_m2 = " + numberText(m.radial) + "\ntangential_edge_n_per_m = " + numberText(m.tangentialEdge) +
         "\nradial_edge_n_per_m = " + numberText(m.radialEdge) + "\nexponent = " + numberText(m.exponent) +
         "\nprocess_damping_n_per_m = " + numberText(m.processDamping) + "\n" + spreadText(m) + "\n";
}

namespace {

std::string shapeText(const Tool& t) {
  std::string s;
  if (t.cornerRadius.value > 0.0) s += "corner_radius_mm = " + numberText(t.cornerRadius.value, kPerMetreMm) + "\n";
  if (!t.serration) return s;
  const Serration& waves = *t.serration;
  s += "\n[tool.serration]\namplitude_mm = " + numberText(waves.amplitude.value, kPerMetreMm) +
       "\nwavelength_mm = " + numberText(waves.length.value, kPerMetreMm) + "\n";
  if (!waves.phase.empty()) s += "phase_deg = " + list(waves.phase, kPerRadian) + "\n";
  if (waves.feedPerTooth.value > 0.0) {
    s += "feed_per_tooth_mm = " + numberText(waves.feedPerTooth.value, kPerMetreMm) + "\n";
  }
  return s;
}

}  // namespace

std::string modelText(const CutModel& model) {
  const Tool& t = model.tool;
  std::string s = modesText(model.modes);
  if (model.turning) {
    return s + "[turning]\nedges = " + std::to_string(t.teeth) +
           "\ndiameter_mm = " + numberText(t.diameter.value, kPerMetreMm) +
           "\nedge_angle_deg = " + numberText(model.turning->edgeAngle, kPerRadian) + "\n\n" +
           materialText(model.material);
  }
  s += "[tool]\nteeth = " + std::to_string(t.teeth) + "\ndiameter_mm = " + numberText(t.diameter.value, kPerMetreMm) +
       "\nhelix_deg = " + numberText(t.helix, kPerRadian) + "\n";
  if (!t.toothHelix.empty()) s += "tooth_helix_deg = " + list(t.toothHelix, kPerRadian) + "\n";
  if (!t.pitch.empty()) s += "pitch_deg = " + list(t.pitch, kPerRadian) + "\n";
  if (!t.runout.empty()) {
    std::vector<double> runout;
    for (Metres r : t.runout) runout.push_back(r.value);
    s += "runout_um = " + list(runout, kPerMetreUm) + "\n";
  }
  s += shapeText(t);
  s += "\n" + materialText(model.material);
  s += "[engagement]\nradial_immersion = " + numberText(model.engagement.radialImmersion) + "\nside = \"" +
       (model.engagement.side == MillingDirection::Up ? "up" : "down") + "\"\n";
  if (model.engagement.offset) s += "offset_radii = " + numberText(*model.engagement.offset) + "\n";
  return s + "\n";
}

std::string numberText(double value) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  std::string s(buffer.data(), end);
  if (s.find_first_of(".en") == std::string::npos) s += ".0";
  return s;
}

std::string numberText(double value, double perUnit) {
  // The nearest number need not read back exactly; one of its neighbours then does.
  const double nearest = value * perUnit;
  double best = nearest;
  if (inSi(nearest, perUnit) != value) {
    double low = nearest, high = nearest;
    for (int i = 0; i < 3 && inSi(best, perUnit) != value; ++i) {
      low = std::nextafter(low, -HUGE_VAL);
      high = std::nextafter(high, HUGE_VAL);
      if (inSi(low, perUnit) == value) best = low;
      if (inSi(high, perUnit) == value) best = high;
    }
  }
  return numberText(best);
}

}  // namespace stillcut::milling
