#include "ui/widgets/verdict_shape.h"

#include <cmath>
#include <numbers>

namespace stillcut::ui {
namespace {

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

void drawVerdictShape(QPainter& p, const QRectF& box, Shape shape, const Theme& theme, const QColor& front,
                      const QColor& back) {
  const double stroke = box.width() * 0.1;
  const QRectF inset = box.adjusted(stroke / 2, stroke / 2, -stroke / 2, -stroke / 2);
  p.save();
  switch (shape) {
    case Shape::Ring:
      p.setBrush(Qt::NoBrush);
      p.setPen(QPen(theme.colors.faint, stroke * 0.7, Qt::CustomDashLine, Qt::FlatCap));
      {
        QPen pen = p.pen();
        pen.setDashPattern({2.2, 1.6});
        p.setPen(pen);
      }
      p.drawEllipse(inset);
      break;
    case Shape::Circle:
      p.setBrush(Qt::NoBrush);
      p.setPen(QPen(theme.colors.fill, stroke));
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
