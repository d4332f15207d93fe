#include "tests/unit/stability/reference_cases.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace stillcut::milling {

namespace {

std::vector<std::vector<std::string>> readCsv(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(file, line);  // header
  while (std::getline(file, line)) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    std::vector<std::string> fields(1);
    for (char c : line) {
      if (c == ',') {
        fields.emplace_back();
      } else {
        fields.back() += c;
      }
    }
    rows.push_back(std::move(fields));
  }
  return rows;
}

}  // namespace

std::filesystem::path referenceFile(const std::string& name) {
  return std::filesystem::path(STILLCUT_SHARED_DIR) / "lobes" / name;
}

bool referencePresent() {
  return std::filesystem::exists(referenceFile("ins1dof_aD1_slot.csv"));
}

ReferenceCase loadReference(const std::string& name) {
  ReferenceCase c;
  std::ifstream file(referenceFile(name + ".json"));
  const nlohmann::json j = nlohmann::json::parse(file);
  for (const auto& m : j.at("modes")) {
    Mode mode;
    mode.frequency = Hertz(m.at("f").get<double>());
    mode.damping = m.at("zeta").get<double>();
    const double omega = kTwoPi * mode.frequency.value;
    mode.stiffness = m.contains("k") ? m.at("k").get<double>() : m.at("m").get<double>() * omega * omega;
    mode.direction = {m.at("d").at(0).get<double>(), m.at("d").at(1).get<double>()};
    c.model.modes.push_back(mode);
  }
  c.model.tool.teeth = j.at("N").get<int>();
  c.model.material.tangential = j.at("Kt").get<double>();
  c.model.material.radial = j.at("Kn").get<double>();
  c.model.engagement = {j.at("aD").get<double>(),
                        j.at("up").get<bool>() ? MillingDirection::Up : MillingDirection::Down};
  c.maxAxialDepth = 1e-3 * j.at("wmax_mm").get<double>();
  for (const auto& f : readCsv(referenceFile(name + ".csv"))) {
    auto& rows = c.rows[std::stod(f.at(0))];
    if (f.at(2).empty()) continue;
    ReferenceRow row{std::stoi(f.at(1)),
                     1e-3 * std::stod(f.at(2)),
                     std::stoi(f.at(3)),
                     std::stoi(f.at(4)),
                     f.at(5),
                     std::stod(f.at(6)),
                     0.0};
    if (f.size() > 8 && !f.at(8).empty()) row.sdmDepth = 1e-3 * std::stod(f.at(8));
    rows.push_back(row);
  }
  for (const auto& f : readCsv(referenceFile(name + "_zoa.csv"))) {
    if (!f.at(1).empty()) c.zoa[std::stod(f.at(0))] = 1e-3 * std::stod(f.at(1));
  }
  return c;
}

CutModel textbookSlot() {
  CutModel model;
  const double omega = kTwoPi * 922.0;
  model.modes.push_back({Hertz(922.0), 0.011, 0.03993 * omega * omega, {1.0, 0.0}});
  model.tool.teeth = 2;
  model.material.tangential = 6e8;
  model.material.radial = 2e8;
  model.engagement = {1.0, MillingDirection::Up};
  return model;
}

CutModel textbookHalf() {
  CutModel model = textbookSlot();
  model.modes.push_back(model.modes.front());
  model.modes.back().direction = {0.0, 1.0};
  model.engagement = {0.5, MillingDirection::Up};
  return model;
}

}  // namespace stillcut::milling
