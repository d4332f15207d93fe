// Figures of Xu 2003: rules, coherence over frequency, learned rules, and the closed loops of chapter 4 on the
// scenarios xu-*. The paper's times are about three times the true ones (section 4.4.6).
#include <algorithm>
#include <cmath>
#include <complex>

#include "app/cli/reproduce/figure.h"
#include "app/cli/reproduce/panels.h"
#include "core/control/fuzzy_rules.h"
#include "core/detect/xu/coherence_ratio.h"
#include "core/dsp/spectrum.h"

namespace stillcut::app {
namespace {

constexpr double kGammaRef = 0.8, kEnergyRef = 1.5;

struct LoopCase {
  const char* number;  // of the figure
  const char* scenario;
  const char* strategy;
  const char* setting;  // KEY=VALUE; empty: as it stands
  const char* shows;
  double immersion = 0.0;  // a/D; 0: the scenario's
};

constexpr LoopCase kLoops[] = {
    {"4.6", "xu-steel", "fuzzy", "", "steel, flat: fuzzy"},
    {"4.7", "xu-steel", "fuzzy-learning", "fuzzy-learning.weight=0.2", "steel, flat: self-learning, weight 0.2"},
    {"4.8", "xu-steel", "fuzzy-learning", "fuzzy-learning.weight=0.3", "steel, flat: self-learning, weight 0.3"},
    {"4.9", "xu-steel", "fuzzy-learning", "fuzzy-learning.weight=0.4", "steel, flat: self-learning, weight 0.4"},
    {"4.10", "xu-steel", "fuzzy-direct", "fuzzy-direct.tuning=single fuzzy-direct.coherence-weight=0.5",
     "steel, flat: single direct tuning, weight 0.5"},
    {"4.11", "xu-steel", "fuzzy-direct", "fuzzy-direct.tuning=single fuzzy-direct.coherence-weight=0.7",
     "steel, flat: single direct tuning, weight 0.7"},
    {"4.12", "xu-steel", "fuzzy-direct", "fuzzy-direct.tuning=double fuzzy-direct.energy-weight=1.0",
     "steel, flat: double direct tuning, weight 1.0"},
    {"4.13", "xu-steel", "fuzzy-direct", "fuzzy-direct.tuning=double fuzzy-direct.energy-weight=1.5",
     "steel, flat: double direct tuning, weight 1.5"},
    {"4.14", "xu-thin-wall-double", "fuzzy", "", "double thin wall: fuzzy"},
    {"4.15", "xu-thin-wall-double", "fuzzy-direct", "fuzzy-direct.tuning=single fuzzy-direct.coherence-weight=0.7",
     "double thin wall: single direct tuning"},
    {"4.16", "xu-thin-wall-double", "fuzzy-direct", "fuzzy-direct.tuning=double fuzzy-direct.energy-weight=1.5",
     "double thin wall: double direct tuning"},
    {"4.17", "xu-thin-wall-single", "fuzzy", "", "single thin wall: fuzzy"},
    {"4.18", "xu-thin-wall-single", "fuzzy-direct", "fuzzy-direct.tuning=double fuzzy-direct.energy-weight=1.5",
     "single thin wall: double direct tuning"},
    {"4.19", "xu-steel", "fuzzy", "", "steel, half immersion: fuzzy", 0.5},
    {"4.20", "xu-steel", "fuzzy-direct", "fuzzy-direct.tuning=double fuzzy-direct.energy-weight=1.5",
     "steel, half immersion: double direct tuning", 0.5},
    {"4.21", "xu-aluminium", "fuzzy", "", "aluminium, flat, 7 then 9 mm: fuzzy (also figure 4.22)"},
};

std::vector<std::string> settingsOf(const LoopCase& c) {
  std::vector<std::string> settings;
  const std::string_view all = c.setting;
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t end = std::min(all.find(' ', at), all.size());
    settings.emplace_back(all.substr(at, end - at));
    at = end + 1;
  }
  return settings;
}

Result<milling::Scenario> scenarioOf(const LoopCase& c) {
  auto scenario = paperScenario(c.scenario);
  if (scenario && c.immersion > 0.0) scenario->programme.immersion = milling::constantSchedule(c.immersion);
  return scenario;
}

double chatterSeconds(const CutTrace& trace, double from) {
  double seconds = 0.0, before = 0.0;
  for (std::size_t i = 0; i < trace.rows.size(); ++i) {
    const double t = trace.rows[i].t;
    if (t >= from && trace.history.points()[i].chattering) seconds += t - before;
    before = t;
  }
  return seconds;
}

// The paper's own measure.
double loudSeconds(const CutTrace& trace) {
  const auto energy = static_cast<std::size_t>(trace.indicator(0, "energy"));
  double seconds = 0.0, before = 0.0;
  for (const TraceRow& row : trace.rows) {
    if (row.verdicts[0].valid && row.verdicts[0].indicators[energy] > kEnergyRef) seconds += row.t - before;
    before = row.t;
  }
  return seconds;
}

// The rules are singletons 1 to 9; rows: the error's sets, columns: the change's, from NX to PX.
template <typename Table>
std::string tableText(const Table& table) {
  static constexpr std::array<const char*, 9> kSets{"NX", "NB", "NM", "NS", "ZE", "PS", "PM", "PB", "PX"};
  std::string text = "error";
  for (const char* set : kSets) text += std::string(",") + set;
  text += '\n';
  for (std::size_t r = 0; r < kSets.size(); ++r) {
    text += kSets[r];
    for (std::size_t c = 0; c < kSets.size(); ++c) {
      char number[24];
      std::snprintf(number, sizeof number, ",%.4g", static_cast<double>(table[r][c]));
      text += number;
    }
    text += '\n';
  }
  return text;
}
template <typename Table>
Panel tablePanel(const std::string& title, const Table& table) {
  Panel panel{title, "change of the coherence, from NX to PX", "error, from NX to PX"};
  LevelMap map{0.5, 9.5, 0.5, 9.5, 9, 9, {}, ""};
  for (std::size_t c = 0; c < 9; ++c) {
    for (std::size_t r = 0; r < 9; ++r) map.level.push_back(static_cast<double>(table[r][c]));
  }
  panel.map = std::move(map);
  return panel;
}

Result<FigureResult> closedLoop(const LoopCase& c) {
  const auto scenario = scenarioOf(c);
  if (!scenario) return scenario.error();
  const auto alone = traceCut(*scenario, {"monitor", {"coherence"}, {}});
  if (!alone) return alone.error();
  const auto trace = traceCut(*scenario, {c.strategy, {"coherence"}, settingsOf(c)});
  if (!trace) return trace.error();
  const CutTrace* const both[] = {&*alone, &*trace};
  const CutTrace* const one[] = {&*trace};
  FigureResult figure;
  figure.picture.title = std::string("Xu 2003, figure ") + c.number + ": " + c.shows;
  Panel gamma = indicatorPanel("Greatest coherence ratio", "gamma", *trace, "coherence", "gamma_max");
  gamma.curves.push_back({"reference", {0.0, trace->rows.back().t}, {kGammaRef, kGammaRef}, true});
  figure.picture.panels = {rowsPanel("Spindle speed", "rpm", one, turningSpeed),
                           rowsPanel("Feed", "mm/min", one, [](const TraceRow& r) { return r.feed_mm_min; }),
                           std::move(gamma),
                           indicatorPanel("Vibration energy", "m/s\u00b2", *trace, "coherence", "energy"),
                           rowsPanel("Chatter by the truth, over the forced vibration", "", both,
                                     [](const TraceRow& r) { return r.chatterRatio; })};
  const double end = trace->rows.back().t;
  figure.numbers = {{"seconds in chatter, left alone", "s", kNotPrinted, chatterSeconds(*alone, 0.0), ""},
                    {"seconds in chatter, controlled", "s", kNotPrinted, chatterSeconds(*trace, 0.0), ""},
                    {"of them in the second half", "s", 0.0, chatterSeconds(*trace, 0.5 * end),
                     "the paper: no long chatter after the initial period"},
                    {"seconds of vibration energy above 1.5, left alone", "s", kNotPrinted, loudSeconds(*alone), ""},
                    {"seconds of vibration energy above 1.5, controlled", "s", kNotPrinted, loudSeconds(*trace),
                     "the paper's measure and reference"},
                    {"speed at the end", "rpm", kNotPrinted, trace->rows.back().speed_rpm, ""}};
  if (trace->rules && trace->rules->lessons > 0) {
    figure.tables = {{"speed-rules", tableText(trace->rules->speed)}, {"feed-rules", tableText(trace->rules->feed)}};
  }
  return figure;
}

Result<FigureResult> printedRules() {
  FigureResult figure;
  figure.picture = {"Xu 2003, figures 3.7 and 3.8: rules for speed and feed",
                    {tablePanel("Speed", control::kSpeedRules), tablePanel("Feed", control::kFeedRules)}};
  figure.tables = {{"speed-rules", tableText(control::kSpeedRules)}, {"feed-rules", tableText(control::kFeedRules)}};
  return figure;
}

Result<FigureResult> learnedRules() {
  const auto scenario = paperScenario("xu-steel");
  if (!scenario) return scenario.error();
  const auto trace = traceCut(*scenario, {"fuzzy-learning", {"coherence"}, {}});
  if (!trace) return trace.error();
  if (!trace->rules) return Error{"xu-3.17", message("has no rules")};
  FigureResult figure;
  figure.picture = {"Xu 2003, figures 3.17 and 3.18: rules after learning",
                    {tablePanel("Speed", trace->rules->speed), tablePanel("Feed", trace->rules->feed)}};
  figure.tables = {{"speed-rules", tableText(trace->rules->speed)}, {"feed-rules", tableText(trace->rules->feed)}};
  double most = 0.0;
  for (std::size_t r = 0; r < 9; ++r) {
    for (std::size_t c = 0; c < 9; ++c)
      most = std::max(most, std::abs(static_cast<double>(trace->rules->speed[r][c]) - control::kSpeedRules[r][c]));
  }
  figure.numbers = {{"greatest change of a speed rule", "sets", 2.0, most, "by the printed tables 3.7 and 3.17"},
                    {"lessons", "", kNotPrinted, static_cast<double>(trace->rules->lessons), "one in six cycles"}};
  return figure;
}

// Figure 3.3: raw coherence of one second (eq. 3-5), smoothed and sharpened, and through the window of 170 to 250 Hz.
Result<FigureResult> coherence() {
  const auto scenario = paperScenario("xu-steel");
  if (!scenario) return scenario.error();
  const auto trace = traceCut(*scenario, {"monitor", {"coherence"}, {}});
  if (!trace) return trace.error();
  const double end = trace->rows.back().t;
  const std::vector<double> x = cutOut(*trace, 0, {end - 3.0, end - 2.0}),
                            y = cutOut(*trace, 1, {end - 3.0, end - 2.0});
  dsp::Spectrum spectrum;
  spectrum.prepare(static_cast<int>(x.size()), trace->rate, dsp::WindowKind::Hann);
  spectrum.transform(x);
  const std::vector<std::complex<double>> first(spectrum.values().begin(), spectrum.values().end());
  spectrum.transform(y);
  const auto bins = static_cast<std::size_t>(spectrum.bins());
  const auto curveOf = [&](const char* name, std::span<const double> values) {
    Curve curve{name, {}, {}};
    for (std::size_t b = 1; b < values.size() && static_cast<double>(b) * spectrum.binWidth() <= 500.0; ++b) {
      curve.x.push_back(static_cast<double>(b) * spectrum.binWidth());
      curve.y.push_back(values[b]);
    }
    return curve;
  };
  detect::HarmonicMask mask;
  mask.prepare(spectrum.bins(), spectrum.binWidth());
  mask.update(Hertz(800.0 / 60.0), Hertz(), 1.5, Hertz(0.45 * trace->rate.value));
  Panel a{"Raw, and smoothed and sharpened", "frequency [Hz]", "coherence"};
  Panel b{"Through the window of eq. 3-18", "frequency [Hz]", "coherence"};
  for (const bool windowed : {false, true}) {
    detect::CoherenceRatio ratio;
    detect::CoherenceRatio::Settings settings;
    settings.form = detect::CoherenceForm::Paper;
    settings.sharpening = detect::SharpenForm::Printed;
    if (windowed) settings.band = {Hertz(170.0), Hertz(250.0)};
    ratio.prepare(static_cast<int>(bins), spectrum.binWidth(), settings);
    ratio.update(first, spectrum.values());
    (void)ratio.peak(mask);
    if (!windowed) a.curves.push_back(curveOf("raw (eq. 3-5)", ratio.raw()));
    (windowed ? b : a).curves.push_back(curveOf(windowed ? "windowed" : "sharpened (eq. 3-17)", ratio.ratio()));
  }
  FigureResult figure;
  figure.picture = {"Xu 2003, figure 3.3: coherence of x and y in chatter", {std::move(a), std::move(b)}};
  figure.numbers = {
      {"chatter frequency of our cut", "Hz", kNotPrinted, trace->chatterHz, "the paper's chatter: 188 to 233 Hz"}};
  return figure;
}

// Figure 4.25: spectra before chatter, in it, and once it is suppressed. When that is comes from the truth: the paper's
// limit of the coherence ratio tells nothing of our cut (it is reached in the stable one too).
Result<FigureResult> stages() {
  const auto scenario = paperScenario("xu-steel");
  if (!scenario) return scenario.error();
  const auto trace = traceCut(*scenario, {"fuzzy-learning", {"coherence"}, {}});
  if (!trace) return trace.error();
  double begins = kNotPrinted, ends = kNotPrinted;
  for (std::size_t i = 0; i < trace->rows.size(); ++i) {
    const bool chatters = trace->history.points()[i].chattering;
    if (chatters && !std::isfinite(begins)) begins = trace->rows[i].t;
    if (!chatters && std::isfinite(begins) && !std::isfinite(ends)) ends = trace->rows[i].t;
  }
  if (!std::isfinite(begins)) return Error{"xu-4.25", message("its cut holds no chatter")};
  const auto stage = [&](const char* name, double at) {
    return density(name, cutOut(*trace, 0, {at - 0.5, at + 0.5}), trace->rate, 0.5);
  };
  FigureResult figure;
  figure.picture = {"Xu 2003, figure 4.25: chatter grows and is suppressed",
                    {densityPanel("Acceleration in x", "m/s\u00b2",
                                  {stage("1 s before chatter", begins - 1.0), stage("in chatter", begins + 0.5),
                                   stage("at the end", trace->rows.back().t - 1.5)},
                                  500.0)}};
  figure.numbers = {
      {"first chatter lasts", "s", 0.5, ends - begins, "the paper's clock runs about three times too fast"}};
  return figure;
}

}  // namespace

void addXuFigures(std::vector<Figure>& list) {
  const auto add = [&list](const char* number, const char* shows, std::function<Result<FigureResult>()> make) {
    list.push_back({std::string("xu-") + number, std::string("Xu 2003, figure ") + number, shows, std::move(make)});
  };
  add("3.3", "coherence over frequency: raw, sharpened, windowed", coherence);
  add("3.7", "rules for speed and feed (also figure 3.8)", printedRules);
  add("3.17", "rules after self-learning (also figure 3.18)", learnedRules);
  for (const LoopCase& c : kLoops) add(c.number, c.shows, [&c] { return closedLoop(c); });
  add("4.25", "spectra before, in and after chatter", stages);
}

}  // namespace stillcut::app
