#include "ui/widgets/touch_button.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QShortcut>
#include <algorithm>

#include "ui/widgets/painting.h"

namespace stillcut::ui {

TouchButton::TouchButton(const QString& caption, Look look, QWidget* parent)
    : QAbstractButton(parent), theme_(makeTheme(ThemeKind::Light, 1.0)), look_(look) {
  setText(caption);
  setAccessibleName(caption);
  setFocusPolicy(Qt::TabFocus);  // a touch leaves no frame behind; the keyboard reaches everything
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setAttribute(Qt::WA_Hover);
}

void TouchButton::setHint(const QString& hint) {
  hint_ = hint;
  updateGeometry();
  update();
}

void TouchButton::setKey(const QKeySequence& key) {
  auto* shortcut = new QShortcut(key, this);
  connect(shortcut, &QShortcut::activated, this, [this] { click(); });
  shortcut->setAutoRepeat(false);
  setHint(key.toString(QKeySequence::NativeText));
}

void TouchButton::setAsking(bool asking, const QString& caption, const QString& hint) {
  if (asking == asking_ && caption == askCaption_) return;
  asking_ = asking;
  askCaption_ = caption;
  askHint_ = hint;
  setAccessibleDescription(asking ? caption + u' ' + hint : QString());
  update();
}

void TouchButton::setCheckedTone(Tone tone) {
  checkedTone_ = tone;
  update();
}

void TouchButton::setBaseHeight(double base) {
  baseHeight_ = base;
  updateGeometry();
}

void TouchButton::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QSize TouchButton::sizeHint() const {
  const QFontMetricsF caption(theme_.font(type_size::kButton, true));
  const QFontMetricsF small(theme_.font(type_size::kTick));
  const double width = std::max(caption.horizontalAdvance(text()), small.horizontalAdvance(hint_)) +
                       theme_.px(look_ == Look::Tab ? 22 : 40);
  const int touch = pixelsFor(kTouchMm, this);
  return {std::max(static_cast<int>(width), touch), std::max(theme_.px(baseHeight_), touch)};
}

TouchButton::Paint TouchButton::paint() const {
  const ThemeColors& c = theme_.colors;
  if (look_ == Look::Tab) {
    if (isChecked()) return {c.panel, c.text, c.border};
    return {c.window, c.secondary, c.window};
  }
  if (!isEnabled()) {
    // A state that cannot be changed just now still shows which one it is.
    if (isChecked()) return {c.track, c.text, c.secondary};
    return {c.panel, c.faint, c.border};
  }
  if (asking_) return {c.onset, c.onOnset, c.onset};
  if (isChecked())
    return checkedTone_ == Tone::Normal
               ? Paint{c.text, c.panel, c.text}
               : Paint{theme_.back(checkedTone_), theme_.front(checkedTone_), theme_.back(checkedTone_)};
  if (look_ == Look::Advice) return {c.advice, c.onAdvice, c.advice};
  return {c.raised, c.text, c.secondary};
}

void TouchButton::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  Paint look = paint();
  if (isDown()) look.back = look.back.lightnessF() > 0.5 ? look.back.darker(115) : look.back.lighter(140);
  const double radius = theme_.px(6);
  const double line = look_ == Look::Tab ? 1.0 : theme_.px(1.5);
  p.setPen(QPen(look.border, line));
  p.setBrush(look.back);
  p.drawRoundedRect(QRectF(rect()).adjusted(line / 2, line / 2, -line / 2, -line / 2), radius, radius);
  if (hasFocus()) {
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(look.front, theme_.px(2)));
    p.drawRoundedRect(QRectF(rect()).adjusted(4, 4, -4, -4), radius - 2, radius - 2);
  }
  TextPainter text(p, theme_);
  const QString caption = asking_ ? askCaption_ : this->text();
  const QString small = asking_ ? askHint_ : hint_;
  const QRectF inner = QRectF(rect()).adjusted(theme_.px(8), 0, -theme_.px(8), 0);
  const double lift = small.isEmpty() ? 0.0 : height() * 0.14;
  text.centred(inner.translated(0, -lift), caption, {type_size::kButton, true, look.front, Qt::AlignHCenter, 0.75});
  text.centred(inner.translated(0, height() * 0.24), small,
               {type_size::kTick, false, look.front, Qt::AlignHCenter, 0.75});
  clipped_ = text.clipped();
}

}  // namespace stillcut::ui
