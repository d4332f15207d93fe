#include "core/milling/material_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/config/nearest_word.h"
#include "core/config/toml_reader.h"
#include "core/milling/linear_force.h"
#include "core/milling/materials_text.h"

namespace stillcut::milling {

namespace {

using config::TomlTable;

constexpr double kPerMm2 = 1e6;  // per m^2
constexpr double kPerMm = 1e3;   // per m

// What the table has for all that an entry does not say.
struct Usual {
  double radialShare = 0.0;
  double processDamping = 0.0;  // over K_t [m]
  double spread = 0.0, dampingSpread = 0.0;
  Metres chip{};
};

double percent(const TomlTable& t, const char* key, double otherwise) {
  return 0.01 * t.numberOr(key, 100.0 * otherwise, 0.0, 50.0);
}

Usual readUsual(const TomlTable& t) {
  return {t.number("radial_share", 0.0, 2.0), 1e-6 * t.number("process_damping_um", 0.0, 1e3),
          percent(t, "spread_percent", 0.0), percent(t, "process_damping_spread_percent", 0.0),
          Metres(1e-3 * t.number("usual_chip_mm", 1e-3, 1.0))};
}

// b kc1.1 h^(1-m_c) with b and h in mm, in SI.
void readPowerLaw(const TomlTable& t, const Usual& usual, Material& m) {
  const double mc = t.number("mc", 0.0, 0.9);
  m.exponent = 1.0 - mc;
  m.tangential = t.number("kc1_n_per_mm2", 1.0, 1e5) * kPerMm2 * std::pow(kPerMm, -mc);
  m.radial = t.numberOr("radial_share", usual.radialShare, 0.0, 2.0) * m.tangential;
  m.usualChip = usual.chip;
}

void readLinear(const TomlTable& t, const Usual& usual, Material& m) {
  m.tangential = t.number("tangential_n_per_mm2", 1.0, 1e5) * kPerMm2;
  m.radial = t.numberOr("radial_n_per_mm2", usual.radialShare * m.tangential / kPerMm2, -1e5, 1e5) * kPerMm2;
  m.tangentialEdge = t.numberOr("tangential_edge_n_per_mm", 0.0, 0.0, 1e4) * kPerMm;
  m.radialEdge = t.numberOr("radial_edge_n_per_mm", 0.0, 0.0, 1e4) * kPerMm;
}

TableMaterial readEntry(const TomlTable& t, const Usual& usual) {
  TableMaterial entry;
  entry.name = t.text("name");
  entry.also = t.has("also") ? t.texts("also") : std::vector<std::string>();
  entry.what = t.text("what");
  entry.source = t.text("source");
  entry.remark = t.textOr("remark", "");
  Material& m = entry.material;
  if (t.has("kc1_n_per_mm2")) {
    readPowerLaw(t, usual, m);
  } else {
    readLinear(t, usual, m);
  }
  const double slope = linearisedAt(m, usual.chip).tangential;
  m.processDamping = t.numberOr("process_damping_n_per_m", usual.processDamping * slope, 0.0, 1e9);
  m.spread = percent(t, "spread_percent", usual.spread);
  m.dampingSpread = percent(t, "process_damping_spread_percent", usual.dampingSpread);
  return entry;
}

std::string plain(std::string_view name) {
  std::string s;
  for (char c : name) {
    if (c != ' ' && c != '-') s += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return s;
}

}  // namespace

Result<std::vector<TableMaterial>> readMaterialTable(std::string_view content, const std::string& where) {
  const config::TomlReader in = config::TomlReader::text(content, where);
  const Usual usual = readUsual(in.root().table("usual"));
  std::vector<TableMaterial> table;
  for (const TomlTable& t : in.root().tables("material")) table.push_back(readEntry(t, usual));
  if (Status ok = in.finish(); !ok) return ok.error();
  return table;
}

const std::vector<TableMaterial>& materialTable() {
  static const std::vector<TableMaterial> kTable = [] {
    auto table = readMaterialTable(kMaterialsText, "materials.toml");
    return table ? std::move(table).value() : std::vector<TableMaterial>();
  }();
  return kTable;
}

const TableMaterial* findMaterial(std::string_view name) {
  const std::string wanted = plain(name);
  for (const TableMaterial& entry : materialTable()) {
    if (plain(entry.name) == wanted) return &entry;
    for (const std::string& other : entry.also) {
      if (plain(other) == wanted) return &entry;
    }
  }
  return nullptr;
}

Result<Material> materialNamed(std::string_view name, const std::string& where) {
  if (const TableMaterial* entry = findMaterial(name)) return entry->material;
  std::vector<std::string_view> names;
  for (const TableMaterial& entry : materialTable()) {
    names.emplace_back(entry.name);
    names.insert(names.end(), entry.also.begin(), entry.also.end());
  }
  Message near = config::didYouMean(name, names);
  if (near.empty()) near = message("stillcut-cli materials lists them");
  return Error{where, message("the table of materials has no '%1'", std::string(name)), near};
}

}  // namespace stillcut::milling
