#include "ui/plots/history_map.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/models/format.h"
#include "ui/plots/axis_painter.h"
#include "ui/plots/waterfall.h"

namespace stillcut::ui {
namespace {

constexpr int kMostWaterfallLines = 36;

}  // namespace

HistoryMap::HistoryMap(AnalyseView& view, QWidget* parent) : TimePlot(view, tr("SPECTROGRAM"), parent) {
  setToolTip(tr("Drag: move. Wheel: zoom. Ctrl and drag: zoom to a stretch. Click: cursor A, with Shift B."));
}

void HistoryMap::display(const RunHistory* history, int teeth) {
  history_ = history;
  teeth_ = teeth;
  if (history_ == nullptr) return;
  const auto& columns = history_->columns();
  auto fresh = columns.end();
  while (fresh != columns.begin() && (fresh - 1)->time > seen_) --fresh;
  for (; fresh != columns.end(); ++fresh) {
    range_.add(fresh->level_dB);
    seen_ = fresh->time;
  }
  update();
}

void HistoryMap::restart() {
  range_ = LevelRange();
  seen_ = {};
  history_ = nullptr;
}

QSize HistoryMap::minimumSizeHint() const {
  return {theme().px(420), theme().px(150)};
}

Hertz HistoryMap::frequencyAt(double y) const {
  const QRect plot = plotRect();
  const AnalyseOptions& o = view().options();
  return o.low + (o.high - o.low) * ((plot.bottom() + 1 - y) / std::max(plot.height(), 1));
}

double HistoryMap::yOf(Hertz f, const QRect& plot) const {
  const AnalyseOptions& o = view().options();
  return plot.bottom() + 1 - (f - o.low) / (o.high - o.low) * plot.height();
}

double HistoryMap::placeOf(float level_dB) const {
  if (!std::isfinite(level_dB)) return 0.0;
  if (view().options().level == LevelScale::Decibel) return range_.place(level_dB);
  return std::clamp(std::pow(10.0, (static_cast<double>(level_dB) - range_.high()) / 20.0), 0.0, 1.0);
}

void HistoryMap::panUp(double share) {
  const AnalyseOptions& o = view().options();
  view().panFrequency((o.high - o.low) * share);
}

void HistoryMap::zoomUp(double factor, double y) {
  view().zoomFrequency(factor, std::max(frequencyAt(y), Hertz()));
}

void HistoryMap::clicked(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  if (view().options().form == SpectrogramForm::HeatMap) {
    TimePlot::clicked(at, modifiers);
    return;
  }
  const QRect plot = plotRect();
  const AnalyseOptions& o = view().options();
  view().setHarmonic(o.low + (o.high - o.low) * ((at.x() - plot.left()) / std::max(plot.width(), 1)));
}

void HistoryMap::drawPlot(QPainter& p, const QRect& plot) {
  const AnalyseOptions& o = view().options();
  if (history_ == nullptr || history_->columns().empty()) {
    p.setFont(theme().font(type_size::kValue));
    p.setPen(theme().colors.text);
    p.drawText(plot, Qt::AlignCenter, tr("Waiting for the first samples"));
    return;
  }
  if (o.form == SpectrogramForm::Waterfall) {
    drawWaterfall(p, plot);
    return;
  }
  drawHeat(p, plot);
  drawHoles(p, plot);
  const bool order = o.axis == FrequencyAxis::Order;
  const SpectrumColumn& newest = history_->columns().back();
  const double per = order && newest.spindle.value > 0 ? 1.0 / newest.spindle.value : 1.0;
  drawLeftAxis(p, plot, {o.low.value * per, o.high.value * per}, order ? tr("order") : QStringLiteral("Hz"), theme());
  drawMarks(p, plot);
}

void HistoryMap::drawHeat(QPainter& p, const QRect& plot) {
  const AnalyseOptions& o = view().options();
  HeatWindow window;
  window.size = plot.size();
  window.from = view().from();
  window.span = o.span;
  window.low = o.low;
  window.high = o.high;
  window.order = o.axis == FrequencyAxis::Order;
  window.linear = o.level == LevelScale::Linear;
  window.low_dB = range_.low();
  window.high_dB = range_.high();
  window.gap = theme().colors.gap.rgb();
  p.drawImage(plot.topLeft(), heat_.draw(*history_, window));
}

void HistoryMap::drawHoles(QPainter& p, const QRect& plot) const {
  const auto& columns = history_->columns();
  p.save();
  p.setClipRect(plot);
  for (auto c = columns.begin(); c != columns.end(); ++c) {
    if (!c->afterGap || c == columns.begin() || c->time < view().from()) continue;
    const double x = xOf((c - 1)->time), width = std::max(xOf(c->time) - x, 2.0);
    p.fillRect(QRectF(x, plot.top(), width, plot.height()), QBrush(theme().colors.hatch, Qt::BDiagPattern));
  }
  p.restore();
}

// Ticks of the newest tooth passing at the right edge, and the chatter frequency as it went.
void HistoryMap::drawMarks(QPainter& p, const QRect& plot) const {
  const auto& columns = history_->columns();
  const SpectrumColumn& newest = columns.back();
  p.save();
  p.setClipRect(plot.adjusted(0, 0, theme().px(10), 0));
  if (teeth_ > 0 && newest.spindle.value > 0) {
    p.setPen(QPen(theme().colors.text, theme().px(1.4)));
    const Hertz passing = newest.spindle * static_cast<double>(teeth_);
    for (int k = 1; passing * static_cast<double>(k) < view().options().high; ++k) {
      const double y = yOf(passing * static_cast<double>(k), plot);
      p.drawLine(QPointF(plot.right() + 2, y), QPointF(plot.right() + theme().px(8), y));
    }
  }
  p.setClipRect(plot);
  p.setRenderHint(QPainter::Antialiasing, false);
  const int dot = theme().px(2);
  int lastX = plot.left() - 1;
  for (const SpectrumColumn& c : columns) {
    if (!(c.chatter.value > 0) || c.time < view().from()) continue;
    const int x = static_cast<int>(xOf(c.time)), y = static_cast<int>(yOf(c.chatter, plot));
    if (x < lastX + 2 * dot) continue;
    lastX = x;
    p.fillRect(QRect(x, y - dot / 2, dot, dot), Qt::white);
  }
  if (const auto f = view().harmonic()) {
    p.setPen(QPen(theme().colors.onset, theme().px(1), Qt::DashLine));
    for (int k = 1; k <= 20 && *f * static_cast<double>(k) < view().options().high; ++k) {
      const double y = yOf(*f * static_cast<double>(k), plot);
      p.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    }
  }
  p.restore();
}

// Spectra one behind the other, the newest in front; the one under cursor A is the accent.
void HistoryMap::drawWaterfall(QPainter& p, const QRect& plot) const {
  const AnalyseOptions& o = view().options();
  const bool orders = o.axis == FrequencyAxis::Order;
  const Hertz newest = history_->columns().back().spindle;
  WaterfallScale scale{o.low, o.high, history_->spectrumTop().value / kSpectrumBins, 1.0};
  const double rise = plot.height() * 0.62, peak = plot.height() * 0.34;
  const SpectrumColumn* marked =
      view().cursor(AnalyseView::A) ? history_->columnAt(*view().cursor(AnalyseView::A)) : nullptr;
  p.save();
  p.setClipRect(plot);
  for (int k = 0; k < kMostWaterfallLines; ++k) {
    const double back = 1.0 - static_cast<double>(k) / (kMostWaterfallLines - 1);  // 1: oldest
    const Instant t = view().to() - toDuration(o.span * back);
    const SpectrumColumn* c = history_->columnAt(t);
    if (c == nullptr || std::abs(secondsBetween(c->time, t).value) > 0.6 * o.span.value / kMostWaterfallLines + 0.05)
      continue;
    const double base = plot.bottom() - 2 - rise * back;
    scale.stretch = waterfallStretch(orders, c->spindle, newest);
    QPolygonF line;
    line << QPointF(plot.left(), base);
    for (int b = scale.first(); b <= scale.last(); ++b) {
      const double x = plot.left() + std::clamp(scale.shareOf(b), 0.0, 1.0) * plot.width();
      line << QPointF(x, base - peak * placeOf(c->level_dB[static_cast<std::size_t>(b)]));
    }
    line << QPointF(plot.right() + 1, base);
    const bool accent = c == marked;
    const bool chatter = c->chatter.value > 0;
    p.setBrush(theme().colors.track);
    p.setPen(QPen(accent    ? theme().colors.advice
                  : chatter ? theme().colors.chatterText
                            : theme().colors.text,
                  accent ? 2.5 : 1.0));
    p.drawPolygon(line);
  }
  p.restore();
  const double per = orders && newest.value > 0 ? 1.0 / newest.value : 1.0;
  drawBottomAxis(p, plot, {o.low.value * per, o.high.value * per}, orders ? tr("order") : QStringLiteral("Hz"),
                 theme());
}

}  // namespace stillcut::ui
