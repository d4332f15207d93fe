#include "ui/plots/lobe_marks.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "ui/base/format.h"

namespace stillcut::ui {
namespace {

// Of what stands around the working point, before scaling: each leaves the one inside it in sight.
constexpr double kArmFrom = 8.0, kArmTo = 15.0, kRing = 20.0;

}  // namespace

QPolygonF cornered(const QPointF& centre, double radius, int corners) {
  QPolygonF out;
  const double turn = corners == 3 ? 0.0 : kTwoPi / (2.0 * corners);
  for (int k = 0; k < corners; ++k) {
    const double angle = kTwoPi * k / corners + turn;
    out << centre + QPointF(radius * std::sin(angle), -radius * std::cos(angle));
  }
  return out;
}

// Four arms around the place: what was met there stays in sight between them, and all of it inside the ring.
void LobeMarks::cross(const QPointF& at) const {
  p_.setPen(QPen(theme_.colors.text, theme_.px(3), Qt::SolidLine, Qt::FlatCap));
  const double from = theme_.px(kArmFrom), to = theme_.px(kArmTo);
  for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
    p_.drawLine(at + way * from, at + way * to);
}

void LobeMarks::ring(const QPointF& at) const {
  const double radius = theme_.px(kRing);
  p_.setBrush(Qt::NoBrush);
  p_.setPen(QPen(theme_.colors.panel, theme_.px(6)));
  p_.drawEllipse(at, radius, radius);
  p_.setPen(QPen(theme_.colors.text, theme_.px(3)));
  p_.drawEllipse(at, radius, radius);
}

// Above what it starts from and with a stem down to where it leads; however short the move, the arrow is not.
void LobeMarks::advice(const QPointF& at, double target, Rpm speed) const {
  if (std::abs(target - at.x()) < theme_.px(3)) return;  // it is there
  const double lift = theme_.px(kRing + 14), head = theme_.px(14);
  const double y = at.y() - lift > plot_.top() + theme_.px(24) ? at.y() - lift : at.y() + lift;
  const double back = target < at.x() ? 1.0 : -1.0;
  const double length = std::max(std::abs(target - at.x()), 3.0 * head);
  const QPointF tip(target, y);
  p_.setPen(QPen(theme_.colors.advice, theme_.px(1.5), Qt::DashLine));
  p_.drawLine(tip, QPointF(target, at.y()));
  p_.setPen(QPen(theme_.colors.advice, theme_.px(4), Qt::SolidLine, Qt::FlatCap));
  p_.drawLine(tip + QPointF(back * length, 0), tip + QPointF(back * head * 0.8, 0));
  p_.setPen(Qt::NoPen);
  p_.setBrush(theme_.colors.advice);
  p_.drawPolygon(QPolygonF{tip, tip + QPointF(back * head, -head * 0.6), tip + QPointF(back * head, head * 0.6)});
  p_.setFont(theme_.font(type_size::kLabel, true));
  p_.setPen(theme_.colors.advice);
  const QString text = join(number(speed.value), rpmUnit());
  const double wide = p_.fontMetrics().horizontalAdvance(text);
  const double left = std::clamp(target - wide / 2.0, plot_.left() + 2.0, plot_.right() - wide - 2.0);
  p_.drawText(QPointF(left, y + (y < at.y() ? -theme_.px(12) : theme_.px(12) + p_.fontMetrics().ascent())), text);
}

// Every sign with its word, in one row above the plot.
// Longer than a screen: one row a sign, each drawn as it stands in the plot
bool LobeMarks::legend() const {
  const ThemeColors& c = theme_.colors;
  struct Entry {
    QString text;
    std::function<void(const QPointF&)> draw;
  };
  const double r = theme_.px(6);
  const auto solid = [&](int corners, const QColor& color) {
    return [this, r, corners, color](const QPointF& at) {
      p_.setPen(Qt::NoPen);
      p_.setBrush(color);
      p_.drawPolygon(cornered(at, r, corners));
    };
  };
  const auto circle = [&](double radius, double pen) {
    return [this, radius, pen](const QPointF& at) {
      p_.setPen(QPen(theme_.colors.text, theme_.px(pen)));
      p_.setBrush(Qt::NoBrush);
      p_.drawEllipse(at, radius, radius);
    };
  };
  const std::array<Entry, 6> entries{
      {{tr("now"),
        [&](const QPointF& at) {
          p_.setPen(QPen(c.text, theme_.px(3), Qt::SolidLine, Qt::FlatCap));
          p_.drawLine(at - QPointF(r, 0), at + QPointF(r, 0));
          p_.drawLine(at - QPointF(0, r), at + QPointF(0, r));
        }},
       {tr("advised"),
        [&](const QPointF& at) {
          p_.setPen(QPen(c.advice, theme_.px(3), Qt::SolidLine, Qt::FlatCap));
          p_.drawLine(at - QPointF(r, 0), at);
          p_.setPen(Qt::NoPen);
          p_.setBrush(c.advice);
          p_.drawPolygon(QPolygonF{at + QPointF(r, 0), at + QPointF(-1, -r), at + QPointF(-1, r)});
        }},
       {tr("what if"), circle(r, 2.5)},
       {tr("was stable"), circle(theme_.px(4.5), 1.5)},
       {tr("onset"), solid(3, theme_.back(Tone::Onset))},
       {tr("chatter"), solid(8, theme_.back(Tone::Chatter))}}};
  const double sign = 2.0 * r + theme_.px(5), apart = theme_.px(14);
  double needed = 0.0;
  QFont font = theme_.font(type_size::kTick);
  for (int halves = static_cast<int>(2.0 * type_size::kTick); halves >= 18; --halves) {
    font = theme_.font(0.5 * halves);
    needed = -apart;
    for (const Entry& entry : entries) needed += sign + QFontMetricsF(font).horizontalAdvance(entry.text) + apart;
    if (needed <= plot_.width()) break;
  }
  const bool fits = needed <= plot_.width();
  double x = plot_.left();
  const double y = plot_.top() - theme_.px(kLobeLegend) / 2.0;
  p_.setFont(font);
  const QFontMetricsF metrics(font);
  for (const Entry& entry : entries) {
    entry.draw({x + r, y});
    p_.setPen(c.secondary);
    p_.drawText(QPointF(x + sign, y + metrics.capHeight() / 2.0), entry.text);
    x += sign + metrics.horizontalAdvance(entry.text) + apart;
  }
  return fits;
}

}  // namespace stillcut::ui
