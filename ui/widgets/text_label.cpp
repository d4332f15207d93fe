#include "ui/widgets/text_label.h"

namespace stillcut::ui {

TextLabel::TextLabel(const Look& look, const QString& text, QWidget* parent)
    : QLabel(text, parent), theme_(makeTheme(ThemeKind::Light, 1.0)), look_(look) {
  setWordWrap(look.wrap);
  setTextFormat(Qt::PlainText);
  paintText();
}

void TextLabel::setTone(Tone tone) {
  if (tone == tone_) return;
  tone_ = tone;
  paintText();
}

void TextLabel::applyTheme(const Theme& theme) {
  theme_ = theme;
  paintText();
}

void TextLabel::paintText() {
  setFont(theme_.font(look_.size, look_.bold));
  QPalette colors = palette();
  const QColor color = tone_ == Tone::Normal && look_.secondary ? theme_.colors.secondary : theme_.onPanel(tone_);
  colors.setColor(QPalette::WindowText, color);
  setPalette(colors);
}

}  // namespace stillcut::ui
