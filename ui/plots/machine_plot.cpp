#include "ui/plots/machine_plot.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/base/format.h"

namespace stillcut::ui {

struct MachinePlot::Row {
  QString name;
  double (*thick)(const MachinePoint&);
  double (*thin)(const MachinePoint&);  // null: none
  QString (*text)(double, UnitSystem);
};

namespace {

constexpr Seconds kStands{1.5};

QString rpmText(double value, UnitSystem) {
  return number(value);
}
QString feedOf(double value, UnitSystem units) {
  return number(feedIn(MetresPerSecond(value), units));
}
QString ratioText(double value, UnitSystem) {
  return number(100.0 * value);
}

}  // namespace

MachinePlot::MachinePlot(AnalyseView& view, QWidget* parent) : TimePlot(view, tr("MACHINE"), parent) {
  setLegend(tr("thick: what it did; thin: programmed; overrides: thick speed, thin feed"));
  setToolTip(tr("Speed, feed and overrides as they were read back"));
}

void MachinePlot::display(const std::deque<MachinePoint>* points, Instant known, UnitSystem units) {
  points_ = points;
  known_ = known;
  units_ = units;
  update();
}

QSize MachinePlot::minimumSizeHint() const {
  return {theme().px(420), theme().px(90)};
}

void MachinePlot::drawPlot(QPainter& p, const QRect& plot) {
  if (points_ == nullptr || points_->empty()) {
    p.setFont(theme().font(type_size::kBody));
    p.setPen(theme().colors.text);
    p.drawText(plot, Qt::AlignCenter, tr("Nothing was read from a machine"));
    return;
  }
  const std::array<Row, 3> rows{
      {{rpmUnit(), [](const MachinePoint& m) { return m.actual.value; },
        [](const MachinePoint& m) { return m.programmed.value; }, &rpmText},
       {feedUnit(units_), [](const MachinePoint& m) { return m.feed.value; }, nullptr, &feedOf},
       {QStringLiteral("%"), [](const MachinePoint& m) { return m.speedOverride.value; },
        [](const MachinePoint& m) { return m.feedOverride.value; }, &ratioText}}};
  const double high = plot.height() / static_cast<double>(rows.size()), gap = theme().px(4);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    drawRow(p, QRectF(plot.left(), plot.top() + high * static_cast<double>(k) + gap / 2, plot.width(), high - gap),
            rows[k]);
  }
}

// From zero up: a small move looks small, a large one large.
void MachinePlot::drawRow(QPainter& p, const QRectF& box, const Row& row) const {
  const auto later = [](const MachinePoint& m, Instant t) { return m.time < t; };
  auto first = std::lower_bound(points_->begin(), points_->end(), view().from(), later);
  if (first != points_->begin()) --first;
  auto last = std::lower_bound(points_->begin(), points_->end(), view().to(), later);
  if (last != points_->end()) ++last;
  double most = 0.0;
  for (auto it = first; it != last; ++it) {
    most = std::max({most, row.thick(*it), row.thin != nullptr ? row.thin(*it) : 0.0});
  }
  const double full = most > 0.0 && std::isfinite(most) ? 1.1 * most : 1.0;
  const auto curve = [&](double (*of)(const MachinePoint&)) {
    QPolygonF line;
    for (auto it = first; it != last; ++it) {
      const double x = xOf(it->time), y = box.bottom() - box.height() * std::clamp(of(*it) / full, 0.0, 1.0);
      if (!line.isEmpty() && x < line.last().x() + 1.0) continue;
      if (!line.isEmpty()) line << QPointF(x, line.last().y());  // it stood until then
      line << QPointF(x, y);
    }
    // Read back once a second while nothing changes: what is older is not known any more.
    const bool stands =
        last == points_->end() && !line.isEmpty() && secondsBetween(points_->back().time, known_) < kStands;
    if (stands) line << QPointF(xOf(known_), line.last().y());
    return line;
  };
  p.save();
  p.setClipRect(box);
  p.fillRect(box, theme().colors.panel);
  if (row.thin != nullptr) {
    p.setPen(QPen(theme().colors.secondary, 1.0, Qt::DashLine));
    p.drawPolyline(curve(row.thin));
  }
  p.setPen(QPen(theme().colors.text, theme().px(2)));
  p.drawPolyline(curve(row.thick));
  p.restore();
  p.setFont(theme().font(type_size::kTick));
  p.setPen(theme().colors.secondary);
  const double room = theme().px(68);
  p.drawText(QRectF(box.left() - room - theme().px(4), box.top(), room, box.height()),
             Qt::AlignRight | Qt::AlignVCenter, row.name);
  p.drawText(QRectF(box.right() + theme().px(6), box.top(), theme().px(60), box.height()), Qt::AlignLeft | Qt::AlignTop,
             row.text(full, units_));
  for (const AnalyseView::Cursor c : {AnalyseView::A, AnalyseView::B}) {
    const auto t = view().cursor(c);
    if (!t || *t < view().from() || *t > view().to()) continue;
    auto at = std::upper_bound(points_->begin(), points_->end(), *t,
                               [](Instant time, const MachinePoint& m) { return time < m.time; });
    if (at == points_->begin()) continue;
    drawReading(p, box, *t, row.text(row.thick(*(at - 1)), units_));
  }
}

}  // namespace stillcut::ui
