#include "ui/plots/spectrogram/level_key.h"

#include <QLinearGradient>

#include "ui/plots/spectrogram/colormap.h"

namespace stillcut::ui {

int drawLevelKey(QPainter& p, const QRect& row, LevelKeyKind kind, const QString& low, const QString& high,
                 const Theme& theme) {
  p.setFont(theme.font(type_size::kLabel));
  p.setPen(theme.colors.secondary);
  const QFontMetrics metrics = p.fontMetrics();
  const int wide = theme.px(110), tall = theme.px(10), gap = theme.px(8);
  const int baseline = row.top() + (row.height() + metrics.ascent() - metrics.descent()) / 2;
  int x = row.right() + 1 - metrics.horizontalAdvance(high);
  p.drawText(x, baseline, high);
  x -= gap + wide;
  const QRect bar(x, row.top() + (row.height() - tall) / 2, wide, tall);
  if (kind == LevelKeyKind::Colors) {
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    for (int i = 0; i <= 16; ++i)
      gradient.setColorAt(i / 16.0, QColor::fromRgb(viridis()[static_cast<std::size_t>(i * 255 / 16)]));
    p.fillRect(bar, gradient);
  } else {
    p.save();
    p.setPen(Qt::NoPen);
    p.setBrush(theme.colors.secondary);
    p.drawPolygon(QPolygon{bar.bottomLeft(), bar.bottomRight(), bar.topRight()});
    p.restore();
  }
  x -= gap + metrics.horizontalAdvance(low);
  p.drawText(x, baseline, low);
  return x;
}

}  // namespace stillcut::ui
