// stillcut-cli lobes FILE [--method zoa|sdm|exact] [--k N] [--order 0|1] [--speeds FROM:TO:STEP]
//                    [--max-depth MM] [--threads N] [--modes MODES.toml]... [--material MATERIAL.toml]
//                    [--engagement START:EXIT | --offset MM] [--json] [--out OUT.csv]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>

#include "app/cli/cut_options.h"
#include "app/cli/out_path.h"
#include "core/milling/stability/limit_band.h"
#include "core/milling/stability/lobe_csv.h"
#include "core/milling/stability/lobe_sweep.h"

namespace stillcut::app {
namespace {

using namespace milling;

struct LobesCommand {
  CutOptions cut;
  std::string out, speeds;
  std::string method = "exact";
  int cells = 0;  // as many as it takes
  int order = 1;
  int threads = 2;
  double maxDepthMm = 0.0;     // 0: the case's
  std::vector<double> spread;  // [%] of frequency, damping, stiffness and, unless it is the material's, force; or none
  bool json = false;
};

// "5000:25000:100"
Result<std::vector<Rpm>> readSpeeds(const std::string& text) {
  const Error bad{"--speeds", message("'%1' is no range", text), message("FROM:TO:STEP in rpm, as 5000:25000:100")};
  std::vector<double> parts;
  for (const std::string& part : CLI::detail::split(text, ':')) {
    double value = 0.0;
    if (!CLI::detail::lexical_cast(part, value)) return bad;
    parts.push_back(value);
  }
  if (parts.size() != 3) return bad;
  return speedSteps(Rpm(parts[0]), Rpm(parts[1]), Rpm(parts[2]), "--speeds");
}

// From the fifth lobe of the slowest mode to beyond the first lobe of the fastest, some 200 speeds; in turning, what
// carbide cuts at.
Result<std::vector<Rpm>> usualSpeeds(const CutModel& model) {
  if (model.turning) {
    constexpr double kSlow = 40.0, kFast = 400.0;  // [m/min]
    const double around = std::numbers::pi * model.tool.diameter.value;
    const double from = std::ceil(kSlow / around), to = std::floor(kFast / around);
    return speedSteps(Rpm(from), Rpm(std::max(from, to)), Rpm(std::max(1.0, std::round((to - from) / 200.0))),
                      "speeds");
  }
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

Result<LimitBands> bandsOf(const LobesCommand& c, const CutFile& cut, const std::vector<Rpm>& speeds, Metres deepest) {
  if (c.spread.empty()) return LimitBands{};
  const auto spread = spreadOf(c.spread, cut.model.material);
  if (!spread) return spread.error();
  if (c.method != "exact") return Error{"--spread", message("bands are of the exact method")};
  return limitBands(cut.model, speeds, deepest, *spread, c.threads, "--spread");
}

int run(const LobesCommand& c) {
  if (const Status usable = checkOutPath(c.out, c.cut.file); !usable) return fail(usable.error());
  const auto cut = readCut(c.cut);
  if (!cut) return fail(cut.error());
  const auto speeds = c.speeds.empty() ? usualSpeeds(cut->model) : readSpeeds(c.speeds);
  if (!speeds) return fail(speeds.error());
  SweepOptions options;
  options.method = c.method == "zoa"   ? LobeMethod::ZerothOrder
                   : c.method == "sdm" ? LobeMethod::SemiDiscretization
                                       : LobeMethod::Exact;
  options.limits.maxAxialDepth = c.maxDepthMm > 0.0 ? Metres(1e-3 * c.maxDepthMm) : cut->maxAxialDepth;
  options.sdm = {c.cells, c.order};
  options.threads = c.threads;
  options.measured = cut->measured;
  const auto sweep = sweepLobes(cut->model, *speeds, options, c.cut.file);
  if (!sweep) return fail(sweep.error());
  for (const Message& warning : sweep->warnings) std::fprintf(stderr, "warning: %s\n", text(warning).c_str());
  const auto bands = bandsOf(c, *cut, *speeds, options.limits.maxAxialDepth);
  if (!bands) return fail(bands.error());
  if (!c.out.empty()) {
    if (const Status saved = saveLobeCsv(*sweep, c.out, bands->speeds); !saved) return fail(saved.error());
  }
  if (c.json || c.out.empty())
    std::fputs((c.json ? lobeJson(*sweep, cut->name, bands->speeds) : lobeCsv(*sweep, bands->speeds)).c_str(), stdout);
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
  addCutOptions(*sub, c->cut);
  sub->add_option("--method", c->method, "zoa (zeroth order), sdm (semi-discretization) or exact")
      ->check(CLI::IsMember({"zoa", "sdm", "exact"}));
  sub->add_option("--k", c->cells, "Cells per tooth period, for sdm; left out: as many as the fastest mode calls for");
  sub->add_option("--order", c->order, "Order of sdm, 0 or 1");
  sub->add_option("--speeds", c->speeds, "FROM:TO:STEP [rpm], TO included; left out: the modes' lobes");
  sub->add_option("--max-depth", c->maxDepthMm, "Deepest cut looked at [mm]; left out: the case's")
      ->check(CLI::PositiveNumber);
  addSpread(*sub, c->spread, "adds the band of the limit");
  sub->add_flag("--json", c->json, "Print JSON: limits with the depth searched, whether verified, and the warnings");
  sub->add_option("--threads", c->threads, "Threads to work with")->check(CLI::Range(1, 64));
  sub->add_option("--out", c->out, "Write the table to OUT.csv instead of printing it");
  sub->callback([c, &exitCode] { exitCode = run(*c); });
}

}  // namespace stillcut::app
