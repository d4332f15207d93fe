// Figures of Caliskan 2018 on the scenarios caliskan-1, -2 and -3: what repeats with the spindle and what does not, the
// bank of band-passes, energy separation in the bands, and the energy ratio of each sensor by itself.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/cli/reproduce/figure.h"
#include "app/cli/reproduce/panels.h"
#include "core/detect/caliskan/energy_separation.h"
#include "core/dsp/kernels/choose.h"

namespace stillcut::app {
namespace {

constexpr Hertz kSpindle1{200.0};  // case 1: 12 000 rev/min, two teeth
constexpr int kHarmonics1 = 26;    // table 1
constexpr double kLambda1 = 1e-6;

Result<CutTrace> leftAlone(const std::string& name) {
  const auto scenario = paperScenario(name);
  if (!scenario) return scenario.error();
  return traceCut(*scenario, {"monitor", {"energy-ratio"}, {}});
}

double begin20(const CutTrace& trace) {
  return std::isfinite(trace.onset20_s) ? trace.onset20_s : 0.5 * trace.rows.back().t;
}
double cutEnds(const CutTrace& trace) {
  double t = 0.0;
  for (const TraceRow& row : trace.rows) t = row.cutting ? row.t : t;
  return t;
}

// Of the whole signal, so that the recursion has long settled in the stretch.
Curve part(const std::string& name, const std::vector<double>& all, Hertz rate, Stretch stretch) {
  Curve curve{name, {}, {}};
  const auto to = std::min(all.size(), static_cast<std::size_t>(stretch.to * rate.value));
  for (auto n = static_cast<std::size_t>(std::max(0.0, stretch.from * rate.value)); n < to; ++n) {
    curve.x.push_back(static_cast<double>(n) / rate.value);
    curve.y.push_back(all[n]);
  }
  return curve;
}

Result<FigureResult> separation() {
  const auto trace = leftAlone("caliskan-1");
  if (!trace) return trace.error();
  const std::vector<double>& x = trace->samples[0];
  const Separated split = separated(x, trace->rate, kSpindle1, kHarmonics1, kLambda1);
  const double onset = begin20(*trace), end = cutEnds(*trace);
  FigureResult figure;
  figure.picture.title = "Caliskan 2018, figure 5: periodic and chatter part of the acceleration, case 1";
  figure.picture.panels.push_back(signalPanel("Measured acceleration", *trace, 0));
  figure.picture.panels.back().marks.push_back({onset, "chatter is 20 %"});
  const std::pair<const char*, double> zones[] = {{"stable", onset - 0.5}, {"unstable", end - 0.3}};
  for (const auto& [name, at] : zones) {
    Panel time{std::string("Measured and periodic, ") + name, "time [s]", "m/s\u00b2"};
    time.curves = {part("measured", x, trace->rate, {at, at + 0.02}),
                   part("periodic", split.periodic, trace->rate, {at, at + 0.02})};
    const Stretch longer{at, at + 0.2};
    const auto piece = [&](const std::vector<double>& all) { return part("", all, trace->rate, longer).y; };
    Curve rest = density("rest", piece(split.rest), trace->rate, 0.05);
    if (std::string_view(name) == "unstable") {
      figure.numbers.push_back({"chatter frequency in band 6", "Hz", 2330.0, lineAt(rest, 2000.0, 2400.0), ""});
      figure.numbers.push_back({"chatter frequency in band 7", "Hz", 2769.0, lineAt(rest, 2400.0, 2800.0), ""});
    }
    Panel spectra = densityPanel(std::string("Spectra, ") + name, "m/s\u00b2",
                                 {density("measured", piece(x), trace->rate, 0.05),
                                  density("periodic", piece(split.periodic), trace->rate, 0.05), std::move(rest)},
                                 5200.0);
    figure.picture.panels.push_back(std::move(time));
    figure.picture.panels.push_back(std::move(spectra));
  }
  figure.numbers.push_back({"chatter begins", "s", 2.4, onset, "truth: 20 % of the vibration"});
  return figure;
}

// |H| of a Butterworth band-pass of 4th order, made by the bilinear transform, its edges at -3 dB.
double bandPass(double f, double low, double high, double rate) {
  const auto warp = [rate](double at) { return std::tan(std::numbers::pi * at / rate); };
  const double beside = (warp(f) * warp(f) - warp(low) * warp(high)) / (warp(f) * (warp(high) - warp(low)));
  return 1.0 / std::sqrt(1.0 + std::pow(beside, 4));
}

Result<FigureResult> bank() {
  constexpr double kRate = 25600.0, kPassing = 400.0;
  Panel panel{"Bands between the harmonics of the tooth passing", "frequency [Hz]", "magnitude"};
  for (int m = 2; m <= 13; ++m) {
    Curve curve{m < 8 ? "m = " + std::to_string(m) : "", {}, {}};
    for (double f = 10.0; f <= 6000.0; f += 10.0) {
      curve.x.push_back(f);
      curve.y.push_back(bandPass(f, (m - 1) * kPassing, m * kPassing, kRate));
    }
    panel.curves.push_back(std::move(curve));
  }
  for (int m = 1; m <= 13; ++m) panel.marks.push_back({m * kPassing, ""});
  FigureResult figure;
  figure.picture = {"Caliskan 2018, figure 6: bank of band-pass filters, case 1", {std::move(panel)}};
  figure.numbers = {{"gain at an edge", "dB", -3.0, 20.0 * std::log10(bandPass(800.0, 400.0, 800.0, kRate)), ""}};
  return figure;
}

Result<FigureResult> bands() {
  constexpr int kFirst = 5, kLast = 8, kTeeth = 2;
  constexpr std::size_t kHop = 128;
  const auto trace = leftAlone("caliskan-1");
  if (!trace) return trace.error();
  const Separated split = separated(trace->samples[0], trace->rate, kSpindle1, kHarmonics1, kLambda1);
  detect::EnergySeparation energy;
  energy.prepare(1, kHarmonics1 / kTeeth, trace->rate, kSpindle1 * kTeeth, dsp::kernels::bestKernels());
  energy.tune(kSpindle1, kTeeth, kHarmonics1);
  std::array<Curve, kLast - kFirst + 1> amplitudes, frequencies;
  for (std::size_t at = 0; at + kHop <= split.rest.size(); at += kHop) {
    energy.process(0, split.rest.data() + at, kHop);
    energy.advance(kHop);
    energy.estimate();
    for (std::size_t i = 0; i < amplitudes.size(); ++i) {
      const detect::BandEstimate band = energy.band(0, kFirst - 1 + static_cast<int>(i));
      const double t = static_cast<double>(at + kHop) / trace->rate.value;
      amplitudes[i].x.push_back(t);
      amplitudes[i].y.push_back(band.valid ? std::sqrt(band.power) : kNotPrinted);
      frequencies[i].x.push_back(t);
      frequencies[i].y.push_back(band.valid ? band.frequency.value : kNotPrinted);
    }
  }
  FigureResult figure;
  figure.picture.title = "Caliskan 2018, figure 7: chatter amplitudes and frequencies by energy separation, case 1";
  Panel rest{"What the harmonics leave", "time [s]", "m/s\u00b2"};
  rest.curves = {part("rest", split.rest, trace->rate, {0.0, 1e9})};
  Panel amplitude{"Amplitude by bands", "time [s]", "m/s\u00b2"}, frequency{"Frequency by bands", "time [s]", "Hz"};
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    amplitudes[i].name = frequencies[i].name = "m = " + std::to_string(kFirst + static_cast<int>(i));
    amplitude.curves.push_back(std::move(amplitudes[i]));
    frequency.curves.push_back(std::move(frequencies[i]));
  }
  Panel ratio = indicatorPanel("Energy ratio (eq. 28)", "ER", *trace, "energy-ratio", "er");
  double most = 0.0;
  for (const double v : ratio.curves[0].y) most = std::isfinite(v) ? std::max(most, v) : most;
  figure.numbers = {{"energy ratio in full chatter", "", 0.9, most, "the paper: reaches 90 %"}};
  figure.picture.panels = {std::move(rest), std::move(amplitude), std::move(frequency), std::move(ratio)};
  return figure;
}

// The energy ratio of each sensor of a scenario by itself.
struct InChatter {
  double hertz = kNotPrinted, ratio = kNotPrinted;
};
Result<FigureResult> sensors(const std::string& name, const std::string& title, std::vector<PaperNumber> numbers,
                             InChatter paper) {
  const auto scenario = paperScenario(name);
  if (!scenario) return scenario.error();
  FigureResult figure;
  figure.picture.title = title;
  figure.numbers = std::move(numbers);
  Panel together{"Energy ratio of each sensor by itself", "time [s]", "ER"};
  for (const milling::SensorSettings& sensor : scenario->sensors) {
    milling::Scenario one = *scenario;
    one.sensors = {sensor};
    const auto trace = traceCut(one, {"monitor", {"energy-ratio"}, {}});
    if (!trace) return trace.error();
    figure.picture.panels.push_back(signalPanel(sensor.name, *trace, 0));
    Panel ratio = indicatorPanel("", "", *trace, "energy-ratio", "er");
    ratio.curves[0].name = sensor.name;
    together.curves.push_back(std::move(ratio.curves[0]));
    const TraceRow* alarm = trace->firstAlarm();
    figure.numbers.push_back(
        {"first alarm of '" + sensor.name + "'", "s", kNotPrinted, alarm != nullptr ? alarm->t : kNotPrinted, ""});
    double heard = kNotPrinted, most = kNotPrinted;
    const auto er = static_cast<std::size_t>(trace->indicator(0, "er"));
    for (const TraceRow& row : trace->rows) {
      const Verdict& v = row.verdicts[0];
      if (v.alarming() && v.frequency.value > 0.0) heard = v.frequency.value;
      if (v.alarming() && !(v.indicators[er] < most)) most = v.indicators[er];
    }
    figure.numbers.push_back({"chatter frequency heard by '" + sensor.name + "'", "Hz", paper.hertz, heard, ""});
    figure.numbers.push_back({"greatest energy ratio of '" + sensor.name + "' in alarm", "", paper.ratio, most, ""});
  }
  together.curves.push_back({"0.2", {0.0, scenario->programme.duration.value}, {0.2, 0.2}, true});
  together.yRange = {0.0, 1.0};
  figure.picture.panels.push_back(std::move(together));
  return figure;
}

}  // namespace

