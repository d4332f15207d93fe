#include "ui/models/history/spectrum_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/model/channel.h"
#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

constexpr std::size_t kMostHarmonics = 40;

std::vector<Hertz> multiplesOf(Hertz f, Hertz top) {
  std::vector<Hertz> out;
  if (!(f.value > 0.0)) return out;
  while (out.size() < kMostHarmonics && f * static_cast<double>(out.size() + 1) < top) {
    out.push_back(f * static_cast<double>(out.size() + 1));
  }
  return out;
}

Levels highest(const RunHistory& history, Instant from, Instant to) {
  Levels hold;
  hold.fill(-std::numeric_limits<float>::infinity());
  for (const SpectrumColumn& column : history.columns()) {
    if (column.time < from || column.time > to) continue;
    for (std::size_t b = 0; b < hold.size(); ++b) hold[b] = std::max(hold[b], column.level_dB[b]);
  }
  return hold;
}

QString levelText(float level_dB, LevelScale scale, const QString& unit) {
  if (scale == LevelScale::Linear) return join(significant(amplitudeOf(level_dB), 3), unit);
  return join(number(level_dB, 1), QStringLiteral("dB"));
}

// Of the spectrum on show, and where cursor B is set of the one under it.
QString readingAt(Hertz f, const SpectrumView& spectrum, const AnalyseView& view, const RunHistory& history) {
  QString text = join(number(f.value, f.value < 1000 ? 1 : 0), QStringLiteral("Hz"));
  if (spectrum.spindle.value > 0.0) text += say(", order %1").arg(number(f / spectrum.spindle, 2));
  const auto bin = static_cast<std::size_t>(std::clamp(f / spectrum.top * kSpectrumBins, 0.0, kSpectrumBins - 1.0));
  const LevelScale scale = view.options().level;
  text += QStringLiteral(", ") + levelText(spectrum.level_dB[bin], scale, spectrum.unit);
  if (const auto b = view.cursor(AnalyseView::B))
    text += say(", B: %1").arg(levelText(history.columnAt(*b)->level_dB[bin], scale, spectrum.unit));
  return text;
}

}  // namespace

QString channelUnit(const CutSetup& setup, int channel) {
  if (channel < 0 || channel >= static_cast<int>(setup.channels.size())) return {};
  const std::string_view si = siUnit(setup.channels[static_cast<std::size_t>(channel)].quantity);
  return QString::fromUtf8(si.data(), static_cast<qsizetype>(si.size()));
}

QString decibelUnit(const QString& unit) {
  return unit.isEmpty() ? say("dB") : say("dB re 1 %1").arg(unit);
}

QString rmsUnit(const QString& unit) {
  return unit.isEmpty() ? say("rms") : say("%1 rms").arg(unit);
}

double amplitudeOf(double level_dB) {
  return std::pow(10.0, level_dB / 20.0);
}

SpectrumView makeSpectrumView(const RunHistory& history, const AnalyseView& view, const SessionInfo& info) {
  SpectrumView out;
  out.top = history.spectrumTop();
  const auto cursor = view.cursor(AnalyseView::A);
  const SpectrumColumn* column = history.columnAt(cursor.value_or(view.to()));
  if (column == nullptr || !(out.top.value > 0.0)) return out;
  out.known = true;
  out.unit = channelUnit(info.setup, column->channel);
  out.atCursor = cursor.has_value();
  out.level_dB = column->level_dB;
  out.spindle = column->spindle;
  out.chatter = column->chatter;
  out.time = clockTime(info.wallMs(column->time));
  if (view.options().maxHold) out.hold = highest(history, view.from(), view.to());
  out.toothPassing = multiplesOf(column->spindle * static_cast<double>(info.setup.teeth), out.top);
  if (view.harmonic()) {
    out.harmonics = multiplesOf(*view.harmonic(), out.top);
    out.reading = readingAt(*view.harmonic(), out, view, history);
  }
  return out;
}

std::optional<Hertz> strongestLine(const Levels& level_dB, Hertz top, Hertz low, Hertz high) {
  const double width = top.value / kSpectrumBins;
  if (!(width > 0.0)) return std::nullopt;
  const int from = std::clamp(static_cast<int>(std::ceil(low.value / width)), 1, kSpectrumBins - 2);
  const int to = std::clamp(static_cast<int>(high.value / width), from, kSpectrumBins - 2);
  int best = -1;
  for (int b = from; b <= to; ++b) {
    const auto k = static_cast<std::size_t>(b);
    const bool peak = level_dB[k] > level_dB[k - 1] && level_dB[k] >= level_dB[k + 1];
    if (peak && (best < 0 || level_dB[k] > level_dB[static_cast<std::size_t>(best)])) best = b;
  }
  if (best < 0) return std::nullopt;
  const auto k = static_cast<std::size_t>(best);
  const double left = level_dB[k - 1], middle = level_dB[k], right = level_dB[k + 1];
  const double bend = left - 2.0 * middle + right;
  const double shift = bend < 0.0 ? std::clamp(0.5 * (left - right) / bend, -0.5, 0.5) : 0.0;
  return Hertz((best + 0.5 + shift) * width);
}

}  // namespace stillcut::ui
