#include "ui/widgets/status_strip.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

#include "ui/widgets/painting.h"

namespace stillcut::ui {

StatusStrip::StatusStrip(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("State of the chain"));
}

void StatusStrip::display(const std::vector<StripItem>& items) {
  if (items == items_) return;
  items_ = items;
  QStringList spoken;
  for (const StripItem& item : items) spoken << item.label + u' ' + item.value;
  setAccessibleDescription(spoken.join(QStringLiteral(", ")));
  update();
}

void StatusStrip::applyTheme(const Theme& theme) {
  theme_ = theme;
  widest_.clear();
  updateGeometry();
  update();
}

QSize StatusStrip::sizeHint() const {
  return {theme_.px(800), theme_.px(32)};
}

// Items keep their place while their numbers change: an item never gets narrower again.
void StatusStrip::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  TextPainter text(p, theme_);
  const double pad = theme_.px(16), gap = theme_.px(7), between = theme_.px(14);
  const QFontMetricsF plain(theme_.font(type_size::kLabel)), bold(theme_.font(type_size::kLabel, true));
  std::vector<double> labels, values;
  double used = 0.0;
  for (const StripItem& item : items_) {
    labels.push_back(plain.horizontalAdvance(item.label));
    const std::size_t k = values.size();
    if (widest_.size() <= k) widest_.push_back(bold.horizontalAdvance(QStringLiteral("00 ms")));
    widest_[k] = std::max(widest_[k], bold.horizontalAdvance(item.value));
    values.push_back(widest_[k]);
    used += labels.back() + gap + values.back();
  }
  const double room = width() - 2 * pad - used;
  const double spread = items_.size() > 1 ? room / static_cast<double>(items_.size() - 1) : 0.0;
  clipped_ = spread < between;
  double x = pad;
  for (std::size_t k = 0; k < items_.size(); ++k) {
    text.centred(QRectF(x, 0, labels[k] + 1, height()), items_[k].label,
                 {type_size::kLabel, false, theme_.colors.secondary});
    x += labels[k] + gap;
    text.centred(QRectF(x, 0, values[k] + 1, height()), items_[k].value,
                 {type_size::kLabel, true, theme_.onPanel(items_[k].tone)});
    x += values[k] + spread;
  }
}

}  // namespace stillcut::ui
