// Drawing helpers of the painted widgets: the panel every one lies on, and text that says when it does not fit.
// GUI thread.
#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>

#include "ui/base/theme.h"

namespace stillcut::ui {

// At least this many pixels for `mm` on the screen of `widget`, as far as the screen tells its size truly.
int pixelsFor(double mm, const QWidget* widget);
// Of what is touched: `base` before scaling, and no less than a finger in a glove needs.
int touchHeight(const Theme& theme, const QWidget* widget, double base = 46);
inline constexpr double kTouchMm = 12.0;
inline constexpr double kTouchGapMm = 3.0;

void drawPanel(QPainter& p, const QRectF& rect, const Theme& theme, const QColor& back);

struct TextStyle {
  double size = type_size::kBody;
  bool bold = false;
  QColor color;
  Qt::Alignment align = Qt::AlignLeft;
  double smallest = 0.8;  // of the size, before the text counts as clipped
};

// One paint event's text. Shrinks a line a little before giving up, and remembers whether it had to give up.
class TextPainter {
 public:
  TextPainter(QPainter& painter, const Theme& theme) : p_(painter), theme_(theme) {}

  // One line whose capitals sit between `top` and the returned bottom.
  double line(double left, double top, double width, const QString& text, const TextStyle& style);
  // One line centred in the height of the box.
  void centred(const QRectF& box, const QString& text, const TextStyle& style);
  // Wrapped text from the top of the box; returns its bottom.
  double block(const QRectF& box, const QString& text, const TextStyle& style);
  bool clipped() const { return clipped_; }

 private:
  QFont fit(double width, const QString& text, const TextStyle& style);

  QPainter& p_;
  const Theme& theme_;
  bool clipped_ = false;
};

double capHeight(const Theme& theme, double size, bool bold);

}  // namespace stillcut::ui
