#include "ui/widgets/verdict_sign.h"

#include <QAccessible>
#include <QFontMetricsF>
#include <QPainter>
#include <cmath>
#include <numbers>

#include "ui/widgets/painting.h"

namespace stillcut::ui {
namespace {

constexpr double kPad = 24;
constexpr double kShape = 82;

QPolygonF regularPolygon(const QRectF& box, int corners, double firstAngle) {
  QPolygonF polygon;
  for (int k = 0; k < corners; ++k) {
    const double a = firstAngle + 2.0 * std::numbers::pi * k / corners;
    polygon << box.center() + QPointF(std::cos(a), std::sin(a)) * (box.width() / 2.0);
  }
  return polygon;
}

void drawExclamation(QPainter& p, const QPointF& centre, double height, const QColor& color) {
  p.setPen(Qt::NoPen);
  p.setBrush(color);
  const double w = height * 0.2;
  p.drawRoundedRect(QRectF(centre.x() - w / 2, centre.y() - height / 2, w, height * 0.64), w * 0.3, w * 0.3);
  p.drawRoundedRect(QRectF(centre.x() - w / 2, centre.y() + height / 2 - w, w, w), w * 0.3, w * 0.3);
}

}  // namespace

VerdictSign::VerdictSign(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setAccessibleName(tr("Verdict"));
}

void VerdictSign::display(const VerdictView& view) {
  if (view == view_) return;
  const bool newWord = view.word != view_.word;
  view_ = view;
  setAccessibleDescription(view.spoken());
  if (newWord) {
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
  }
  update();
}

void VerdictSign::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QSize VerdictSign::minimumSizeHint() const {
  return {theme_.px(540), theme_.px(252)};
}

void VerdictSign::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  drawPanel(p, rect(), theme_, theme_.back(view_.tone));
  TextPainter text(p, theme_);
  const QColor front = theme_.front(view_.tone);
  const bool alarm = view_.tone == Tone::Onset || view_.tone == Tone::Chatter;
  const QColor second = alarm ? front : theme_.colors.secondary;

  // Rows by the height of their capitals: word, frequency, detail, marked; the block sits in the middle of the panel.
  const double shape = theme_.px(kShape), pad = theme_.px(kPad);
  const bool hasFrequency = !view_.frequency.isEmpty();
  const double freq = hasFrequency ? capHeight(theme_, type_size::kFrequency, true) + theme_.px(28) : 0.0;
  const double value = capHeight(theme_, type_size::kValue, false);
  // A sentence without a frequency above it may take two lines.
  const QFontMetricsF valueMetrics(theme_.font(type_size::kValue));
  const double room = width() - 2.0 * pad;
  const bool twoLines = !hasFrequency && valueMetrics.horizontalAdvance(view_.detail) > room;
  const double detail = twoLines ? 2.0 * valueMetrics.lineSpacing() : value;
  const double lines = detail + theme_.px(26) + value + theme_.px(20);
  double y = std::max(pad, (height() - shape - freq - lines) / 2.0);

  drawShape(p, QRectF(pad, y, shape, shape));
  const double wordLeft = pad + shape + theme_.px(20);
  text.centred(
      QRectF(wordLeft, y, width() - pad - wordLeft, shape), view_.word,
      {type_size::kVerdict, true, view_.tone == Tone::Faint ? theme_.colors.secondary : front, Qt::AlignLeft, 0.65});
  y += shape;
  if (hasFrequency)
    y = text.line(pad, y + theme_.px(28), room, view_.frequency,
                  {type_size::kFrequency, true, front, Qt::AlignLeft, 0.8});
  const TextStyle detailStyle{type_size::kValue, false, alarm ? front : theme_.colors.text, Qt::AlignLeft, 0.7};
  y += theme_.px(twoLines ? 14 : 26);
  if (twoLines) {
    text.block(QRectF(pad, y, room, detail), view_.detail, detailStyle);
    y += detail;
  } else {
    y = text.line(pad, y, room, view_.detail, detailStyle);
  }
  text.line(pad, y + theme_.px(20), room, view_.marked, {type_size::kValue, false, second, Qt::AlignLeft, 0.7});
  clipped_ = text.clipped();
}

void VerdictSign::drawShape(QPainter& p, const QRectF& box) const {
  const QColor front = theme_.front(view_.tone), back = theme_.back(view_.tone);
  const double stroke = box.width() * 0.1;
  const QRectF inset = box.adjusted(stroke / 2, stroke / 2, -stroke / 2, -stroke / 2);
  p.save();
  switch (view_.shape) {
    case Shape::Ring:
      p.setBrush(Qt::NoBrush);
      p.setPen(QPen(theme_.colors.faint, stroke * 0.7, Qt::CustomDashLine, Qt::FlatCap));
      {
        QPen pen = p.pen();
        pen.setDashPattern({2.2, 1.6});
        p.setPen(pen);
      }
      p.drawEllipse(inset);
      break;
    case Shape::Circle:
      p.setBrush(Qt::NoBrush);
      p.setPen(QPen(theme_.colors.fill, stroke));
      p.drawEllipse(inset);
      break;
    case Shape::Triangle: {
      p.setPen(QPen(front, stroke * 0.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      p.setBrush(front);
      const double h = inset.height() * 0.08;
      p.drawPolygon(QPolygonF() << QPointF(box.center().x(), inset.top()) << QPointF(inset.right(), inset.bottom() - h)
                                << QPointF(inset.left(), inset.bottom() - h));
      drawExclamation(p, box.center() + QPointF(0, box.height() * 0.14), box.height() * 0.46, back);
      break;
    }
    case Shape::Octagon:
      p.setPen(Qt::NoPen);
      p.setBrush(front);
      p.drawPolygon(regularPolygon(box, 8, std::numbers::pi / 8.0));
      drawExclamation(p, box.center(), box.height() * 0.56, back);
      break;
  }
  p.restore();
}

}  // namespace stillcut::ui
