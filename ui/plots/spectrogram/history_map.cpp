#include "ui/plots/spectrogram/history_map.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/models/history/spectrum_view.h"
#include "ui/plots/axis_painter.h"
#include "ui/plots/spectrogram/level_key.h"
#include "ui/plots/spectrogram/waterfall.h"

namespace stillcut::ui {
HistoryMap::HistoryMap(AnalyseView& view, QWidget* parent) : TimePlot(view, tr("SPECTROGRAM"), parent) {
  setToolTip(tr("Drag: move. Wheel: zoom. Ctrl and drag: zoom to a stretch. Click: cursor A, with Shift B."));
}

void HistoryMap::display(const RunHistory* history, int teeth, const QString& unit) {
  history_ = history;
  teeth_ = teeth;
  unit_ = unit;
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

bool HistoryMap::waterfall() const {
  return view().options().form == SpectrogramForm::Waterfall;
}

WaterfallStack HistoryMap::stack() const {
  return {*history_, view(), plotRect(), [this](float level_dB) { return placeOf(level_dB); }};
}

Hertz HistoryMap::frequencyAt(double share) const {
  const AnalyseOptions& o = view().options();
  return std::max(o.low + (o.high - o.low) * share, Hertz());
}

double HistoryMap::shareAcross(double x) const {
  const QRect plot = plotRect();
  return (x - plot.left()) / std::max(plot.width(), 1);
}

// In the waterfall, of the newest spectrum.
double HistoryMap::xOfFrequency(Hertz f, const QRect& plot) const {
  const AnalyseOptions& o = view().options();
  return plot.left() + (f - o.low) / (o.high - o.low) * plot.width();
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

// In the waterfall frequency lies along the lower axis and time up the stack.
void HistoryMap::panRight(double share) {
  if (!waterfall()) return TimePlot::panRight(share);
  const AnalyseOptions& o = view().options();
  view().panFrequency((o.high - o.low) * -share);
}

void HistoryMap::zoomRight(double factor, double x) {
  if (!waterfall()) return TimePlot::zoomRight(factor, x);
  view().zoomFrequency(factor, frequencyAt(shareAcross(x)));
}

void HistoryMap::showBetween(double left, double right) {
  if (!waterfall()) return TimePlot::showBetween(left, right);
  view().showFrequencies(frequencyAt(shareAcross(left)), frequencyAt(shareAcross(right)));
}

void HistoryMap::panUp(double share) {
  const AnalyseOptions& o = view().options();
  if (!waterfall()) return view().panFrequency((o.high - o.low) * share);
  if (shown()) view().pan(stack().moveBy(share));
}

void HistoryMap::zoomUp(double factor, double y) {
  const QRect plot = plotRect();
  if (!waterfall()) {
    return view().zoomFrequency(factor, frequencyAt((plot.bottom() + 1 - y) / std::max(plot.height(), 1)));
  }
  if (shown()) view().zoomTime(factor, stack().timeAt(y));
}

void HistoryMap::clicked(const QPointF& at, Qt::KeyboardModifiers modifiers) {
  if (!waterfall()) return TimePlot::clicked(at, modifiers);
  if (!shown()) return;
  view().setCursor(modifiers & Qt::ShiftModifier ? AnalyseView::B : AnalyseView::A, stack().under(at).time);
}

// The stack draws its own: a cursor is a spectrum in it.
void HistoryMap::drawCursors(QPainter& p, const QRect& plot) const {
  if (!waterfall()) TimePlot::drawCursors(p, plot);
}

void HistoryMap::drawPlot(QPainter& p, const QRect& plot) {
  const AnalyseOptions& o = view().options();
  if (!shown()) {
    p.setFont(theme().font(type_size::kValue));
    p.setPen(theme().colors.text);
    p.drawText(plot, Qt::AlignCenter, tr("Waiting for the first samples"));
    return;
  }
  const bool order = o.axis == FrequencyAxis::Order;
  const SpectrumColumn& newest = history_->columns().back();
  const double per = order && newest.spindle.value > 0 ? 1.0 / newest.spindle.value : 1.0;
  const AxisRange range{o.low.value * per, o.high.value * per};
  const QString unit = order ? tr("order") : QStringLiteral("Hz");
  if (waterfall()) {
    stack().draw(p, theme());
    drawBottomAxis(p, plot, range, unit, theme());
  } else {
    drawHeat(p, plot);
    drawHoles(p, plot);
    drawLeftAxis(p, plot, range, unit, theme());
    drawChatter(p, plot);
  }
  drawTeeth(p, plot);
  drawHarmonics(p, plot);
  drawKey(p, plot);
}

void HistoryMap::drawKey(QPainter& p, const QRect& plot) const {
  const QRect row(plot.left(), 0, plot.width(), plot.top());
  const LevelKeyKind kind = waterfall() ? LevelKeyKind::Ramp : LevelKeyKind::Colors;
  if (view().options().level == LevelScale::Linear) {
    drawLevelKey(p, row, kind, number(0), join(significant(amplitudeOf(range_.high())), rmsUnit(unit_)), theme());
  } else {
    drawLevelKey(p, row, kind, number(range_.low()), join(number(range_.high()), decibelUnit(unit_)), theme());
  }
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
    // Where the screen has missed columns as well, nobody knows how much of it was lost: a mark, no stretch.
    const bool whole = c->number == (c - 1)->number + 1;
    const double x = whole ? xOf((c - 1)->time) : xOf(c->time) - 2.0, width = std::max(xOf(c->time) - x, 2.0);
    p.fillRect(QRectF(x, plot.top(), width, plot.height()), QBrush(theme().colors.hatch, Qt::BDiagPattern));
  }
  p.restore();
}

// Of the newest spectrum, as thin ticks outside the plot, at the end of the frequency axis that it is at.
void HistoryMap::drawTeeth(QPainter& p, const QRect& plot) const {
  const Hertz passing = history_->columns().back().spindle * static_cast<double>(teeth_);
  if (!(passing.value > 0.0)) return;
  p.setPen(QPen(theme().colors.text, theme().px(1.4)));
  for (int k = 1; passing * static_cast<double>(k) < view().options().high; ++k) {
    const Hertz f = passing * static_cast<double>(k);
    if (f < view().options().low) continue;
    if (waterfall()) {
      p.drawLine(QPointF(xOfFrequency(f, plot), plot.top() - theme().px(6)),
                 QPointF(xOfFrequency(f, plot), plot.top()));
    } else {
      p.drawLine(QPointF(plot.right() + 2, yOf(f, plot)), QPointF(plot.right() + theme().px(8), yOf(f, plot)));
    }
  }
}

// As it went; on the order axis each mark is stretched as its column is.
void HistoryMap::drawChatter(QPainter& p, const QRect& plot) const {
  const auto& columns = history_->columns();
  const bool order = view().options().axis == FrequencyAxis::Order;
  p.save();
  p.setClipRect(plot);
  p.setRenderHint(QPainter::Antialiasing, false);
  const int dot = theme().px(2);
  int lastX = plot.left() - 1;
  for (const SpectrumColumn& c : columns) {
    if (!(c.chatter.value > 0) || c.time < view().from()) continue;
    const Hertz shown = c.chatter * waterfallStretch(order, c.spindle, columns.back().spindle);
    const int x = static_cast<int>(xOf(c.time)), y = static_cast<int>(yOf(shown, plot));
    if (x < lastX + 2 * dot) continue;
    lastX = x;
    p.fillRect(QRect(x, y - dot / 2, dot, dot), Qt::white);
  }
  p.restore();
}

void HistoryMap::drawHarmonics(QPainter& p, const QRect& plot) const {
  const auto harmonic = view().harmonic();
  if (!harmonic || !(harmonic->value > 0.0)) return;
  p.setPen(QPen(theme().colors.onset, theme().px(1), Qt::DashLine));
  for (int k = 1; k <= 20 && *harmonic * static_cast<double>(k) < view().options().high; ++k) {
    const Hertz f = *harmonic * static_cast<double>(k);
    if (f < view().options().low) continue;
    if (waterfall()) {
      p.drawLine(QPointF(xOfFrequency(f, plot), plot.top()), QPointF(xOfFrequency(f, plot), plot.bottom()));
    } else {
      p.drawLine(QPointF(plot.left(), yOf(f, plot)), QPointF(plot.right(), yOf(f, plot)));
    }
  }
}

}  // namespace stillcut::ui
