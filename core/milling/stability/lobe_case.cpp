#include "core/milling/stability/lobe_case.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/config/toml_reader.h"
#include "core/storage/atomic_file.h"

namespace stillcut::milling {

namespace {

constexpr double kPerMetreMm = 1e3;

// Leaves of the document as text; those the case itself holds are left out.
void flatten(const nlohmann::json& node, const std::string& key, std::map<std::string, std::string>& out) {
  if (node.is_structured()) {
    for (const auto& item : node.items()) flatten(item.value(), key.empty() ? item.key() : key + "-" + item.key(), out);
    return;
  }
  out[key] = node.is_string() ? node.get<std::string>() : node.dump();
}

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump();  // the escapes of a JSON string are those of a TOML basic string
}

Mode modeFrom(const nlohmann::json& m) {
  Mode mode;
  mode.frequency = Hertz(m.at("f").get<double>());
  mode.damping = m.at("zeta").get<double>();
  const double omega = kTwoPi * mode.frequency.value;
  mode.stiffness = m.contains("k") ? m.at("k").get<double>() : m.at("m").get<double>() * omega * omega;
  mode.direction = {m.at("d").at(0).get<double>(), m.at("d").at(1).get<double>()};
  return mode;
}

LobeCase caseFrom(const nlohmann::json& j) {
  LobeCase c;
  c.name = j.at("name").get<std::string>();
  for (const auto& m : j.at("modes")) c.model.modes.push_back(modeFrom(m));
  c.model.tool.teeth = j.at("N").get<int>();
  c.model.material.tangential = j.at("Kt").get<double>();
  c.model.material.radial = j.at("Kn").get<double>();
  c.model.engagement = {j.at("aD").get<double>(),
                        j.at("up").get<bool>() ? MillingDirection::Up : MillingDirection::Down};
  c.maxAxialDepth = Metres(inSi(j.at("wmax_mm").get<double>(), kPerMetreMm));
  flatten(j, "", c.reference);
  c.reference.erase("name");
  return c;
}

}  // namespace

Result<LobeCase> importLobeJson(const std::string& path, const ModelParts& parts) {
  std::ifstream file(path);
  if (!file) return Error{path, message("cannot be opened")};
  LobeCase c;
  try {
    c = caseFrom(nlohmann::json::parse(file));
  } catch (const nlohmann::json::exception& e) {
    return Error{path, message("is no lobe case"), foreign(e.what())};
  }
  if (!parts.modes.empty()) c.model.modes = parts.modes;
  if (parts.material) c.model.material = *parts.material;
  if (Status ok = check(c.model, path); !ok) return ok.error();
  return c;
}

Result<LobeCase> readLobeCase(const std::string& path, const ModelParts& parts) {
  config::TomlReader reader = config::TomlReader::file(path);
  const config::TomlTable root = reader.root();
  LobeCase c;
  c.name = root.textOr("name", std::filesystem::path(path).stem().string());
  c.model = readModel(root, parts);
  c.maxAxialDepth = Metres(inSi(root.tableOr("chart").numberOr("max_depth_mm", 10.0, 1e-6, 1000.0), kPerMetreMm));
  const config::TomlTable reference = root.tableOr("reference");
  for (const std::string& key : reference.keys()) c.reference[key] = reference.text(key);
  if (Status ok = reader.finish(); !ok) return ok.error();
  if (Status ok = check(c.model, path); !ok) return ok.error();
  return c;
}

Result<LobeCase> loadLobeCase(const std::string& path, const ModelParts& parts) {
  return std::filesystem::path(path).extension() == ".json" ? importLobeJson(path, parts) : readLobeCase(path, parts);
}

std::string lobeCaseText(const LobeCase& c) {
  std::string s = "name = " + quoted(c.name) + "\n\n" + modelText(c.model);
  s += "[chart]\nmax_depth_mm = " + numberText(c.maxAxialDepth.value, kPerMetreMm) + "\n";
  if (c.reference.empty()) return s;
  s += "\n[reference]\n";
  for (const auto& [key, text] : c.reference) s += quoted(key) + " = " + quoted(text) + "\n";
  return s;
}

Status saveLobeCase(const LobeCase& lobeCase, const std::string& path) {
  return writeFileAtomically(path, lobeCaseText(lobeCase));
}

}  // namespace stillcut::milling
