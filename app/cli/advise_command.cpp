// stillcut-cli advise FILE [--depth MM] [--speeds FROM:TO] [--feed MM] [--cutting-speed M_PER_MIN]
//                     [--spread FREQUENCY,DAMPING,STIFFNESS,FORCE] [--pitch-at RPM] [--json]

#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/cut_options.h"
#include "app/cli/json_line.h"
#include "core/milling/stability/advice.h"
#include "core/milling/stability/advice/pitch_advice.h"

namespace stillcut::app {
namespace {

using namespace milling;

struct AdviseCommand {
  CutOptions cut;
  std::string speeds;
  double depthMm = 0.0, cuttingSpeed = 0.0;  // 0: what the file says
  double pitchAt = 0.0;                      // [rev/min]; 0: speeds are asked for, not pitches
  std::vector<double> spread;                // [%]; none: the model is taken at its word
  int threads = 2;
  bool json = false;
};

Result<AdviceRequest> requestOf(const AdviseCommand& c, const CutFile& cut) {
  AdviceRequest request;
  request.depth = c.depthMm > 0.0 ? Metres(1e-3 * c.depthMm) : cut.depth;
  request.feedPerTooth = cut.feedPerTooth;
  request.lowest = cut.lowest;
  request.highest = cut.highest;
  request.threads = c.threads;
  if (c.cuttingSpeed > 0.0) request.cuttingSpeed = c.cuttingSpeed;
  const auto spread = spreadOf(c.spread, cut.model.material);
  if (!spread) return spread.error();
  request.spread = *spread;
  if (!(request.depth.value > 0.0)) {
    return Error{c.cut.file, message("does not say how deep the cut is"), message("give --depth MM")};
  }
  if (c.speeds.empty()) {
    if (request.highest > request.lowest) return request;
    return Error{c.cut.file, message("does not say which speeds are possible"), message("give --speeds FROM:TO")};
  }
  const std::vector<std::string> parts = CLI::detail::split(c.speeds, ':');
  const bool read = parts.size() == 2 && CLI::detail::lexical_cast(parts[0], request.lowest.value) &&
                    CLI::detail::lexical_cast(parts[1], request.highest.value);
  if (!read || !(request.lowest.value > 0.0) || !(request.highest > request.lowest)) {
    return Error{"--speeds", message("'%1' is no range", c.speeds), message("FROM:TO in rpm, as 3000:8000")};
  }
  return request;
}

// The wall that exists, the worse one of a slot.
double wallError(const ForcedVibration& forced) {
  double worst = 0.0;
  for (const auto& wall : {forced.upWall, forced.downWall}) {
    if (!wall) continue;
    for (Metres error : {wall->least, wall->greatest}) {
      if (std::abs(error.value) > std::abs(worst)) worst = error.value;
    }
  }
  return worst;
}

nlohmann::json asJson(const ForcedVibration& forced) {
  nlohmann::json j{{"acceleration_m_s2", forced.acceleration}, {"displacement_um", 1e6 * forced.displacement}};
  if (forced.upWall) {
    j["up_wall_um"] = {1e6 * forced.upWall->least.value, 1e6 * forced.upWall->greatest.value};
  }
  if (forced.downWall) {
    j["down_wall_um"] = {1e6 * forced.downWall->least.value, 1e6 * forced.downWall->greatest.value};
  }
  return j;
}

nlohmann::json asJson(const milling::SpeedAdvice& advice, const AdviceRequest& request, const CutFile& cut) {
  using nlohmann::json;
  json all = jsonObject("advise", "answer");
  all["case"] = cut.name;
  all["depth_mm"] = 1e3 * request.depth.value;
  all["lowest_rpm"] = request.lowest.value;
  all["highest_rpm"] = advice.highest.value;
  all["with_spread"] = request.spread.any();
  all["deepest"] = nullptr;
  all["pockets"] = json::array();
  all["warnings"] = json::array();
  for (const SpeedPocket& p : advice.pockets) {
    json pocket{{"from_rpm", p.from.speed.value},
                {"to_rpm", p.to.speed.value},
                {"best_rpm", p.best.value},
                {"limit_mm", 1e3 * p.limit.value},
                {"limit_open", p.open},
                {"expected_limit_mm", 1e3 * p.expected.value},
                {"margin", p.margin},
                {"width", p.width},
                {"chatter_below_hz", orNull(p.from.frequency.value, p.from.frequency.value > 0.0)},
                {"chatter_above_hz", orNull(p.to.frequency.value, p.to.frequency.value > 0.0)},
                {"removal_cm3_per_min", orNull(6e7 * p.removal, p.removal > 0.0)},
                {"forced", p.forced ? asJson(*p.forced) : json()},
                {"quietest", nullptr}};
    if (p.quietest) {
      pocket["quietest"] = asJson(p.quietest->forced);
      pocket["quietest"]["speed_rpm"] = p.quietest->speed.value;
      pocket["quietest"]["limit_mm"] = 1e3 * p.quietest->limit.value;
      pocket["quietest"]["limit_open"] = p.quietest->open;
    }
    all["pockets"].push_back(std::move(pocket));
  }
  if (advice.deepest) {
    all["deepest"] = {{"speed_rpm", advice.deepest->speed.value},
                      {"depth_mm", 1e3 * advice.deepest->depth.value},
                      {"chatter_hz", advice.deepest->frequency.value}};
  }
  for (const Message& warning : advice.warnings) all["warnings"].push_back(text(warning));
  return all;
}

// Where nothing limits the depth it is only known as deep as was searched.
const char* howDeep(bool open) {
  return open ? "at least" : "up to";
}

// Whole speeds that still lie inside.
void print(const milling::SpeedAdvice& advice, const AdviceRequest& request) {
  const double depth = 1e3 * request.depth.value;
  for (const SpeedPocket& p : advice.pockets) {
    std::printf("%.0f to %.0f rpm is stable at %.4g mm; best %.0f: %s %.3g mm", std::ceil(p.from.speed.value),
                std::floor(p.to.speed.value), depth, p.best.value, howDeep(p.open), 1e3 * p.limit.value);
    if (request.spread.any()) std::printf(" in nine of ten, %.3g mm expected", 1e3 * p.expected.value);
    if (p.removal > 0.0) std::printf(", %.3g cm3/min", 6e7 * p.removal);
    if (p.forced) {
      std::printf(", vibration %.3g m/s2, wall off by %.2g um", p.forced->acceleration, 1e6 * wallError(*p.forced));
    }
    if (p.quietest) {
      std::printf("; quietest %.0f: %s %.3g mm, vibration %.3g m/s2, wall off by %.2g um", p.quietest->speed.value,
                  howDeep(p.quietest->open), 1e3 * p.quietest->limit.value, p.quietest->forced.acceleration,
                  1e6 * wallError(p.quietest->forced));
    }
    std::printf("\n");
  }
  if (!advice.pockets.empty()) return;
  std::printf("no speed from %.0f to %.0f rpm is stable at %.4g mm", request.lowest.value, advice.highest.value, depth);
  if (advice.deepest) {
    std::printf("; the deepest stable cut is %.3g mm at %.0f rpm (chatter at %.0f Hz above it)",
                1e3 * advice.deepest->depth.value, advice.deepest->speed.value, advice.deepest->frequency.value);
  }
  std::printf("\n");
}

nlohmann::json asJson(const PitchChoice& choice) {
  std::vector<double> degrees;
  for (double angle : choice.pitch) degrees.push_back(std::round(angle * 3.6e5 / kTwoPi) / 1e3);
  return {{"pitch_deg", degrees}, {"limit_mm", 1e3 * choice.limit.value}};
}

int runPitch(const AdviseCommand& c, const CutFile& cut) {
  const Metres depth = c.depthMm > 0.0 ? Metres(1e-3 * c.depthMm) : cut.depth;
  if (!(depth.value > 0.0)) {
    return fail({c.cut.file, message("does not say how deep the cut is"), message("give --depth MM")});
  }
  const auto advice = advisePitch(cut.model, Rpm(c.pitchAt), depth, c.cut.file);
  if (!advice) return fail(advice.error());
  if (c.json) {
    const nlohmann::json all{{"case", cut.name},
                             {"depth_mm", 1e3 * depth.value},
                             {"speed_rpm", c.pitchAt},
                             {"searched_mm", 1e3 * advice->searched.value},
                             {"best", asJson(advice->best)},
                             {"even", asJson(advice->even)}};
    std::printf("%s\n", all.dump(1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return kExitDone;
  }
  std::printf("pitch");
  for (double angle : advice->best.pitch) std::printf(" %.1f", angle * 360.0 / kTwoPi);
  std::printf(" degrees: up to %.3g mm within 2 %% of %.0f rpm; even teeth: %.3g mm; searched to %.3g mm\n",
              1e3 * advice->best.limit.value, c.pitchAt, 1e3 * advice->even.limit.value, 1e3 * advice->searched.value);
  return kExitDone;
}

int run(const AdviseCommand& c) {
  const auto cut = readCut(c.cut);
  if (!cut) return fail(cut.error());
  if (c.pitchAt > 0.0 && !c.spread.empty()) {
    return fail({"--spread", message("is not for pitches"), message("ask for the speeds of a tool that has one")});
  }
  if (c.pitchAt > 0.0) return runPitch(c, *cut);
  const auto request = requestOf(c, *cut);
  if (!request) return fail(request.error());
  const auto advice = adviseSpeeds(cut->model, *request, c.cut.file);
  if (!advice) return fail(advice.error());
  for (const Message& warning : advice->warnings) std::fprintf(stderr, "warning: %s\n", text(warning).c_str());
  if (c.json) {
    printJsonLine(asJson(*advice, *request, *cut));
  } else {
    print(*advice, *request);
  }
  return kExitDone;
}

}  // namespace

void addAdvise(CLI::App& app, int& exitCode) {
  auto c = std::make_shared<AdviseCommand>();
  CLI::App* sub = app.add_subcommand("advise", "Which spindle speeds are stable at a depth");
  addCutOptions(*sub, c->cut);
  sub->add_option("--depth", c->depthMm, "Axial depth of the cut [mm]; left out: the file's")
      ->check(CLI::PositiveNumber);
  sub->add_option("--speeds", c->speeds, "FROM:TO [rpm]; left out: what the file's override reaches");
  sub->add_option("--cutting-speed", c->cuttingSpeed, "Largest of the tool [m/min]")->check(CLI::PositiveNumber);
  addSpread(*sub, c->spread, "speeds and depths then keep clear of the band of the limit");
  sub->add_option("--pitch-at", c->pitchAt, "Which pitch of the teeth would be best at this speed [rpm], instead")
      ->check(CLI::PositiveNumber);
  sub->add_flag("--json", c->json, "Print JSON");
  sub->add_option("--threads", c->threads, "Threads to work with")->check(CLI::Range(1, 64));
  sub->callback([c, &exitCode] { exitCode = run(*c); });
}

}  // namespace stillcut::app
