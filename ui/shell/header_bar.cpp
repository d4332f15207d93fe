#include "ui/shell/header_bar.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

#include "ui/widgets/painting.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {

HeaderBar::HeaderBar(QWidget* parent)
    : QWidget(parent),
      theme_(makeTheme(ThemeKind::Light, 1.0)),
      displayButton_(new TouchButton(tr("Display"), TouchButton::Look::Tab, this)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  displayButton_->setObjectName(QStringLiteral("display"));
  displayButton_->setBaseHeight(44);
  displayButton_->setToolTip(tr("Theme, units, language (F11); next theme (F12)"));
  connect(displayButton_, &TouchButton::clicked, this, &HeaderBar::displayAsked);
}

void HeaderBar::setSession(const SessionInfo& info) {
  machine_ = QString::fromStdString(info.setup.machine);
  tool_ = QString::fromStdString(info.setup.tool);
  badge_ = info.simulatedMachine ? tr("SIMULATED MACHINE") : QString();
  const QString whole = QStringList{machine_, tool_, badge_}.join(QStringLiteral(", "));
  setAccessibleName(whole);
  setToolTip(whole);  // long names are cut short on the bar
  update();
}

void HeaderBar::addPage(const QString& title, const QKeySequence& key, const QString& name) {
  auto* button = new TouchButton(title, TouchButton::Look::Tab, this);
  button->setObjectName(name);
  button->setToolTip(QStringLiteral("%1 (%2)").arg(title, key.toString(QKeySequence::NativeText)));
  button->setCheckable(true);
  button->setBaseHeight(44);
  const int index = static_cast<int>(pages_.size());
  pages_.push_back(button);
  connect(button, &TouchButton::clicked, this, [this, index] { emit pageAsked(index); });
  button->applyTheme(theme_);
  placeButtons();
}

void HeaderBar::setCurrentPage(int index) {
  for (std::size_t k = 0; k < pages_.size(); ++k) pages_[k]->setChecked(static_cast<int>(k) == index);
}

void HeaderBar::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  placeButtons();
  update();
}

QSize HeaderBar::sizeHint() const {
  return {theme_.px(800), displayButton_->sizeHint().height() + theme_.px(10)};
}

void HeaderBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeButtons();
}

void HeaderBar::placeButtons() {
  const int gap = pixelsFor(kTouchGapMm, this);
  int right = width() - theme_.px(16);
  const auto place = [&](TouchButton* button) {
    const QSize size = button->sizeHint();
    right -= size.width();
    button->setGeometry(right, (height() - size.height()) / 2, size.width(), size.height());
    right -= gap;
  };
  place(displayButton_);
  for (auto it = pages_.rbegin(); it != pages_.rend(); ++it) place(*it);
}

void HeaderBar::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(theme_.colors.border);
  p.drawLine(0, height() - 1, width(), height() - 1);
  TextPainter text(p, theme_);
  const double gap = theme_.px(18);
  double x = theme_.px(16);
  const auto widthOf = [&](const QString& what, const TextStyle& style) {
    return QFontMetricsF(theme_.font(style.size, style.bold)).horizontalAdvance(what) + 1;
  };
  // That the machine is a simulated one is never cut off: names give way.
  const TextStyle badgeStyle{type_size::kLabel, true, theme_.colors.text, Qt::AlignHCenter};
  const double badge = badge_.isEmpty() ? 0.0 : widthOf(badge_, badgeStyle) + theme_.px(24);
  const double end = (pages_.empty() ? displayButton_ : pages_.front())->x() - gap;
  const double namesEnd = end - (badge > 0 ? badge + gap : 0.0);
  const TextStyle machineStyle{type_size::kButton, true, theme_.colors.text};
  const TextStyle toolStyle{type_size::kBody, false, theme_.colors.secondary};
  const double machine = std::min(widthOf(machine_, machineStyle), namesEnd - x);
  text.centred(QRectF(x, 0, machine, height()), machine_, machineStyle);
  x += machine + gap;
  // Whole or not at all: half a tool's name may be another tool's. The tool tip has it.
  if (const double tool = widthOf(tool_, toolStyle); tool <= namesEnd - x) {
    text.centred(QRectF(x, 0, tool, height()), tool_, toolStyle);
    x += tool + gap;
  }
  if (badge > 0) {
    const QRectF box(x, (height() - theme_.px(30)) / 2.0, badge, theme_.px(30));
    p.setPen(QPen(theme_.colors.text, theme_.px(1.5)));
    p.setBrush(Qt::NoBrush);
    p.drawRoundedRect(box, box.height() / 2, box.height() / 2);
    text.centred(box.adjusted(theme_.px(8), 0, -theme_.px(8), 0), badge_, badgeStyle);
  }
  clipped_ = text.clipped();
}

}  // namespace stillcut::ui
