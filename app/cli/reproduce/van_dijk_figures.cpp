// Figures of van Dijk 2010, section 5, on the scenario van-dijk-ramp; figure 7 on a sweep of its speed.
#include <algorithm>
#include <cmath>
#include <map>

#include "app/cli/reproduce/figure.h"
#include "app/cli/reproduce/panels.h"
#include "core/milling/stability/lobe_sweep.h"

namespace stillcut::app {
namespace {

constexpr double kTop = 5000.0;  // [Hz] half of the paper's 10 kHz

Result<CutTrace> ramp(const std::string& strategy) {
  auto scenario = paperScenario("van-dijk-ramp");
  if (!scenario) return scenario.error();
  return traceCut(*scenario, {strategy, {"parametric"}, {}});
}

double lastCut(const CutTrace& trace) {
  double t = 0.0;
  for (const TraceRow& row : trace.rows) t = row.cutting ? row.t : t;
  return t;
}

// Greatest magnitude in the last tenth of a second of the cut.
double finalPeak(const CutTrace& trace) {
  const double end = lastCut(trace);
  double peak = 0.0;
  for (const double v : cutOut(trace, 0, {end - 0.1, end})) peak = std::max(peak, std::abs(v));
  return peak;
}

Result<FigureResult> spectrumOfChatter() {
  const auto trace = ramp("monitor");
  if (!trace) return trace.error();
  const double end = lastCut(*trace);
  Curve y = density("y", cutOut(*trace, 1, {end - 0.4, end}), trace->rate, 0.1);
  FigureResult figure;
  figure.numbers.push_back({"chatter frequency", "Hz", kNotPrinted, lineAt(y, 1800.0, 2600.0), "the paper: near 2200"});
  Panel panel = densityPanel("Acceleration in y, last 0.4 s of the cut left alone", "m/s\u00b2", {std::move(y)}, kTop);
  for (int k = 1; k <= 4; ++k) panel.marks.push_back({k * 35000.0 / 30.0, std::to_string(k) + " f_tp"});
  figure.picture = {"van Dijk 2010, figure 4: spectrum in chatter", {std::move(panel)}};
  return figure;
}

Result<FigureResult> detection() {
  const auto trace = ramp("monitor");
  if (!trace) return trace.error();
  FigureResult figure;
  figure.picture.title = "van Dijk 2010, figure 9: detection, depth 2 to 3 mm over 600 mm at 35 000 rpm";
  figure.picture.panels = {
      signalPanel("Acceleration at the spindle, x", *trace, 0),
      indicatorPanel("Variance of the residual", "(m/s\u00b2)\u00b2", *trace, "parametric", "variance", Along::Path),
      indicatorPanel("H at the chatter frequency (eq. 26)", "", *trace, "parametric", "h", Along::Path),
      indicatorPanel("Magnitude of the dominant root", "", *trace, "parametric", "root", Along::Path)};
  figure.picture.panels[1].logY = figure.picture.panels[2].logY = true;
  const TraceRow* alarm = trace->firstAlarm();
  if (alarm != nullptr) {
    for (std::size_t i = 1; i < 4; ++i) figure.picture.panels[i].marks.push_back({alarm->path_mm, "detected"});
  }
  double onset = kNotPrinted;
  for (const TraceRow& row : trace->rows) {
    if (row.t >= trace->onset20_s && !std::isfinite(onset)) onset = row.path_mm;
  }
  figure.numbers = {{"chatter detected after", "mm", 288.0, alarm != nullptr ? alarm->path_mm : kNotPrinted,
                     "our limit is reached after 240 mm by choice of the model"},
                    {"first marks (chatter is 20 % of the vibration)", "mm", 293.0, onset, ""}};
  return figure;
}

Result<FigureResult> spectrogramAlone() {
  const auto trace = ramp("monitor");
  if (!trace) return trace.error();
  FigureResult figure;
  figure.picture = {"van Dijk 2010, figure 10: spectrogram without control",
                    {spectrogramPanel("Acceleration at the spindle, x", *trace, 0, 0.04, kTop)}};
  return figure;
}

struct Controlled {
  CutTrace alone, first, paper, seek;
};

Result<Controlled> controlled() {
  Controlled all;
  const std::pair<const char*, CutTrace*> cuts[] = {{"monitor", &all.alone},
                                                    {"lobe-center", &all.first},
                                                    {"extremum-paper", &all.paper},
                                                    {"extremum-seek", &all.seek}};
  for (const auto& [strategy, into] : cuts) {
    auto trace = ramp(strategy);
    if (!trace) return trace.error();
    *into = std::move(trace).value();
  }
  return all;
}

Result<FigureResult> strategies() {
  const auto cuts = controlled();
  if (!cuts) return cuts.error();
  const CutTrace* const three[] = {&cuts->first, &cuts->paper, &cuts->seek};
  const CutTrace* const four[] = {&cuts->alone, &cuts->first, &cuts->paper, &cuts->seek};
  FigureResult figure;
  figure.picture.title = "van Dijk 2010, figure 12: strategies 1 and 2";
  figure.picture.panels = {
      signalPanel("Acceleration, strategy 1 (lobe-center)", cuts->first, 0),
      signalPanel("Acceleration, strategy 2 (extremum-paper)", cuts->paper, 0),
      rowsPanel("Spindle speed", "rpm", three, turningSpeed), rowsPanel("Speed asked for", "rpm", three, askedSpeed),
      rowsPanel("Vibration of the tip", "m/s\u00b2 rms", four, [](const TraceRow& r) { return r.vibration; })};
  figure.numbers = {
      {"acceleration at the end, without control", "m/s2", 260.0, finalPeak(cuts->alone), "levels are of our model"},
      {"acceleration at the end, strategy 1", "m/s2", 200.0, finalPeak(cuts->first), ""},
      {"acceleration at the end, strategy 2", "m/s2", 145.0, finalPeak(cuts->paper), "extremum-paper"},
      {"acceleration at the end, strategy 2", "m/s2", 145.0, finalPeak(cuts->seek), "extremum-seek"},
      {"speed at the end, strategy 1", "rpm", kNotPrinted, cuts->first.rows.back().speed_rpm,
       "eq. 30 on 2200 Hz: 33000"},
      {"speed at the end, strategy 2", "rpm", kNotPrinted, cuts->paper.rows.back().speed_rpm, ""}};
  return figure;
}

Result<FigureResult> spectrogramsControlled() {
  const auto cuts = controlled();
  if (!cuts) return cuts.error();
  FigureResult figure;
  figure.picture = {"van Dijk 2010, figure 13: spectrograms under control",
                    {spectrogramPanel("Strategy 1 (lobe-center)", cuts->first, 0, 0.04, kTop),
                     spectrogramPanel("Strategy 2 (extremum-paper)", cuts->paper, 0, 0.04, kTop)}};
  return figure;
}

Result<FigureResult> waysInTheLobes() {
  const auto cuts = controlled();
  if (!cuts) return cuts.error();
  const auto scenario = paperScenario("van-dijk-ramp");
  if (!scenario) return scenario.error();
  const auto speeds = milling::speedSteps(Rpm(28000.0), Rpm(40000.0), Rpm(100.0), "speeds");
  if (!speeds) return speeds.error();
  milling::SweepOptions options;
  options.limits.maxAxialDepth = Metres(0.006);
  options.limits.firstOnly = true;
  options.limits.frequencies = false;
  const auto sweep = milling::sweepLobes(scenario->model, *speeds, options, "van-dijk-ramp");
  if (!sweep) return sweep.error();
  Panel panel{"Ways of the cuts", "spindle speed [rpm]", "depth of cut [mm]"};
  Curve limit{"limit", {}, {}};
  for (const milling::SpeedLimits& s : sweep->speeds) {
    limit.x.push_back(s.speed.value);
    limit.y.push_back(s.hasLimit() ? 1e3 * s.crossings.front().depth.value : kNotPrinted);
  }
  panel.curves.push_back(std::move(limit));
  for (const CutTrace* cut : {&cuts->first, &cuts->paper, &cuts->seek}) {
    Curve way{cut->name, {}, {}};
    for (const TraceRow& row : cut->rows) {
      if (!row.cutting || !(row.speed_rpm > 0.0)) continue;
      way.x.push_back(row.speed_rpm);
      way.y.push_back(row.depth_mm);
    }
    panel.curves.push_back(std::move(way));
  }
  panel.yRange = {0.0, 6.0};
  FigureResult figure;
  figure.picture = {"van Dijk 2010, figure 14: the cuts in the stability lobes", {std::move(panel)}};
  return figure;
}

// Figure 7: a sweep at constant depth, and where H is least and f_c meets a harmonic of the tooth passing.
Result<FigureResult> sweep() {
  constexpr double kFrom = 29600.0, kTo = 38600.0, kSeconds = 12.0, kCell = 200.0;
  auto scenario = paperScenario("van-dijk-ramp");
  if (!scenario) return scenario.error();
  milling::Programme& p = scenario->programme;
  p.speed = Rpm(kFrom);
  p.speedOverTime.segments = {{1.0, 1.0 + kSeconds, kFrom, kTo}};
  p.depth = milling::constantSchedule(2.2e-3);
  p.duration = Seconds(kSeconds + 1.5);
  p.exit.reset();
  const auto trace = traceCut(*scenario, {"monitor", {"parametric"}, {}});
  if (!trace) return trace.error();
  const auto h = static_cast<std::size_t>(trace->indicator(0, "h"));
  const auto f = static_cast<std::size_t>(trace->indicator(0, "frequency_hz"));
  Curve power{"H", {}, {}}, beside{"f_c - p f_tp", {}, {}};
  std::map<long, std::pair<double, int>> cells;  // of the speed: sum of log H
  for (const TraceRow& row : trace->rows) {
    const Verdict& v = row.verdicts[0];
    if (!row.cutting || !v.valid || row.t < 1.2 || !(v.indicators[h] > 0.0)) continue;
    const double passing = row.speed_rpm * trace->teeth / 60.0;
    power.x.push_back(row.speed_rpm);
    power.y.push_back(v.indicators[h]);
    beside.x.push_back(row.speed_rpm);
    beside.y.push_back(v.indicators[f] - passing * std::max(1.0, std::round(v.indicators[f] / passing)));
    auto& cell = cells[std::lround(row.speed_rpm / kCell)];
    cell.first += std::log(v.indicators[h]);
    ++cell.second;
  }
  double least = kNotPrinted, at = kNotPrinted;
  for (const auto& [speed, sum] : cells) {
    const double mean = sum.first / sum.second;
    if (std::isfinite(least) && mean >= least) continue;
    least = mean;
    at = static_cast<double>(speed) * kCell;
  }
  FigureResult figure;
  Panel upper{"Power spectral density at the chatter frequency", "spindle speed [rpm]", "H"};
  upper.curves.push_back(std::move(power));
  upper.logY = true;
  upper.marks.push_back({at, "least"});
  Panel lower{"Distance to the nearest tooth passing", "spindle speed [rpm]", "Hz"};
  lower.curves.push_back(std::move(beside));
  figure.picture = {"van Dijk 2010, figure 7: sweep from 29 600 to 38 600 rpm, 2.2 mm deep",
                    {std::move(upper), std::move(lower)}};
  figure.numbers = {{"speed where H is least", "rpm", 33600.0, at,
                     "in cells of 200 rpm; the paper's sweep is 3.5 mm deep, ours 2.2"}};
  return figure;
}

}  // namespace

void addVanDijkFigures(std::vector<Figure>& list) {
  const auto add = [&list](const char* number, const char* shows, Result<FigureResult> (*make)()) {
    list.push_back({std::string("van-dijk-") + number, std::string("van Dijk 2010, figure ") + number, shows, make});
  };
  add("4", "spectrum of the acceleration in chatter", spectrumOfChatter);
  add("7", "H and the distance to the tooth passing over a sweep of the speed", sweep);
  add("9", "acceleration and the three detection criteria", detection);
  add("10", "spectrogram without control", spectrogramAlone);
  add("12", "strategies 1 and 2: acceleration, speed, setpoint", strategies);
  add("13", "spectrograms under both strategies", spectrogramsControlled);
  add("14", "the controlled cuts in the plane of speed and depth, with the lobes", waysInTheLobes);
}

}  // namespace stillcut::app
