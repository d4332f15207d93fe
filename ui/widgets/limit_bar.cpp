#include "ui/widgets/limit_bar.h"

#include <QPainter>

#include "ui/widgets/painting.h"

namespace stillcut::ui {

LimitBar::LimitBar(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void LimitBar::display(const BarView& view) {
  if (view == view_) return;
  view_ = view;
  setAccessibleName(view.label);
  setAccessibleDescription(view.value);
  update();
}

void LimitBar::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QSize LimitBar::sizeHint() const {
  return {theme_.px(420), theme_.px(30)};
}

void LimitBar::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  TextPainter text(p, theme_);
  const double labelWidth = theme_.px(124), valueWidth = theme_.px(132), gap = theme_.px(12);
  text.centred(QRectF(0, 0, labelWidth, height()), view_.label,
               {type_size::kBody, false, theme_.colors.secondary, Qt::AlignLeft, 0.8});
  text.centred(
      QRectF(width() - valueWidth, 0, valueWidth, height()), view_.value,
      {type_size::kValue, true, view_.known ? theme_.onPanel(view_.tone) : theme_.colors.faint, Qt::AlignRight, 0.7});

  const double thick = theme_.px(14), overhang = theme_.px(5);
  const QRectF bed(labelWidth + gap, (height() - thick) / 2.0, width() - labelWidth - valueWidth - 2 * gap, thick);
  p.fillRect(bed, theme_.colors.track);
  if (view_.known) {
    const QColor fill = view_.tone == Tone::Normal ? theme_.colors.fill : theme_.back(view_.tone);
    p.fillRect(QRectF(bed.left(), bed.top(), bed.width() * view_.fraction, bed.height()), fill);
  } else {
    p.fillRect(bed, QBrush(theme_.colors.hatch, Qt::BDiagPattern));
  }
  p.setPen(QPen(theme_.colors.text, theme_.px(2)));
  for (const double mark : view_.marks) {
    const double x = bed.left() + bed.width() * mark;
    p.drawLine(QPointF(x, bed.top() - overhang), QPointF(x, bed.bottom() + overhang));
  }
  clipped_ = text.clipped();
}

}  // namespace stillcut::ui
