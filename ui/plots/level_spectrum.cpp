#include "ui/plots/level_spectrum.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/plots/axis_painter.h"
#include "ui/plots/nice_ticks.h"

namespace stillcut::ui {
namespace {

constexpr double kSpan_dB = 80.0;  // shown below the highest level

}  // namespace

LevelSpectrum::LevelSpectrum(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setAccessibleName(tr("Spectrum of the first channel, now"));
}

void LevelSpectrum::display(const Picture& picture) {
  alive_ = picture.snapshot != nullptr && !picture.stale && picture.snapshot->columnCount > 0;
  if (alive_) {
    const Snapshot& s = *picture.snapshot;
    level_ = s.columns[(s.columnCount - 1) % kSpectrumColumns].level_dB;
    top_hz_ = s.spectrumTop.value;
  }
  update();
}

void LevelSpectrum::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

void LevelSpectrum::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const QRectF box = QRectF(rect()).adjusted(theme_.px(56), theme_.px(12), -theme_.px(6), -theme_.px(26));
  p.fillRect(box, theme_.colors.track);
  p.setFont(theme_.font(type_size::kTick));
  if (!alive_) {
    p.setPen(theme_.colors.secondary);
    p.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, tr("No samples come"));
    return;
  }
  // The axis moves in steps of ten decibels, not with every picture.
  const double top = 10.0 * std::ceil(*std::max_element(level_.begin() + 1, level_.end()) / 10.0);
  QPainterPath path;
  path.moveTo(box.bottomLeft());
  for (std::size_t k = 1; k < level_.size(); ++k) {
    const double x = box.left() + box.width() * static_cast<double>(k) / static_cast<double>(level_.size());
    const double share = std::clamp((level_[k] - top) / kSpan_dB + 1.0, 0.0, 1.0);
    path.lineTo(x, box.bottom() - share * (box.height() - 2));
  }
  path.lineTo(box.bottomRight());
  p.setPen(Qt::NoPen);
  p.setBrush(theme_.colors.fill);
  p.drawPath(path);
  drawLeftAxis(p, box.toRect(), {top - kSpan_dB, top}, QStringLiteral("dB"), theme_);
  p.setPen(theme_.colors.secondary);
  for (const double tick : niceTicks(0.0, top_hz_, 4)) {
    const double x = box.left() + tick / std::max(top_hz_, 1.0) * box.width();
    p.drawLine(QPointF(x, box.bottom()), QPointF(x, box.bottom() + theme_.px(4)));
    p.drawText(QRectF(std::max(x - theme_.px(40), box.left() - theme_.px(28)), box.bottom() + theme_.px(4),
                      theme_.px(80), theme_.px(20)),
               Qt::AlignCenter, join(number(tick), QStringLiteral("Hz")));
  }
}

}  // namespace stillcut::ui
