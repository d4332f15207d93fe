#include "ui/plots/membership_plot.h"

#include <QPainter>
#include <algorithm>

#include "ui/base/format.h"

namespace stillcut::ui {

MembershipPlot::MembershipPlot(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setAccessibleName(tr("Fuzzy sets"));
  setToolTip(tr("How far an error belongs to each set"));
}

void MembershipPlot::display(const std::array<double, 3>& centres) {
  if (centres == centres_) return;
  centres_ = centres;
  setAccessibleDescription(
      tr("Peaks at %1, %2, %3 of the range").arg(number(centres[0], 2), number(centres[1], 2), number(centres[2], 2)));
  update();
}

std::array<double, 9> MembershipPlot::peaks() const {
  const auto& [small, medium, big] = centres_;
  return {-1.0, -big, -medium, -small, 0.0, small, medium, big, 1.0};
}

void MembershipPlot::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

void MembershipPlot::paintEvent(QPaintEvent*) {
  static const std::array<const char*, 9> kNames{"NX", "NB", "NM", "NS", "ZE", "PS", "PM", "PB", "PX"};
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const double side = theme_.px(18), top = theme_.px(20);
  const QRectF box = QRectF(rect()).adjusted(side, top, -side, -theme_.px(4));
  const auto at = [&box](double x) { return box.left() + (x + 1.0) * 0.5 * box.width(); };
  const auto peak = peaks();
  p.setFont(theme_.font(type_size::kTick));
  p.setPen(QPen(theme_.colors.border, 1.0));
  p.drawLine(box.bottomLeft(), box.bottomRight());
  for (std::size_t k = 0; k < peak.size(); ++k) {
    const double left = peak[k > 0 ? k - 1 : 0], right = peak[std::min(k + 1, peak.size() - 1)];
    p.setPen(QPen(k == peak.size() / 2 ? theme_.colors.text : theme_.colors.secondary, theme_.px(1.5)));
    p.drawLine(QPointF(at(left), box.bottom()), QPointF(at(peak[k]), box.top()));
    p.drawLine(QPointF(at(peak[k]), box.top()), QPointF(at(right), box.bottom()));
    p.drawText(QRectF(at(peak[k]) - side, 0, 2 * side, top), Qt::AlignCenter, QLatin1String(kNames[k]));
  }
}

}  // namespace stillcut::ui
