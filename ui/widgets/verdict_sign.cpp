#include "ui/widgets/verdict_sign.h"

#include <QAccessible>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <array>

#include "ui/widgets/painting.h"
#include "ui/widgets/verdict_shape.h"

namespace stillcut::ui {
namespace {

constexpr double kPad = 24;
constexpr double kShape = 82;
constexpr double kGap = 26, kLeastGap = 8, kLeastPad = 8;

}  // namespace

VerdictSign::VerdictSign(QWidget* parent) : QWidget(parent), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  setAccessibleName(tr("Verdict"));
}

void VerdictSign::display(const VerdictView& view) {
  if (view == view_) return;
  const bool newWord = view.word != view_.word;
  view_ = view;
  setAccessibleDescription(view.spoken());
  if (newWord) {
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
  }
  update();
}

void VerdictSign::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  update();
}

QSize VerdictSign::minimumSizeHint() const {
  return {theme_.px(540), theme_.px(252)};
}

void VerdictSign::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  drawPanel(p, rect(), theme_, theme_.back(view_.tone));
  TextPainter text(p, theme_);
  const QColor front = theme_.front(view_.tone);
  const bool alarm = view_.tone == Tone::Onset || view_.tone == Tone::Chatter;
  const QColor second = alarm ? front : theme_.colors.secondary;

  // Rows by the height of their capitals: shape and word, frequency, kind, detail, marked; the block sits in the middle
  // of the panel, and on a low screen its gaps give way before its letters do.
  const double shape = theme_.px(kShape), pad = theme_.px(kPad), room = width() - 2.0 * pad;
  const auto high = [&](const QString& of, double size, bool bold) {
    return of.isEmpty() ? 0.0 : capHeight(theme_, size, bold);
  };
  const double freq = high(view_.frequency, type_size::kFrequency, true);
  const double kind = high(view_.kind, type_size::kKind, false);
  // A sentence without a frequency above it may take two lines.
  const QFontMetricsF valueMetrics(theme_.font(type_size::kValue));
  const bool twoLines = view_.frequency.isEmpty() && valueMetrics.horizontalAdvance(view_.detail) > room;
  // An alarm says in one line how it goes and for how long.
  const bool one = kind > 0.0 && !view_.detail.isEmpty() && !view_.marked.isEmpty();
  const QString last = one ? view_.detail + QStringLiteral(" · ") + view_.marked : view_.marked;
  const double detail = one        ? 0.0
                        : twoLines ? 2.0 * valueMetrics.lineSpacing()
                                   : high(view_.detail, type_size::kValue, false);
  const double marked = high(last, type_size::kValue, false);
  const double letters = shape + freq + kind + detail + marked;
  const std::array rows{freq, kind, detail, marked};
  const auto gaps = static_cast<double>(std::count_if(rows.begin(), rows.end(), [](double row) { return row > 0.0; }));
  const double gap = std::clamp((height() - letters - theme_.px(2 * kLeastPad)) / std::max(gaps, 1.0),
                                static_cast<double>(theme_.px(kLeastGap)), static_cast<double>(theme_.px(kGap)));
  double y = (height() - letters - gap * gaps) / 2.0;

  drawVerdictShape(p, QRectF(pad, y, shape, shape), view_.shape, theme_, front, theme_.back(view_.tone));
  const double wordLeft = pad + shape + theme_.px(20);
  text.centred(
      QRectF(wordLeft, y, width() - pad - wordLeft, shape), view_.word,
      {type_size::kVerdict, true, view_.tone == Tone::Faint ? theme_.colors.secondary : front, Qt::AlignLeft, 0.65});
  if (!view_.caption.isEmpty()) {
    text.centred(QRectF(pad, theme_.px(6), room, theme_.px(26)), view_.caption,
                 {type_size::kLabel, true, second, Qt::AlignLeft, 0.8});
  }
  y += shape;
  if (freq > 0.0)
    y = text.line(pad, y + gap, room, view_.frequency, {type_size::kFrequency, true, front, Qt::AlignLeft, 0.8});
  if (kind > 0.0) y = text.line(pad, y + gap, room, view_.kind, {type_size::kKind, false, front, Qt::AlignLeft, 0.8});
  const TextStyle detailStyle{type_size::kValue, false, alarm ? front : theme_.colors.text, Qt::AlignLeft, 0.7};
  if (twoLines) {
    y += theme_.px(kLeastGap);
    text.block(QRectF(pad, y, room, detail), view_.detail, detailStyle);
    y += detail;
  } else if (detail > 0.0) {
    y = text.line(pad, y + gap, room, view_.detail, detailStyle);
  }
  text.line(pad, y + gap, room, last, {type_size::kValue, false, second, Qt::AlignLeft, 0.7});
  clipped_ = text.clipped();
}

}  // namespace stillcut::ui
