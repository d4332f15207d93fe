#include "ui/plots/spectrogram/waterfall_stack.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/format.h"
#include "ui/plots/nice_ticks.h"
#include "ui/plots/spectrogram/waterfall.h"

namespace stillcut::ui {
namespace {

constexpr double kSteps = 35.0;  // spectra on show, more or less
constexpr double kRise = 0.62;   // of the height, from the newest foot to the oldest
constexpr double kPeak = 0.34;   // of the height, for the highest level

WaterfallScale scaleOf(const RunHistory& history, const AnalyseView& view, const SpectrumColumn& column, Hertz newest) {
  const AnalyseOptions& o = view.options();
  return {o.low, o.high, history.spectrumTop().value / kSpectrumBins,
          waterfallStretch(o.axis == FrequencyAxis::Order, column.spindle, newest)};
}

}  // namespace

WaterfallStack::WaterfallStack(const RunHistory& history, const AnalyseView& view, const QRect& plot, LevelPlace place)
    : history_(history), view_(view), plot_(plot), place_(std::move(place)), newest_(history.columns().back().spindle) {
  gather();
}

// One column for each step of a grid fixed in time, what the cursors are on, and the newest in sight.
void WaterfallStack::gather() {
  const auto take = [this](Instant t) -> Line* {
    const SpectrumColumn* column = history_.columnAt(t);
    if (column == nullptr || column->time < view_.from() || column->time > view_.to()) return nullptr;
    const auto at = std::lower_bound(lines_.begin(), lines_.end(), column->time,
                                     [](const Line& line, Instant time) { return line.column->time < time; });
    if (at != lines_.end() && at->column == column) return &*at;
    return &*lines_.insert(at, Line{column});
  };
  const double step = view_.options().span.value / kSteps;
  const double first = std::ceil(sinceEpoch(view_.from()).value / step);
  for (int k = 0; k <= static_cast<int>(kSteps); ++k) take(Instant() + toDuration(Seconds((first + k) * step)));
  take(view_.to());
  if (const auto t = view_.cursor(AnalyseView::A); t && *t >= view_.from() && *t <= view_.to()) {
    if (Line* line = take(*t)) line->a = true;
  }
  if (const auto t = view_.cursor(AnalyseView::B); t && *t >= view_.from() && *t <= view_.to()) {
    if (Line* line = take(*t)) line->b = true;
  }
}

double WaterfallStack::footOf(Instant t) const {
  return plot_.bottom() - 2 - plot_.height() * kRise * (secondsBetween(t, view_.to()) / view_.options().span);
}

Instant WaterfallStack::timeAt(double foot) const {
  const double back = (plot_.bottom() - 2 - foot) / std::max(plot_.height() * kRise, 1.0);
  return view_.to() - toDuration(view_.options().span * back);
}

Seconds WaterfallStack::moveBy(double share) const {
  return view_.options().span * (-share / kRise);
}

double WaterfallStack::xOf(Hertz f, const SpectrumColumn& column) const {
  const WaterfallScale scale = scaleOf(history_, view_, column, newest_);
  return plot_.left() + scale.shareOf(f.value / scale.binWidth) * plot_.width();
}

double WaterfallStack::crestAt(const SpectrumColumn& column, double x) const {
  const WaterfallScale scale = scaleOf(history_, view_, column, newest_);
  const double share = (x - plot_.left()) / std::max(plot_.width(), 1);
  const double bin = (scale.low.value + share * (scale.high - scale.low).value) / (scale.binWidth * scale.stretch);
  const auto nearest = static_cast<std::size_t>(std::clamp(std::lround(bin), 0L, kSpectrumBins - 1L));
  return footOf(column.time) - plot_.height() * kPeak * place_(column.level_dB[nearest]);
}

const SpectrumColumn& WaterfallStack::under(const QPointF& at) const {
  constexpr double kTouch = 3.0;  // px beside a line that still count as on it
  for (auto line = lines_.rbegin(); line != lines_.rend(); ++line) {
    if (at.y() >= crestAt(*line->column, at.x()) - kTouch) return *line->column;
  }
  return lines_.empty() ? history_.columns().back() : *lines_.front().column;
}

QPolygonF WaterfallStack::outline(const SpectrumColumn& column) const {
  const WaterfallScale scale = scaleOf(history_, view_, column, newest_);
  const double foot = footOf(column.time);
  QPolygonF out;
  out << QPointF(plot_.left(), foot);
  for (int b = scale.first(); b <= scale.last(); ++b) {
    const double x = plot_.left() + std::clamp(scale.shareOf(b), 0.0, 1.0) * plot_.width();
    out << QPointF(x, foot - plot_.height() * kPeak * place_(column.level_dB[static_cast<std::size_t>(b)]));
  }
  out << QPointF(plot_.right() + 1, foot);
  return out;
}

void WaterfallStack::draw(QPainter& p, const Theme& theme) const {
  p.save();
  p.setClipRect(plot_);
  Instant drawn = view_.from();
  for (const Line& line : lines_) {
    drawGaps(p, theme, drawn, line.column->time);
    drawLine(p, theme, line);
    drawn = line.column->time;
  }
  p.restore();
  for (const Line& line : lines_) {
    if (line.a || line.b) drawFlag(p, theme, line);
  }
  drawTimes(p, theme);
}

void WaterfallStack::drawLine(QPainter& p, const Theme& theme, const Line& line) const {
  const bool chatter = line.column->chatter.value > 0;
  p.setBrush(theme.colors.track);
  p.setPen(QPen(line.a    ? theme.colors.advice
                : chatter ? theme.colors.chatterText
                          : theme.colors.text,
                line.a || line.b ? theme.px(2.5) : 1.0, line.b && !line.a ? Qt::DashLine : Qt::SolidLine));
  p.drawPolygon(outline(*line.column));
  if (!chatter) return;
  const double x = xOf(line.column->chatter, *line.column), dot = theme.px(2);
  p.setPen(Qt::NoPen);
  p.setBrush(theme.colors.chatterText);
  p.drawEllipse(QPointF(x, crestAt(*line.column, x)), dot, dot);
}

void WaterfallStack::drawGaps(QPainter& p, const Theme& theme, Instant after, Instant until) const {
  const auto& columns = history_.columns();
  auto c = std::upper_bound(columns.begin(), columns.end(), after,
                            [](Instant t, const SpectrumColumn& column) { return t < column.time; });
  for (; c != columns.end() && c->time <= until; ++c) {
    if (!c->afterGap || c == columns.begin()) continue;
    const bool whole = c->number == (c - 1)->number + 1;  // the screen has missed no column besides
    const double low = footOf(c->time), high = whole ? std::min(footOf((c - 1)->time), low - 2.0) : low - 2.0;
    p.fillRect(QRectF(plot_.left(), high, plot_.width(), low - high), theme.colors.gap);
    p.fillRect(QRectF(plot_.left(), high, plot_.width(), low - high), QBrush(theme.colors.hatch, Qt::BDiagPattern));
  }
}

// At the right end of the foot; with its letter, so that colour does not speak alone.
void WaterfallStack::drawFlag(QPainter& p, const Theme& theme, const Line& line) const {
  const QString letters = line.a && line.b ? QStringLiteral("A B") : line.a ? QStringLiteral("A") : QStringLiteral("B");
  p.setFont(theme.font(type_size::kTick, true));
  const double wide = p.fontMetrics().horizontalAdvance(letters) + theme.px(8);
  const QRectF flag(plot_.right() + 2, footOf(line.column->time) - theme.px(8), wide, theme.px(16));
  p.fillRect(flag, line.a ? theme.colors.advice : theme.colors.text);
  p.setPen(theme.colors.panel);
  p.drawText(flag, Qt::AlignCenter, letters);
}

// Seconds before the newest spectrum on show, along the feet.
void WaterfallStack::drawTimes(QPainter& p, const Theme& theme) const {
  const double span = view_.options().span.value;
  p.setFont(theme.font(type_size::kTick));
  p.setPen(theme.colors.secondary);
  const QFontMetrics metrics = p.fontMetrics();
  const std::vector<double> ticks =
      niceTicks(0.0, span, std::max(static_cast<int>(plot_.height() * kRise) / theme.px(30), 2));
  const int decimals = ticks.size() > 1 ? decimalsFor(ticks[1] - ticks[0]) : 0;
  for (const double back : ticks) {
    const double y = footOf(view_.to() - toDuration(Seconds(back)));
    p.drawLine(QPointF(plot_.left() - theme.px(5), y), QPointF(plot_.left() - 1, y));
    const QString text = join(number(0.0 - back, decimals), QStringLiteral("s"));
    p.drawText(QPointF(plot_.left() - theme.px(9) - metrics.horizontalAdvance(text), y + metrics.capHeight() / 2.0),
               text);
  }
}

}  // namespace stillcut::ui
