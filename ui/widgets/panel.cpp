#include "ui/widgets/panel.h"

#include "ui/widgets/painting.h"

namespace stillcut::ui {

Panel::Panel(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {}

void Panel::applyTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void Panel::paintEvent(QPaintEvent*) {
  QPainter p(this);
  drawPanel(p, rect(), theme_, theme_.colors.panel);
}

}  // namespace stillcut::ui
