// stillcut-cli materials [NAME] [--json]: the table of common materials, or one of them as it stands in a case.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/json_line.h"
#include "core/milling/linear_force.h"
#include "core/milling/material_table.h"
#include "core/milling/model_toml.h"

namespace stillcut::app {
namespace {

using milling::Material;
using milling::TableMaterial;

struct MaterialsCommand {
  std::string name;
  bool json = false;
};

// What the lobes take where no feed is known.
Material straight(const TableMaterial& entry) {
  return milling::linearisedAt(entry.material, entry.material.usualChip);
}

nlohmann::json asJson(const TableMaterial& entry) {
  const Material& m = entry.material;
  const Material at = straight(entry);
  return {{"name", entry.name},
          {"also", entry.also},
          {"what", entry.what},
          {"tangential", m.tangential},
          {"radial", m.radial},
          {"exponent", m.exponent},
          {"tangential_edge_n_per_m", m.tangentialEdge},
          {"radial_edge_n_per_m", m.radialEdge},
          {"process_damping_n_per_m", m.processDamping},
          {"usual_chip_mm", 1e3 * m.usualChip.value},
          {"tangential_at_usual_chip_n_per_m2", at.tangential},
          {"radial_at_usual_chip_n_per_m2", at.radial},
          {"spread_percent", 100.0 * m.spread},
          {"process_damping_spread_percent", 100.0 * m.dampingSpread},
          {"source", entry.source},
          {"remark", entry.remark}};
}

nlohmann::json answerOf(const std::vector<TableMaterial>& entries) {
  nlohmann::json answer = jsonObject("materials", "answer");
  for (const TableMaterial& entry : entries) answer["materials"].push_back(asJson(entry));
  return answer;
}

void printTable() {
  std::printf("%-12s %6s %6s %6s %6s %5s %7s %5s  %-9s %s\n", "material", "K_t", "K_r", "K_te", "K_re", "exp.",
              "damping", "+-%", "source", "what");
  for (const TableMaterial& entry : milling::materialTable()) {
    const Material& m = entry.material;
    const Material at = straight(entry);
    std::printf("%-12s %6.0f %6.0f %6.1f %6.1f %5.2f %7.0f %5.0f  %-9s %s\n", entry.name.c_str(), 1e-6 * at.tangential,
                1e-6 * at.radial, 1e-3 * m.tangentialEdge, 1e-3 * m.radialEdge, m.exponent, m.processDamping,
                100.0 * m.spread, entry.source.c_str(), entry.what.c_str());
  }
  std::printf(
      "K_t, K_r in N/mm2, of a power law (exp. below 1) at a chip of 0.05 mm; edge forces in N/mm; process damping "
      "in N/m; sources: the head of resources/materials.toml\n");
}

// A table to paste into a case, with what is known about it.
int printOne(const std::string& name, bool json) {
  if (const auto known = milling::materialNamed(name, "materials"); !known) return fail(known.error());
  const TableMaterial& entry = *milling::findMaterial(name);
  if (json) {
    printJson(answerOf({entry}));
    return kExitDone;
  }
  std::printf("# %s: %s\n# source: %s; %s\n%s", entry.name.c_str(), entry.what.c_str(), entry.source.c_str(),
              entry.remark.c_str(), milling::materialText(entry.material).c_str());
  return kExitDone;
}

int run(const MaterialsCommand& c) {
  if (!c.name.empty()) return printOne(c.name, c.json);
  if (!c.json) {
    printTable();
    return kExitDone;
  }
  printJson(answerOf(milling::materialTable()));
  return kExitDone;
}

}  // namespace

void addMaterials(CLI::App& app, int& exitCode) {
  auto c = std::make_shared<MaterialsCommand>();
  CLI::App* sub = app.add_subcommand("materials", "Common materials with their cutting force coefficients, by name");
  sub->add_option("NAME", c->name, "Print this one as a table [material] of a case");
  sub->add_flag("--json", c->json, "Print JSON");
  sub->callback([c, &exitCode] { exitCode = run(*c); });
}

}  // namespace stillcut::app
