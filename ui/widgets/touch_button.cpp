#include "ui/widgets/touch_button.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QShortcut>
#include <algorithm>
#include <utility>

#include "ui/widgets/painting.h"

namespace stillcut::ui {
namespace {

constexpr double kTwoLineSize = 15;  // two lines of it fit a target of 12 mm

// Broken at the space that leaves the longer line shortest.
std::pair<QString, QString> halves(const QString& caption, const QFontMetricsF& metrics) {
  std::pair<QString, QString> best{caption, {}};
  double narrowest = metrics.horizontalAdvance(caption);
  for (qsizetype at = caption.indexOf(u' '); at > 0; at = caption.indexOf(u' ', at + 1)) {
    const QString first = caption.left(at), second = caption.mid(at + 1);
    const double width = std::max(metrics.horizontalAdvance(first), metrics.horizontalAdvance(second));
    if (width >= narrowest) continue;
    narrowest = width;
    best = {first, second};
  }
  return best;
}

}  // namespace

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

void TouchButton::setTwoLines(bool on) {
  twoLines_ = on;
  updateGeometry();
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

double TouchButton::captionWidth() const {
  if (!twoLines_) return QFontMetricsF(theme_.font(type_size::kButton, true)).horizontalAdvance(text());
  const QFontMetricsF metrics(theme_.font(kTwoLineSize, true));
  const auto [first, second] = halves(text(), metrics);
  return std::max(metrics.horizontalAdvance(first), metrics.horizontalAdvance(second));
}

QSize TouchButton::sizeHint() const {
  const QFontMetricsF small(theme_.font(type_size::kTick));
  const double width = std::max(captionWidth(), small.horizontalAdvance(hint_)) + theme_.px(look_ == Look::Tab ? 22
                                                                                            : twoLines_        ? 24
                                                                                                               : 40);
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
  // Where every edge is white, what cannot be touched has a broken one.
  const bool broken = !isEnabled() && theme_.kind == ThemeKind::HighContrast;
  p.setPen(QPen(look.border, line, broken ? Qt::DashLine : Qt::SolidLine));
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
  if (twoLines_) {
    const TextStyle style{kTwoLineSize, true, look.front, Qt::AlignHCenter, 0.75};
    const QFontMetricsF metrics(theme_.font(kTwoLineSize, true));
    const bool oneLine = metrics.horizontalAdvance(caption) <= inner.width();
    const auto [first, second] = oneLine ? std::pair(caption, QString()) : halves(caption, metrics);
    const double apart = second.isEmpty() ? 0.0 : metrics.height() * 0.5;
    text.centred(inner.translated(0, -apart), first, style);
    text.centred(inner.translated(0, apart), second, style);
    clipped_ = text.clipped();
    return;
  }
  const double lift = small.isEmpty() ? 0.0 : height() * 0.14;
  text.centred(inner.translated(0, -lift), caption, {type_size::kButton, true, look.front, Qt::AlignHCenter, 0.75});
  text.centred(inner.translated(0, height() * 0.24), small,
               {type_size::kTick, false, look.front, Qt::AlignHCenter, 0.75});
  clipped_ = text.clipped();
}

}  // namespace stillcut::ui
