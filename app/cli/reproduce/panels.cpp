#include "app/cli/reproduce/panels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/detect/turning_harmonics.h"
#include "core/dsp/kernels/choose.h"
#include "core/dsp/spectrum.h"

namespace stillcut::app {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kMapColumns = 240, kMapRows = 160;

double placeOf(const TraceRow& row, Along along) {
  return along == Along::Time ? row.t : row.path_mm;
}
std::string placeLabel(Along along) {
  return along == Along::Time ? "time [s]" : "path [mm]";
}

}  // namespace

double turningSpeed(const TraceRow& row) {
  return row.speed_rpm > 0.0 ? row.speed_rpm : kNone;
}

double askedSpeed(const TraceRow& row) {
  return row.asked_rpm > 0.0 ? row.asked_rpm : kNone;
}

Panel rowsPanel(const std::string& title, const std::string& yLabel, std::span<const CutTrace* const> traces,
                const OfRow& value, Along along) {
  Panel panel{title, placeLabel(along), yLabel};
  for (const CutTrace* trace : traces) {
    Curve curve{trace->name, {}, {}};
    for (const TraceRow& row : trace->rows) {
      if (along == Along::Path && !row.cutting) continue;
      curve.x.push_back(placeOf(row, along));
      curve.y.push_back(value(row));
    }
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

Panel indicatorPanel(const std::string& title, const std::string& yLabel, const CutTrace& trace,
                     std::string_view detector, std::string_view indicator, Along along) {
  const int d = trace.detector(detector);
  const int i = d < 0 ? -1 : trace.indicator(d, indicator);
  const CutTrace* const one[] = {&trace};
  return rowsPanel(
      title, yLabel, one,
      [d, i](const TraceRow& row) {
        if (i < 0) return kNone;
        const Verdict& v = row.verdicts[static_cast<std::size_t>(d)];
        return v.valid ? v.indicators[static_cast<std::size_t>(i)] : kNone;
      },
      along);
}

Panel signalPanel(const std::string& title, const CutTrace& trace, int channel) {
  const auto c = static_cast<std::size_t>(channel);
  Panel panel{title, "time [s]", std::string(siUnit(trace.channels[c].quantity))};
  Curve curve{trace.name, {}, trace.samples[c]};
  for (std::size_t n = 0; n < curve.y.size(); ++n) curve.x.push_back(static_cast<double>(n) / trace.rate.value);
  panel.curves.push_back(std::move(curve));
  return panel;
}

std::vector<double> cutOut(const CutTrace& trace, int channel, Stretch stretch) {
  const std::vector<double>& all = trace.samples[static_cast<std::size_t>(channel)];
  const auto at = [&](double t) {
    return static_cast<long>(std::clamp(t * trace.rate.value, 0.0, static_cast<double>(all.size())));
  };
  return {all.begin() + at(stretch.from), all.begin() + std::max(at(stretch.from), at(stretch.to))};
}

Curve density(const std::string& name, std::span<const double> samples, Hertz rate, double window) {
  Curve curve{name, {}, {}};
  const auto wanted = static_cast<std::size_t>(std::max(16.0, window * rate.value));
  const std::size_t length = std::min(wanted, samples.size());
  if (length < 16) return curve;
  dsp::Spectrum spectrum;
  spectrum.prepare(static_cast<int>(length), rate, dsp::WindowKind::Hann);
  std::vector<double> sum(static_cast<std::size_t>(spectrum.bins()), 0.0);
  int taken = 0;
  for (std::size_t at = 0; at + length <= samples.size(); at += std::max<std::size_t>(1, length / 2), ++taken) {
    spectrum.transform(samples.subspan(at, length));
    for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += spectrum.density(static_cast<int>(b));
  }
  for (std::size_t b = 0; b < sum.size(); ++b) {
    curve.x.push_back(static_cast<double>(b) * spectrum.binWidth());
    curve.y.push_back(sum[b] / taken);
  }
  return curve;
}

double lineAt(const Curve& density, double from, double to) {
  double best = 0.0, frequency = kNone;
  for (std::size_t i = 0; i < density.x.size(); ++i) {
    if (density.x[i] < from || density.x[i] > to || !(density.y[i] > best)) continue;
    best = density.y[i];
    frequency = density.x[i];
  }
  return frequency;
}

Panel densityPanel(const std::string& title, const std::string& unit, std::vector<Curve> curves, double to_Hz) {
  Panel panel{title, "frequency [Hz]", "(" + unit + ")\u00b2/Hz"};
  for (Curve& curve : curves) {
    Curve part{curve.name, {}, {}};
    for (std::size_t i = 1; i < curve.x.size() && curve.x[i] <= to_Hz; ++i) {
      part.x.push_back(curve.x[i]);
      part.y.push_back(curve.y[i]);
    }
    panel.curves.push_back(std::move(part));
  }
  panel.logY = true;
  return panel;
}

Panel spectrogramPanel(const std::string& title, const CutTrace& trace, int channel, double window, double to_Hz) {
  const std::vector<double>& samples = trace.samples[static_cast<std::size_t>(channel)];
  Panel panel{title, "time [s]", "frequency [Hz]"};
  const auto length = static_cast<std::size_t>(window * trace.rate.value);
  if (length < 16 || samples.size() < length) return panel;
  dsp::Spectrum spectrum;
  spectrum.prepare(static_cast<int>(length), trace.rate, dsp::WindowKind::Hann);
  const double top = std::min(to_Hz, 0.5 * trace.rate.value);
  LevelMap map{0.0, static_cast<double>(samples.size()) / trace.rate.value, 0.0, top, kMapColumns, kMapRows, {}, "dB"};
  map.level.assign(static_cast<std::size_t>(kMapColumns) * kMapRows, -300.0);
  for (int c = 0; c < kMapColumns; ++c) {
    const std::size_t at = static_cast<std::size_t>(c) * (samples.size() - length) / (kMapColumns - 1);
    spectrum.transform(std::span(samples).subspan(at, length));
    // Of the bins that meet in one row the loudest.
    for (int b = 1; b < spectrum.bins() && b * spectrum.binWidth() < top; ++b) {
      const auto row = static_cast<std::size_t>(b * spectrum.binWidth() / top * kMapRows);
      double& level = map.level[static_cast<std::size_t>(c) * kMapRows + std::min<std::size_t>(row, kMapRows - 1)];
      level = std::max(level, 10.0 * std::log10(spectrum.density(b) + 1e-30));
    }
    // Where a row is narrower than a bin it takes its neighbour's.
    for (std::size_t r = 1; r < kMapRows; ++r) {
      double& level = map.level[static_cast<std::size_t>(c) * kMapRows + r];
      if (level <= -300.0) level = map.level[static_cast<std::size_t>(c) * kMapRows + r - 1];
    }
  }
  panel.map = std::move(map);
  return panel;
}

Separated separated(std::span<const double> samples, Hertz rate, Hertz spindle, int harmonics, double lambda) {
  detect::RotatingHarmonicFilter filter;
  filter.prepare(1, harmonics, dsp::kernels::bestKernels());
  filter.setActive(std::min(harmonics, static_cast<int>(0.45 * rate.value / spindle.value)));
  filter.setGain(detect::harmonicGain(lambda, filter.active()));
  const double step = 2.0 * std::numbers::pi * spindle.value / rate.value;
  Separated out;
  out.rest.resize(samples.size());
  constexpr std::size_t kRun = 256;
  for (std::size_t at = 0; at < samples.size(); at += kRun) {
    const std::size_t frames = std::min(kRun, samples.size() - at);
    filter.align(std::fmod(step * static_cast<double>(at), 2.0 * std::numbers::pi), step);
    filter.process(0, samples.data() + at, out.rest.data() + at, frames, filter.afterCorrection());
    filter.advance(frames);
  }
  for (std::size_t n = 0; n < samples.size(); ++n) out.periodic.push_back(samples[n] - out.rest[n]);
  return out;
}

}  // namespace stillcut::app
