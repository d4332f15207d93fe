#include "ui/widgets/value_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "ui/widgets/painting.h"

namespace stillcut::ui {
namespace {

constexpr double kHandle = 16;  // wide, before scaling

}  // namespace

ValueSlider::ValueSlider(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setCursor(Qt::PointingHandCursor);
}

void ValueSlider::display(double fraction, double fallback, bool automatic) {
  fraction_ = std::clamp(fraction, 0.0, 1.0);
  fallback_ = std::clamp(fallback, 0.0, 1.0);
  automatic_ = automatic;
  update();
}

void ValueSlider::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QSize ValueSlider::sizeHint() const {
  return {theme_.px(180), touchHeight(theme_, this)};
}

QSize ValueSlider::minimumSizeHint() const {
  return {theme_.px(80), sizeHint().height()};
}

QRectF ValueSlider::track() const {
  const double side = theme_.px(kHandle) / 2.0 + theme_.px(3);
  const double thick = theme_.px(6);
  return {side, (height() - thick) / 2.0, std::max(width() - 2.0 * side, 1.0), thick};
}

void ValueSlider::moveTo(double x) {
  const QRectF line = track();
  emit moved(std::clamp((x - line.left()) / line.width(), 0.0, 1.0));
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) moveTo(event->position().x());
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) moveTo(event->position().x());
}

void ValueSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit released();
}

void ValueSlider::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Right:
    case Qt::Key_Plus:
      emit stepped(1);
      break;
    case Qt::Key_Left:
    case Qt::Key_Minus:
      emit stepped(-1);
      break;
    case Qt::Key_Home:
      emit moved(0.0);
      break;
    case Qt::Key_End:
      emit moved(1.0);
      break;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  emit released();
}

void ValueSlider::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const ThemeColors& c = theme_.colors;
  const QRectF line = track();
  const double radius = line.height() / 2;
  const bool live = isEnabled();
  p.setPen(Qt::NoPen);
  p.setBrush(c.track);
  p.drawRoundedRect(line, radius, radius);
  const double at = line.left() + fraction_ * line.width();
  if (!automatic_) {
    p.setBrush(live ? c.fill : c.faint);
    p.drawRoundedRect(QRectF(line.left(), line.top(), at - line.left(), line.height()), radius, radius);
  }
  const double mark = line.left() + fallback_ * line.width();
  p.setPen(QPen(c.secondary, theme_.px(2)));
  p.drawLine(QPointF(mark, line.top() - theme_.px(8)), QPointF(mark, line.top() - theme_.px(2)));
  const double w = theme_.px(kHandle), h = theme_.px(34);
  p.setPen(QPen(hasFocus() ? c.advice
                : live     ? c.text
                           : c.faint,
                theme_.px(hasFocus() ? 3 : 1.5), automatic_ ? Qt::DashLine : Qt::SolidLine));
  p.setBrush(automatic_ ? c.panel : c.raised);
  p.drawRoundedRect(QRectF(at - w / 2, (height() - h) / 2.0, w, h), theme_.px(4), theme_.px(4));
}

}  // namespace stillcut::ui
