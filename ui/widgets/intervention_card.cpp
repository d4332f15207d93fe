#include "ui/widgets/intervention_card.h"

#include <QPainter>
#include <array>

#include "ui/widgets/painting.h"

namespace stillcut::ui {

InterventionCard::InterventionCard(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void InterventionCard::display(const CardView& view) {
  if (view == view_) return;
  view_ = view;
  setAccessibleName(view.headline);
  setAccessibleDescription(
      QStringList{view.time, view.speed, view.ratio, view.cost, view.vibration}.join(QStringLiteral(", ")));
  updateGeometry();
  update();
}

void InterventionCard::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QSize InterventionCard::sizeHint() const {
  return {theme_.px(420), theme_.px(view_.vibration.isEmpty() ? 53 : 77)};
}

void InterventionCard::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  TextPainter text(p, theme_);
  const double stripe = theme_.px(4), left = theme_.px(14), edge = theme_.px(4);
  const double row = (height() - 2.0 * edge) / (view_.vibration.isEmpty() ? 2.0 : 3.0);
  const QColor tone = view_.tone == Tone::Normal ? theme_.colors.fill : theme_.back(view_.tone);
  p.fillRect(QRectF(0, theme_.px(4), stripe, height() - theme_.px(8)), tone);
  const double timeWidth = theme_.px(76);
  const QRectF upper(left, edge, width() - left, row), lower = upper.translated(0.0, row);
  text.centred(QRectF(upper.left(), upper.top(), timeWidth, upper.height()), view_.time,
               {type_size::kLabel, false, theme_.colors.secondary, Qt::AlignLeft, 0.8});
  text.centred(upper.adjusted(timeWidth, 0, 0, 0), view_.headline,
               {type_size::kBody, true, theme_.onPanel(view_.tone), Qt::AlignLeft, 0.75});
  // Each column has its share of what all of them ask for.
  const QFontMetricsF metrics(theme_.font(type_size::kBody));
  const std::array<const QString*, 3> parts{&view_.speed, &view_.ratio, &view_.cost};
  const double gap = theme_.px(14);
  double asked = 0.0;
  for (const QString* part : parts) asked += part->isEmpty() ? 0.0 : metrics.horizontalAdvance(*part) + gap;
  double x = lower.left();
  for (const QString* part : parts) {
    if (part->isEmpty()) continue;
    const double share = (metrics.horizontalAdvance(*part) + gap) / asked * lower.width();
    text.centred(QRectF(x, lower.top(), share - theme_.px(6), lower.height()), *part,
                 {type_size::kBody, false, theme_.colors.text, Qt::AlignLeft, 0.8});
    x += share;
  }
  text.centred(lower.translated(0.0, row), view_.vibration,
               {type_size::kBody, false, theme_.colors.text, Qt::AlignLeft, 0.75});
  clipped_ = text.clipped();
}

}  // namespace stillcut::ui