void addCaliskanFigures(std::vector<Figure>& list) {
  list.push_back({"caliskan-5", "Caliskan 2018, figure 5", "periodic and chatter part of an acceleration", separation});
  list.push_back({"caliskan-6", "Caliskan 2018, figure 6", "bank of band-pass filters", bank});
  list.push_back(
      {"caliskan-7", "Caliskan 2018, figure 7", "amplitudes and frequencies in bands 5 to 8, energy ratio", bands});
  list.push_back({"caliskan-8", "Caliskan 2018, figure 8", "case 1: microphone and accelerometer", [] {
                    return sensors("caliskan-1", "Caliskan 2018, figure 8: case 1, each sensor by itself",
                                   {{"unstable from", "s", 2.4, kNotPrinted, "below: the alarms"}}, {kNotPrinted, 0.9});
                  }});
  list.push_back(
      {"caliskan-9", "Caliskan 2018, figure 9", "case 2: 20 mm stable, 25 mm unstable", [] {
         return sensors("caliskan-2", "Caliskan 2018, figure 9: case 2, from 20 to 25 mm at 2 s", {}, {1200.0, 0.5});
       }});
  list.push_back({"caliskan-10", "Caliskan 2018, figure 10", "case 3: microphone, accelerometer, speed, current", [] {
                    return sensors("caliskan-3", "Caliskan 2018, figure 10: case 3, each sensor by itself",
                                   {{"softer tool mode", "Hz", 732.0, kNotPrinted,
                                     "the paper's text tells no chatter frequency; below: what each sensor heard"}},
                                   {});
                  }});
}

}  // namespace stillcut::app
