// Figures of Liao 1996: figure 4 on the loop of its figure 1 (one mode, a constant delay), figures 6 and 7 on the
// scenarios liao-1 and liao-2; the corrected speeds also by the rule on the paper's own frequencies.
#include <array>
#include <cmath>
#include <numbers>

#include "app/cli/reproduce/figure.h"
#include "app/cli/reproduce/panels.h"
#include "core/control/quarter_phase.h"

namespace stillcut::app {
namespace {

// y'' + 2 zeta w y' + w^2 y = -w^2 r (y - y(t - T)), after a knock.
class Loop {
 public:
  static constexpr double kStep = 5e-5;  // [s]
  static constexpr double kNatural = 30.0, kDamping = 0.025, kRatio = 0.2;
  static constexpr double kFree = 1.0 / 19.6;  // [s] delay without control
  static constexpr double kChatter = 33.2;     // [Hz] as the paper has it
  static constexpr double kSwitch = 2.0, kEnd = 4.0;

  // nu < 0: without control.
  static std::vector<double> run(double nu) {
    const double w = 2.0 * std::numbers::pi * kNatural;
    std::vector<double> y{1e-3};
    double v = 0.0;
    for (double t = 0.0; t < kEnd; t += kStep) {
      const double delay = t >= kSwitch && nu >= 0.0 ? (1.0 + nu) / kChatter : kFree;
      const double back = static_cast<double>(y.size()) - 1.0 - delay / kStep;
      double before = 0.0;
      if (back >= 0.0) {
        const auto whole = static_cast<std::size_t>(back);
        before = y[whole] + (back - std::floor(back)) * (y[whole + 1] - y[whole]);
      }
      const double now = y.back();
      v += kStep * (-2.0 * kDamping * w * v - w * w * now - w * w * kRatio * (now - before));
      y.push_back(now + kStep * v);
    }
    return y;
  }
  // Growth of the greatest magnitude [1/s] from one stretch to the next.
  static double growth(const std::vector<double>& y, double from, double to) {
    const auto peak = [&y](double a) {
      double most = 0.0;
      for (auto i = static_cast<std::size_t>(a / kStep); i < static_cast<std::size_t>((a + 0.2) / kStep); ++i)
        most = std::max(most, std::abs(y[i]));
      return most;
    };
    return std::log(peak(to - 0.2) / peak(from)) / (to - 0.2 - from);
  }
};

Result<FigureResult> simulation() {
  struct Case {
    double nu, paper;
    const char* name;
  };
  // Rates by derivation from the paper's loop with its damping corrected (methods.md): it prints none.
  constexpr std::array<Case, 6> kCases{{{-1.0, kNotPrinted, "without control"},
                                        {0.25, kNotPrinted, "nu 0.25"},
                                        {0.4, kNotPrinted, "nu 0.4"},
                                        {0.1, kNotPrinted, "nu 0.1"},
                                        {0.75, kNotPrinted, "nu 0.75"},
                                        {1.0, kNotPrinted, "nu 1"}}};
  FigureResult figure;
  figure.picture.title = "Liao 1996, figure 4: control at 2 s by the phase factor";
  for (const Case& c : kCases) {
    Curve curve{c.name, {}, Loop::run(c.nu)};
    for (std::size_t n = 0; n < curve.y.size(); ++n) curve.x.push_back(static_cast<double>(n) * Loop::kStep);
    const double after = Loop::growth(curve.y, Loop::kSwitch + 0.1, Loop::kSwitch + 0.7);
    figure.numbers.push_back({std::string("growth after 2 s, ") + c.name, "1/s", c.paper, after,
                              c.nu == 0.25 ? "dies soonest, as in the paper" : ""});
    if (c.nu < 0.0) {
      const Curve spectrum = density("", std::span(curve.y).subspan(20000, 40000), Hertz(1.0 / Loop::kStep), 2.0);
      figure.numbers.push_back({"chatter frequency", "Hz", 33.2, lineAt(spectrum, 25.0, 45.0),
                                "with a damping of 0.025: the printed 0.25 is stable at every speed"});
    }
    Panel panel{c.name, "time [s]", "y"};
    panel.curves.push_back(std::move(curve));
    panel.marks.push_back({Loop::kSwitch, "control"});
    figure.picture.panels.push_back(std::move(panel));
  }
  return figure;
}

double byRule(double chatter, double present) {
  const config::SpeedRange reach{Rpm(0.0), Rpm(1000.0)};
  return control::quarterPhaseSpeed(Hertz(chatter), 4, Rpm(present), 0.25, control::SpeedDirection::Down, reach)
      .speed.value;
}

Result<FigureResult> experiment(const std::string& name, const std::string& title, std::vector<PaperNumber> numbers) {
  const auto scenario = paperScenario(name);
  if (!scenario) return scenario.error();
  const auto alone = traceCut(*scenario, {"monitor", {"spectral"}, {}});
  if (!alone) return alone.error();
  const auto controlled = traceCut(*scenario, {"quarter-phase", {"spectral"}, {}});
  if (!controlled) return controlled.error();
  const CutTrace* const both[] = {&*alone, &*controlled};
  const double end = scenario->programme.duration.value;
  const TraceRow* alarm = controlled->firstAlarm();
  const double began = alarm != nullptr ? alarm->t : 0.5 * end;
  FigureResult figure;
  figure.picture.title = title;
  figure.picture.panels = {
      signalPanel("Force in x, left alone", *alone, 0),
      signalPanel("Force in x, under the quarter-phase rule", *controlled, 0),
      rowsPanel("Spindle speed", "rpm", both, turningSpeed),
      densityPanel(
          "Force in x", "N",
          {density("before the alarm", cutOut(*controlled, 0, {began - 1.0, began}), controlled->rate, 0.512),
           density("left alone, at the end", cutOut(*alone, 0, {end - 1.5, end - 0.3}), alone->rate, 0.512),
           density("controlled, at the end", cutOut(*controlled, 0, {end - 1.5, end - 0.3}), controlled->rate, 0.512)},
          500.0)};
  figure.numbers = std::move(numbers);
  figure.numbers.push_back({"chatter frequency of our cut", "Hz", kNotPrinted, alone->chatterHz, "of our model"});
  figure.numbers.push_back(
      {"speed at the end of our cut", "rpm", kNotPrinted, controlled->rows.back().asked_rpm, "asked for"});
  return figure;
}

}  // namespace

void addLiaoFigures(std::vector<Figure>& list) {
  list.push_back(
      {"liao-4", "Liao 1996, figure 4", "displacement without control and with five phase factors", simulation});
  list.push_back({"liao-6", "Liao 1996, figure 6", "S45C: force and spectra before and after the corrections", [] {
                    return experiment("liao-1", "Liao 1996, figure 6: S45C at 950 rpm",
                                      {{"rule on 150 Hz at 950 rpm", "rpm", 694.0, byRule(150.0, 950.0), ""},
                                       {"rule on 115.2 Hz at 694 rpm", "rpm", 531.0, byRule(115.2, 694.0), ""}});
                  }});
  list.push_back({"liao-7", "Liao 1996, figure 7", "aluminium: force and spectra before and after the correction", [] {
                    return experiment("liao-2", "Liao 1996, figure 7: aluminium at 1000 rpm",
                                      {{"rule on 125 Hz at 1000 rpm", "rpm", 833.3, byRule(125.0, 1000.0), ""}});
                  }});
}

}  // namespace stillcut::app
