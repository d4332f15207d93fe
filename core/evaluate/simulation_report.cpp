#include "core/evaluate/simulation_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/json_schema.h"

namespace stillcut::evaluate {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kMoved = 1e-3;     // a factor nearer to 1 than this is the programmed value
constexpr double kRest = 0.5;       // [s] a commanded speed must have stood still before a move counts as a new one
constexpr double kQuietFor = 0.25;  // [s] without true chatter that count as quiet
constexpr double kFinal = 1.0;      // [s] in the cut that count as the end

using Point = SimulationHistory::Point;

// The last second in the cut.
std::vector<Point> finalPoints(const std::vector<Point>& points) {
  std::vector<Point> last;
  double end = kNone;
  for (auto p = points.rbegin(); p != points.rend(); ++p) {
    if (!p->cutting) continue;
    if (std::isnan(end)) end = p->t;
    if (end - p->t > kFinal) break;
    last.push_back(*p);
  }
  return last;
}

double meanVibration(const std::vector<Point>& points) {
  double sum = 0.0;
  for (const Point& p : points) sum += p.vibration * p.vibration;
  return points.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(points.size()));
}

double peakVibration(const std::vector<Point>& points) {
  double peak = 0.0;
  for (const Point& p : points) peak = std::max(peak, p.vibration);
  return peak;
}

double share(const std::vector<Point>& points, bool Point::*what) {
  const auto n = std::count_if(points.begin(), points.end(), [&](const Point& p) { return p.*what; });
  return points.empty() ? 0.0 : static_cast<double>(n) / static_cast<double>(points.size());
}

std::string outcomeOf(const SimulationHistory& run) {
  std::vector<Point> inCut;
  std::copy_if(run.points().begin(), run.points().end(), std::back_inserter(inCut),
               [](const Point& p) { return p.cutting; });
  if (!inCut.empty() && share(inCut, &Point::usable) < 0.5) return "hold";
  std::vector<Point> last = finalPoints(run.points());
  const bool chatters = share(last, &Point::chattering) >= 0.5;
  // How it ended was not judged: no verdict of stable.
  std::erase_if(last, [](const Point& p) { return !p.cutting; });
  if (!chatters && !last.empty() && share(last, &Point::usable) < 0.5) return "hold";
  if (!chatters) return "stable";
  const ReasonCode why = run.lastRequestReason();
  const bool resigned = why == ReasonCode::TargetOutOfRange || why == ReasonCode::AlreadyThere ||
                        why == ReasonCode::NoStableSpeed || why == ReasonCode::NoStableSpeedTried;
  return resigned ? "no-stable-speed" : "chatter";
}

// As the gate counts them: a move on the way waits for the feed that is read back, and goes on.
int countMoves(const std::vector<Point>& points) {
  int moves = 0;
  double factor = 1.0, way = 0.0, lastMove = 0.0;
  for (const Point& p : points) {
    const double step = p.speedFactor - factor;
    if (std::abs(step) < 1e-4) continue;
    const bool goesOn = step * way > 0.0 && p.t - lastMove <= kRest;
    if (!goesOn) ++moves;
    way = step;
    factor = p.speedFactor;
    lastMove = p.t;
  }
  return moves;
}

double firstTime(const std::vector<Point>& points, bool Point::*what, double after) {
  for (const Point& p : points) {
    if (p.t >= after && p.*what) return p.t;
  }
  return kNone;
}

// From `from` on: when the true chatter ended for at least kQuietFor.
double quietTime(const std::vector<Point>& points, double from) {
  double quietSince = kNone;
  for (const Point& p : points) {
    if (p.t < from) continue;
    if (p.chattering) {
      quietSince = kNone;
    } else if (std::isnan(quietSince)) {
      quietSince = p.t;
    } else if (p.t - quietSince > kQuietFor) {
      return quietSince;
    }
  }
  return kNone;
}

nlohmann::json number(double v) {
  return std::isfinite(v) ? nlohmann::json(v) : nlohmann::json();
}

}  // namespace

