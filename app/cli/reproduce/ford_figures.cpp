// Figures of Ford 2013 on the scenarios ford-stable and ford-unstable: the active work-holder against the same cut
// without it.
#include <algorithm>
#include <cmath>

#include "app/cli/reproduce/figure.h"
#include "app/cli/reproduce/panels.h"
#include "app/compose/active_run.h"
#include "core/config/profile.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {
namespace {

struct Line {
  int channel;       // of the scenario's sensors
  double frequency;  // [Hz]
  double paper_dB;
  const char* remark;
};

struct ActiveFigure {
  const char* scenario;
  const char* setting;  // KEY=VALUE; empty: none
  const char* title;
  std::vector<Line> lines;
};

// Power within `width` of a line.
double powerAt(const Curve& density, double frequency, double width) {
  double sum = 0.0;
  for (std::size_t i = 0; i < density.x.size(); ++i) {
    if (std::abs(density.x[i] - frequency) <= width) sum += density.y[i];
  }
  return sum;
}

Result<FigureResult> make(const ActiveFigure& f) {
  const auto scenario = paperScenario(f.scenario);
  if (!scenario) return scenario.error();
  const auto alone = traceCut(*scenario, {"monitor", {}, {}});
  if (!alone) return alone.error();
  CutTrace held = *alone;
  held.name = "controlled";
  for (auto& channel : held.samples) channel.clear();
  ActiveOptions options;
  if (*f.setting != '\0') {
    const Status set = config::applySetting(options.params, pipeline::fullCatalog(), f.setting);
    if (!set) return set.error();
  }
  options.observe = [&held](const SampleBlock& block, const milling::SimulatedCut&) {
    for (std::size_t c = 0; c < held.samples.size(); ++c) {
      for (const float v : block.channel(static_cast<int>(c)))
        held.samples[c].push_back(held.channels[c].scale * static_cast<double>(v));
    }
  };
  const auto result = runActive(*scenario, options);
  if (!result) return result.error();

  const double end = scenario->programme.duration.value;
  const Stretch last{end - 2.0, end};
  FigureResult figure;
  figure.picture.title = f.title;
  const int shown = f.lines.front().channel;
  const auto& info = alone->channels[static_cast<std::size_t>(shown)];
  const std::string what = info.name + ", " + std::string(name(info.quantity));
  figure.picture.panels = {signalPanel(what + ", without control", *alone, shown),
                           signalPanel(what + ", with control", held, shown)};
  for (int c = 0; c < 4 && c < static_cast<int>(alone->channels.size()); ++c) {
    const auto shows = [c](const Line& l) { return l.channel == c; };
    if (std::none_of(f.lines.begin(), f.lines.end(), shows)) continue;
    const auto& channel = alone->channels[static_cast<std::size_t>(c)];
    Curve before = density("without control", cutOut(*alone, c, last), alone->rate, 0.5);
    Curve after = density("with control", cutOut(held, c, last), alone->rate, 0.5);
    for (const Line& line : f.lines) {
      if (line.channel != c) continue;
      const double dB = 10.0 * std::log10(powerAt(before, line.frequency, 5.0) / powerAt(after, line.frequency, 5.0));
      char name[96];
      std::snprintf(name, sizeof name, "reduction of %s within 5 Hz of %.4g Hz", channel.name.c_str(), line.frequency);
      figure.numbers.push_back({name, "dB", line.paper_dB, dB, line.remark});
    }
    figure.picture.panels.push_back(densityPanel(channel.name + ", last two seconds",
                                                 std::string(siUnit(channel.quantity)),
                                                 {std::move(before), std::move(after)}, 1500.0));
  }
  figure.numbers.push_back({"chatter left", "", 0.0, result->chatterControlled ? 1.0 : 0.0, "1: it still chatters"});
  figure.numbers.push_back({"vibration of the tip, with over without", "", kNotPrinted, result->finalRatio, ""});
  return figure;
}

}  // namespace

void addFordFigures(std::vector<Figure>& list) {
  list.push_back({"ford-7", "Ford 2013, figure 7", "stable cut, acceleration feedback", [] {
                    return make(
                        {"ford-stable",
                         "",
                         "Ford 2013, figure 7: stable cut, acceleration feedback",
                         {{1, 1000.0, 16.0, "the paper: up to 16 to 17 dB in y"}, {0, 600.0, 10.5, "70 % in x"}}});
                  }});
  list.push_back({"ford-8", "Ford 2013, figure 8 and table 4", "stable cut, force feedback", [] {
                    return make({"ford-stable",
                                 "active.feedback=force",
                                 "Ford 2013, figure 8: stable cut, dynamic force feedback",
                                 {{2, 59.0, 6.5, "the paper's tooth passing; ours is at 63.6 Hz"},
                                  {2, 63.6, 6.5, "6 to 7 dB in x"},
                                  {3, 63.6, 6.5, "6 to 7 dB in y"}}});
                  }});
  list.push_back({"ford-11", "Ford 2013, figures 10 and 11", "unstable cut, acceleration feedback", [] {
                    return make({"ford-unstable",
                                 "",
                                 "Ford 2013, figure 11: unstable cut made stable",
                                 {{0, 339.0, 23.0, "the paper does not say which axis"},
                                  {1, 339.0, 23.0, ""},
                                  {0, 1024.0, 24.5, ""},
                                  {1, 1024.0, 24.5, ""}}});
                  }});
}

}  // namespace stillcut::app
