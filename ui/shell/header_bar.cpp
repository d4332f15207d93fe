#include "ui/shell/header_bar.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

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
  placeButtons();
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

// In two lines as wide as its longest word.
double HeaderBar::badgeWidth(bool oneLine) const {
  if (badge_.isEmpty()) return 0.0;
  const QFontMetricsF metrics(theme_.font(type_size::kLabel, true));
  double widest = 0.0;
  for (const QString& words : oneLine ? QStringList(badge_) : badge_.split(u' '))
    widest = std::max(widest, metrics.horizontalAdvance(words));
  return widest + 1 + theme_.px(24);
}

// What says that the machine is a simulated one has its room before the air in the buttons.
void HeaderBar::placeButtons() {
  constexpr double kAir = 14;  // of a button, that it can do without
  const int gap = pixelsFor(kTouchGapMm, this), touch = pixelsFor(kTouchMm, this);
  int wanted = theme_.px(16) + displayButton_->sizeHint().width();
  for (const TouchButton* page : pages_) wanted += gap + page->sizeHint().width();
  const double badge = badgeWidth(false) > 0.0 ? badgeWidth(false) + theme_.px(16 + 18) : 0.0;
  const double over = (wanted + badge - width()) / static_cast<double>(pages_.size() + 1);
  const int narrower = std::clamp(static_cast<int>(std::ceil(over)), 0, theme_.px(kAir));
  int right = width() - theme_.px(16);
  const auto place = [&](TouchButton* button) {
    const QSize size = button->sizeHint();
    const int wide = std::max(size.width() - narrower, std::min(size.width(), touch));
    right -= wide;
    button->setGeometry(right, (height() - size.height()) / 2, wide, size.height());
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
  const TextStyle badgeStyle{type_size::kLabel, true, theme_.colors.text, Qt::AlignHCenter, 0.7};
  const double end = (pages_.empty() ? displayButton_ : pages_.front())->x() - gap;
  const double badge = std::min(badgeWidth(true), std::max(end - x, badgeWidth(false)));
  const double namesEnd = end - (badge > 0 ? badge + gap : 0.0);
  const TextStyle machineStyle{type_size::kButton, true, theme_.colors.text};
  const TextStyle toolStyle{type_size::kBody, false, theme_.colors.secondary};
  if (const double machine = std::min(widthOf(machine_, machineStyle), namesEnd - x); machine > theme_.px(40)) {
    text.centred(QRectF(x, 0, machine, height()), machine_, machineStyle);
    x += machine + gap;
  }
  // Whole or not at all: half a tool's name may be another tool's. The tool tip has it.
  if (const double tool = widthOf(tool_, toolStyle); tool <= namesEnd - x) {
    text.centred(QRectF(x, 0, tool, height()), tool_, toolStyle);
    x += tool + gap;
  }
  badgeBox_ = {};
  if (badge > 0) {
    const bool oneLine = badge >= badgeWidth(true);
    const int high = theme_.px(oneLine ? 30 : 42);
    badgeBox_ = QRectF(x, (height() - high) / 2.0, badge, high);
    p.setPen(QPen(theme_.colors.text, theme_.px(1.5)));
    p.setBrush(Qt::NoBrush);
    const int round = theme_.px(oneLine ? 15 : 8);
    p.drawRoundedRect(badgeBox_, round, round);
    const QRectF words = badgeBox_.adjusted(theme_.px(8), theme_.px(2), -theme_.px(8), -theme_.px(2));
    oneLine ? text.centred(words, badge_, badgeStyle) : static_cast<void>(text.block(words, badge_, badgeStyle));
  }
  clipped_ = text.clipped();
}

}  // namespace stillcut::ui
