// stillcut-cli lobes CASE.toml [--method zoa|sdm|exact] [--k N] [--order 0|1] [--speeds FROM:TO:STEP]
//                    [--max-depth MM] [--threads N] [--modes MODES.toml]... [--material MATERIAL.toml] [--json]
//                    [--out OUT.csv]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/out_path.h"
#include "core/milling/identify/model_files.h"
#include "core/milling/stability/lobe_case.h"
#include "core/milling/stability/lobe_csv.h"
#include "core/milling/stability/lobe_sweep.h"

namespace stillcut::app {
namespace {

using namespace milling;

struct LobesCommand {
  std::string file, out, speeds, material;
  std::vector<std::string> modes;
  std::string method = "exact";
  int cells = 40;
  int order = 1;
  int threads = 2;
  double maxDepthMm = 0.0;  // 0: the case's
  bool json = false;
};

// What `modal` and `coefficients` wrote, several files of modes together (one for each axis hit).
Result<ModelParts> readParts(const LobesCommand& c) {
  ModelParts parts;
  for (const std::string& file : c.modes) {
    const auto modes = identify::loadModes(file);
    if (!modes) return modes.error();
    for (const identify::IdentifiedMode& m : modes->modes) {
      parts.modes.push_back(m.mode);
      if (m.caveat.empty()) continue;
      std::fprintf(stderr, "warning: %s: the mode at %.0f Hz %s\n", file.c_str(), m.mode.frequency.value,
                   m.caveat.c_str());
    }
  }
  if (c.material.empty()) return parts;
  const auto material = identify::loadMaterial(c.material);
  if (!material) return material.error();
  parts.material = material->material;
  return parts;
}

// "5000:25000:100"
Result<std::vector<Rpm>> readSpeeds(const std::string& text) {
  const Error bad{"--speeds", message("'%1' is no range", text), message("FROM:TO:STEP in rev/min, as 5000:25000:100")};
  std::vector<double> parts;
  for (const std::string& part : CLI::detail::split(text, ':')) {
    double value = 0.0;
    if (!CLI::detail::lexical_cast(part, value)) return bad;
    parts.push_back(value);
  }
  if (parts.size() != 3) return bad;
  return speedSteps(Rpm(parts[0]), Rpm(parts[1]), Rpm(parts[2]), "--speeds");
}

// From the fifth lobe of the slowest mode to beyond the first lobe of the fastest, some 200 speeds.
Result<std::vector<Rpm>> usualSpeeds(const CutModel& model) {
  double slowest = model.modes.front().frequency.value;
  double fastest = slowest;
  for (const Mode& m : model.modes) {
    slowest = std::min(slowest, m.frequency.value);
    fastest = std::max(fastest, m.frequency.value);
  }
  const double from = std::max(10.0, 10.0 * std::round(0.1 * 60.0 * slowest / (5.0 * model.tool.teeth)));
  const double to = 10.0 * std::round(0.1 * 60.0 * 1.3 * fastest / model.tool.teeth);
  const double step = std::max(1.0, std::round((to - from) / 200.0));
  return speedSteps(Rpm(from), Rpm(std::max(from, to)), Rpm(step), "speeds");
}

int run(const LobesCommand& c) {
  if (const Status usable = checkOutPath(c.out, c.file); !usable) return fail(usable.error());
  const auto parts = readParts(c);
  if (!parts) return fail(parts.error());
  const auto lobeCase = loadLobeCase(c.file, *parts);
  if (!lobeCase) return fail(lobeCase.error());
  const auto speeds = c.speeds.empty() ? usualSpeeds(lobeCase->model) : readSpeeds(c.speeds);
  if (!speeds) return fail(speeds.error());
  SweepOptions options;
  options.method = c.method == "zoa"   ? LobeMethod::ZerothOrder
                   : c.method == "sdm" ? LobeMethod::SemiDiscretization
                                       : LobeMethod::Exact;
  options.limits.maxAxialDepth = c.maxDepthMm > 0.0 ? Metres(1e-3 * c.maxDepthMm) : lobeCase->maxAxialDepth;
  options.sdm = {c.cells, c.order};
  options.threads = c.threads;
  const auto sweep = sweepLobes(lobeCase->model, *speeds, options, c.file);
  if (!sweep) return fail(sweep.error());
  for (const Message& warning : sweep->warnings) std::fprintf(stderr, "warning: %s\n", text(warning).c_str());
  if (!c.out.empty()) {
    if (const Status saved = saveLobeCsv(*sweep, c.out); !saved) return fail(saved.error());
  }
  if (c.json || c.out.empty())
    std::fputs((c.json ? lobeJson(*sweep, lobeCase->name) : lobeCsv(*sweep)).c_str(), stdout);
  // Beside a table on stdout the words go to stderr.
  for (const std::string& line : lobeSummary(*sweep)) {
    std::fprintf(c.json || c.out.empty() ? stderr : stdout, "%s\n", line.c_str());
  }
  return kExitDone;
}

}  // namespace

void addLobes(CLI::App& app, int& exitCode) {
  auto c = std::make_shared<LobesCommand>();
  CLI::App* sub = app.add_subcommand("lobes", "Stability limits of a cut over the spindle speed");
  sub->add_option("CASE", c->file, "The cut, .toml (or a reference case, .json)")->required();
  sub->add_option("--method", c->method, "zoa (zeroth order), sdm (semi-discretization) or exact")
      ->check(CLI::IsMember({"zoa", "sdm", "exact"}));
  sub->add_option("--k", c->cells, "Cells per tooth period, for sdm");
  sub->add_option("--order", c->order, "Order of sdm, 0 or 1");
  sub->add_option("--speeds", c->speeds, "FROM:TO:STEP [rev/min], TO included; left out: the modes' lobes");
  sub->add_option("--max-depth", c->maxDepthMm, "Deepest cut looked at [mm]; left out: the case's")
      ->check(CLI::PositiveNumber);
  sub->add_option("--modes", c->modes, "Modes that `modal` wrote, instead of the case's; once for each axis");
  sub->add_option("--material", c->material, "Coefficients that `coefficients` wrote, instead of the case's");
  sub->add_flag("--json", c->json, "Print JSON: limits with the depth searched, whether verified, and the warnings");
  sub->add_option("--threads", c->threads, "Threads to work with")->check(CLI::Range(1, 64));
  sub->add_option("--out", c->out, "Write the table to OUT.csv instead of printing it");
  sub->callback([c, &exitCode] { exitCode = run(*c); });
}

}  // namespace stillcut::app
