#include "ui/widgets/limit_bar.h"

#include <QPainter>

#include "ui/widgets/painting.h"

namespace stillcut::ui {

namespace {

constexpr int kParts = 4;  // of the scale

}  // namespace

// Quarters of the full length, and what the full length is.
void LimitBar::drawScale(QPainter& p, const QRectF& bed) const {
  p.setPen(QPen(theme_.colors.secondary, 1.0));
  for (int k = 0; k <= kParts; ++k) {
    const double x = bed.left() + bed.width() * k / kParts;
    p.drawLine(QPointF(x, bed.bottom()), QPointF(x, bed.bottom() + theme_.px(4)));
  }
  const QString& text = view_.withoutText.isEmpty() ? view_.full : view_.withoutText;
  if (!view_.known || text.isEmpty()) return;
  p.setFont(theme_.font(type_size::kTick));
  const double wide = p.fontMetrics().horizontalAdvance(text) + theme_.px(6);
  if (bed.width() * (1.0 - view_.fraction) < wide) return;  // the bar itself says that it is near the end
  p.setPen(theme_.colors.secondary);
  p.drawText(bed.adjusted(0, -theme_.px(2), -theme_.px(4), theme_.px(2)), Qt::AlignRight | Qt::AlignVCenter, text);
}

// What it would be without us: an outline around what it is.
void LimitBar::drawWithout(QPainter& p, const QRectF& bed) const {
  if (view_.without < 0.0 || !view_.known) return;
  p.setBrush(Qt::NoBrush);
  p.setPen(QPen(theme_.colors.chatterText, theme_.px(2), Qt::DashLine));
  p.drawRect(QRectF(bed.left(), bed.top() - theme_.px(2), bed.width() * view_.without, bed.height() + theme_.px(4)));
}

LimitBar::LimitBar(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void LimitBar::display(const BarView& view) {
  if (view == view_) return;
  view_ = view;
  setAccessibleName(view.label);
  setAccessibleDescription(view.withoutText.isEmpty() ? view.value
                                                      : QStringLiteral("%1, %2").arg(view.value, view.withoutText));
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
  text.centred(QRectF(width() - valueWidth, 0, valueWidth, height()), view_.value,
               {type_size::kValue, true, view_.known && view_.counts ? theme_.onPanel(view_.tone) : theme_.colors.faint,
                Qt::AlignRight, 0.7});

  const double thick = theme_.px(14), overhang = theme_.px(5);
  const QRectF bed(labelWidth + gap, (height() - thick) / 2.0, width() - labelWidth - valueWidth - 2 * gap, thick);
  p.fillRect(bed, theme_.colors.track);
  if (view_.known) {
    const QColor plain = view_.counts ? theme_.colors.fill : theme_.colors.hatch;
    const QColor fill = view_.counts && view_.tone != Tone::Normal ? theme_.back(view_.tone) : plain;
    p.fillRect(QRectF(bed.left(), bed.top(), bed.width() * view_.fraction, bed.height()), fill);
  } else {
    p.fillRect(bed, QBrush(theme_.colors.hatch, Qt::BDiagPattern));
  }
  drawScale(p, bed);
  drawWithout(p, bed);
  p.setPen(QPen(view_.counts ? theme_.colors.text : theme_.colors.faint, theme_.px(2)));
  for (const double mark : view_.marks) {
    const double x = bed.left() + bed.width() * mark;
    p.drawLine(QPointF(x, bed.top() - overhang), QPointF(x, bed.bottom() + overhang));
  }
  clipped_ = text.clipped();
}

}  // namespace stillcut::ui
