#include "ui/plots/tap/tap_lobe_plot.h"

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>

#include "ui/base/format.h"
#include "ui/plots/axis_painter.h"

namespace stillcut::ui {
namespace {

constexpr double kAbove = 2.2;  // of the recommended depth is shown: what lies higher tells nothing of it

}  // namespace

TapLobePlot::TapLobePlot(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setAccessibleName(tr("Depth limits over speed"));
}

void TapLobePlot::display(const TapLobes& lobes, UnitSystem units) {
  if (lobes.version == shown_.version && units == units_) return;
  units_ = units;
  shown_ = lobes;
  top_ = std::clamp(kAbove * shown_.depth.value, 1e-4, std::max(1.05 * shown_.cut.deepest.value, 1e-4));
  update();
}

void TapLobePlot::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QPointF TapLobePlot::place(Rpm speed, Metres depth, const QRect& box) const {
  const double x = (speed - shown_.cut.lowest) / (shown_.cut.highest - shown_.cut.lowest);
  return {box.left() + x * box.width(), box.bottom() - std::min(depth.value / top_, 1.0) * box.height()};
}

void TapLobePlot::drawLimits(QPainter& p, const QRect& box) const {
  QPolygonF band;
  QPolygonF quiet;
  QPainterPath limit;
  for (const TapLimit& at : shown_.limits) {
    band << place(at.speed, at.high, box);
    quiet << place(at.speed, at.low, box);
    const QPointF to = place(at.speed, at.limit, box);
    limit.elementCount() > 0 ? limit.lineTo(to) : limit.moveTo(to);
  }
  for (auto at = shown_.limits.rbegin(); at != shown_.limits.rend(); ++at) band << place(at->speed, at->low, box);
  quiet << QPointF(quiet.back().x(), box.bottom()) << QPointF(quiet.front().x(), box.bottom());
  p.setPen(Qt::NoPen);
  QColor sure = theme_.colors.fill;
  sure.setAlphaF(0.35F);
  p.setBrush(sure);
  p.drawPolygon(quiet);
  p.setBrush(QBrush(theme_.colors.hatch, Qt::BDiagPattern));
  p.drawPolygon(band);
  p.setBrush(Qt::NoBrush);
  p.setPen(QPen(theme_.colors.text, theme_.px(1.8)));
  p.drawPath(limit);
  const QPointF best = place(shown_.speed, shown_.depth, box);
  p.setPen(QPen(theme_.colors.advice, theme_.px(1.5), Qt::DashLine));
  p.drawLine(QPointF(best.x(), box.bottom()), best);
  p.setPen(Qt::NoPen);
  p.setBrush(theme_.colors.advice);
  p.drawEllipse(best, theme_.px(7), theme_.px(7));
}

void TapLobePlot::drawTries(QPainter& p, const QRect& box) const {
  p.setPen(QPen(theme_.colors.advice, theme_.px(2)));
  for (const TapSpeed& at : shown_.toTry) {
    const double x = place(at.speed, {}, box).x();
    p.drawLine(QPointF(x, box.bottom()), QPointF(x, box.top() + box.height() / 4.0));
  }
}

void TapLobePlot::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setFont(theme_.font(type_size::kBody));
  p.setPen(theme_.colors.secondary);
  if (shown_.limits.empty() && shown_.toTry.empty()) {
    p.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
               shown_.state == TapLobes::State::Working ? tr("Computing") : tr("Here the limits of the depth appear."));
    return;
  }
  const int left = theme_.px(70), gap = theme_.px(12), title = theme_.px(22), bottom = theme_.px(30);
  const QRect box(left, title, width() - left - gap, height() - title - bottom);
  p.setFont(theme_.font(type_size::kTick));
  p.drawText(QRect(left, 0, box.width(), title), Qt::AlignLeft | Qt::AlignVCenter,
             shown_.limits.empty() ? tr("Speeds to try; their depth is not known")
                                   : tr("Depth limit, hatched its uncertainty, blue what is recommended"));
  p.fillRect(box, theme_.colors.track);
  p.setClipRect(box.adjusted(-1, -1, 1, 1));
  shown_.limits.empty() ? drawTries(p, box) : drawLimits(p, box);
  p.setClipping(false);
  if (!shown_.limits.empty()) {
    drawLeftAxis(p, box, {0.0, lengthIn(Metres(top_), units_)}, lengthUnit(units_), theme_);
  }
  drawBottomAxis(p, box, {shown_.cut.lowest.value, shown_.cut.highest.value}, rpmUnit(), theme_);
}

}  // namespace stillcut::ui
