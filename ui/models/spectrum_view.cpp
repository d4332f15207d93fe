#include "ui/models/spectrum_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/models/format.h"
#include "ui/models/say.h"

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

QString readingAt(Hertz f, const SpectrumView& view) {
  QString text = join(number(f.value, f.value < 1000 ? 1 : 0), QStringLiteral("Hz"));
  if (view.spindle.value > 0.0) text += say(", order %1").arg(number(f / view.spindle, 2));
  const auto bin = static_cast<std::size_t>(std::clamp(f / view.top * kSpectrumBins, 0.0, kSpectrumBins - 1.0));
  return text + QStringLiteral(", ") + join(number(view.level_dB[bin], 1), QStringLiteral("dB"));
}

}  // namespace

SpectrumView makeSpectrumView(const RunHistory& history, const AnalyseView& view, const SessionInfo& info) {
  SpectrumView out;
  out.top = history.spectrumTop();
  const auto cursor = view.cursor(AnalyseView::A);
  const SpectrumColumn* column = history.columnAt(cursor.value_or(view.to()));
  if (column == nullptr || !(out.top.value > 0.0)) return out;
  out.known = true;
  out.atCursor = cursor.has_value();
  out.level_dB = column->level_dB;
  out.spindle = column->spindle;
  out.chatter = column->chatter;
  out.time = clockTime(info.wallMs(column->time));
  if (view.options().maxHold) out.hold = highest(history, view.from(), view.to());
  out.toothPassing = multiplesOf(column->spindle * static_cast<double>(info.setup.teeth), out.top);
  if (view.harmonic()) {
    out.harmonics = multiplesOf(*view.harmonic(), out.top);
    out.reading = readingAt(*view.harmonic(), out);
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
