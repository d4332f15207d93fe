#include "ui/report/page_style.h"

namespace stillcut::ui {

QFont PageStyle::font(double size, bool bold) const {
  QFont font = theme_.font(size, bold);
  // What comes with the program first: behind a family that is missing Qt writes digits that no reader can search for.
  font.setFamilies({"DejaVu Sans", "Noto Sans CJK SC"});
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

void drawLine(QPainter& painter, const QRectF& area, const QString& text, const QFont& font, const QColor& color,
              Qt::Alignment align) {
  const QString fitted = QFontMetricsF(font).elidedText(text, Qt::ElideRight, area.width() + 0.5);
  painter.setFont(font);
  painter.setPen(color);
  painter.drawText(area, static_cast<int>(align) | Qt::TextSingleLine | Qt::TextDontClip, fitted);
}

double drawWords(QPainter& painter, const QRectF& area, const QString& text, const QFont& font, const QColor& color) {
  painter.setFont(font);
  painter.setPen(color);
  QRectF taken;
  painter.drawText(area, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap | Qt::TextDontClip, text, &taken);
  return taken.height();
}

}  // namespace stillcut::ui