void SimulationHistory::observe(const StepInput& input, const StepOutput& output, const milling::SimulatedCut& plant) {
  const Verdict& verdict = output.verdicts[static_cast<std::size_t>(output.inCharge)];
  Point p;
  p.t = plant.time().value;
  p.vibration = plant.truth().vibration();
  p.chattering = plant.truth().chattering();
  p.cutting = plant.cutting();
  p.usable = verdict.valid;
  p.alarming = verdict.alarming();
  p.speedFactor = points_.empty() ? 1.0 : points_.back().speedFactor;
  if (output.hasCommand) {
    const CommandRecord& c = output.command;
    p.speedFactor = c.kind == CommandKind::Set ? c.speed.value : 1.0;
    p.commandMoves =
        c.kind == CommandKind::Set && (std::abs(c.speed.value - 1.0) > kMoved || std::abs(c.feed.value - 1.0) > kMoved);
  }
  points_.push_back(p);
  if (!p.cutting) return;
  lastMachine_ = input.machine;
  nominalFeed_ = input.machine.programmedFeed;
  if (output.request.reason.code != ReasonCode::None) lastRequest_ = output.request.reason.code;
}

void SimulationHistory::finish(const milling::SimulatedCut& plant) {
  onset_ = plant.truth().onset().at20;
}

SimulationReport report(const SimulationHistory& controlled, const SimulationHistory& alone,
                        const milling::SimulatedCut& plant) {
  SimulationReport r;
  r.scenario = plant.scenario().name;
  r.outcome = outcomeOf(controlled);
  const double alarm = firstTime(controlled.points(), &Point::alarming, 0.0);
  const double command = std::isnan(alarm) ? kNone : firstTime(controlled.points(), &Point::commandMoves, alarm);
  const double quiet = std::isnan(command) ? kNone : quietTime(controlled.points(), command);
  r.alarmDelay = alarm - alone.onset();
  r.commandDelay = command - alarm;
  r.quietDelay = quiet - command;
  r.marked = plant.truth().marked().value * 1e3;
  const double alonePeak = peakVibration(alone.points());
  const double aloneFinal = meanVibration(finalPoints(alone.points()));
  r.peakRatio = alonePeak > 0.0 ? peakVibration(controlled.points()) / alonePeak : kNone;
  r.finalRatio = aloneFinal > 0.0 ? meanVibration(finalPoints(controlled.points())) / aloneFinal : kNone;
  r.finalSpeed = controlled.lastMachine().actualSpeed.value;
  r.finalFeed = toMmPerMin(controlled.lastMachine().actualFeed);
  r.mrrRatio =
      controlled.nominalFeed().value > 0.0 ? controlled.lastMachine().actualFeed / controlled.nominalFeed() : kNone;
  r.speedChanges = countMoves(controlled.points());
  return r;
}

nlohmann::json toJson(const SimulationReport& r) {
  return {{"schema", kJsonSchema},
          {"command", "simulate"},
          {"type", "answer"},
          {"scenario", r.scenario},
          {"strategy", r.strategy},
          {"outcome", r.outcome},
          {"alarm_delay_s", number(r.alarmDelay)},
          {"command_delay_s", number(r.commandDelay)},
          {"quiet_delay_s", number(r.quietDelay)},
          {"marked_mm", number(r.marked)},
          {"peak_ratio", number(r.peakRatio)},
          {"final_ratio", number(r.finalRatio)},
          {"final_speed_rpm", number(r.finalSpeed)},
          {"final_feed_mm_min", number(r.finalFeed)},
          {"mrr_ratio", number(r.mrrRatio)},
          {"speed_changes", r.speedChanges}};
}

std::string toText(const SimulationReport& r) {
  std::string text;
  const auto line = [&](const char* label, double value, const char* unit, int decimals) {
    char buffer[128];
    if (std::isfinite(value)) {
      std::snprintf(buffer, sizeof buffer, "  %-26s %10.*f %s\n", label, decimals, value, unit);
    } else {
      std::snprintf(buffer, sizeof buffer, "  %-26s %10s\n", label, "-");
    }
    text += buffer;
  };
  text += r.scenario + " with " + r.strategy + ": " + r.outcome + "\n";
  line("onset to alarm", r.alarmDelay * 1e3, "ms", 0);
  line("alarm to command", r.commandDelay * 1e3, "ms", 0);
  line("command to quiet", r.quietDelay * 1e3, "ms", 0);
  line("cut in chatter", r.marked, "mm", 2);
  line("peak vibration, of alone", r.peakRatio * 1e2, "%", 1);
  line("final vibration, of alone", r.finalRatio * 1e2, "%", 1);
  line("final speed", r.finalSpeed, "rpm", 0);
  line("final feed", r.finalFeed, "mm/min", 0);
  line("removal rate, of programmed", r.mrrRatio * 1e2, "%", 1);
  line("speed changes", r.speedChanges, "", 0);
  return text;
}

}  // namespace stillcut::evaluate
