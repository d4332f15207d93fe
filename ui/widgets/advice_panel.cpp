#include "ui/widgets/advice_panel.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

#include "ui/widgets/painting.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

constexpr double kPad = 24;

}  // namespace

AdvicePanel::AdvicePanel(QWidget* parent)
    : QWidget(parent),
      theme_(makeTheme(ThemeKind::Light, 1.0)),
      accept_(new TouchButton(tr("ACCEPT"), TouchButton::Look::Advice, this)),
      refuse_(new TouchButton(tr("NOT NOW"), TouchButton::Look::Plain, this)) {
  setAccessibleName(tr("What to do"));
  accept_->setObjectName(QStringLiteral("accept"));
  refuse_->setObjectName(QStringLiteral("refuse"));
  accept_->setKey(Qt::Key_F5);
  refuse_->setKey(Qt::Key_F6);
  accept_->setEnabled(false);
  refuse_->setEnabled(false);
  connect(accept_, &TouchButton::clicked, this, [this] {
    if (view_.mode == AdviceView::Mode::Again) {
      emit againAsked();
    } else {
      emit accepted();
    }
  });
  connect(refuse_, &TouchButton::clicked, this, &AdvicePanel::refused);
}

void AdvicePanel::display(const AdviceView& view) {
  if (view == view_) return;
  view_ = view;
  setAccessibleDescription(view.spoken());
  const bool again = view.mode == AdviceView::Mode::Again;
  accept_->setText(again ? tr("AGAIN") : tr("ACCEPT"));
  accept_->setEnabled(view.canAnswer() || again);
  refuse_->setEnabled(view.canAnswer());
  update();
}

void AdvicePanel::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  placeButtons();
  update();
}

QSize AdvicePanel::minimumSizeHint() const {
  return {theme_.px(420), theme_.px(306)};
}

void AdvicePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeButtons();
}

void AdvicePanel::placeButtons() {
  const int pad = theme_.px(kPad), gap = std::max(theme_.px(16), pixelsFor(kTouchGapMm, this));
  const int each = (width() - 2 * pad - gap) / 2, high = accept_->sizeHint().height();
  const int top = height() - theme_.px(20) - high;
  accept_->setGeometry(pad, top, each, high);
  refuse_->setGeometry(pad + each + gap, top, each, high);
}

void AdvicePanel::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  drawPanel(p, rect(), theme_, theme_.colors.panel);
  TextPainter text(p, theme_);
  const bool idle = view_.mode == AdviceView::Mode::Nothing || view_.mode == AdviceView::Mode::Again;
  const bool grey = idle || view_.mode == AdviceView::Mode::Offered;  // nobody asks for an answer
  const double pad = theme_.px(kPad), inner = width() - 2 * pad;
  const QColor accent = grey ? theme_.colors.secondary : theme_.colors.advice;
  if (!grey) {
    p.setPen(Qt::NoPen);
    p.setBrush(theme_.colors.advice);
    p.drawRoundedRect(QRectF(0, 0, theme_.px(6), height()), theme_.px(3), theme_.px(3));
  }
  double y = text.line(pad, theme_.px(20), inner, view_.title, {type_size::kLabel, true, accent});
  y += theme_.px(20);

  // The target and, on the same line, how far it is from what is programmed.
  const double size = idle ? type_size::kValue * 1.3 : type_size::kTarget;
  const double targetWidth = std::min(inner, QFontMetricsF(theme_.font(size, true)).horizontalAdvance(view_.target));
  const double targetTop = y;
  y = text.line(pad, y, inner, view_.target,
                {size, true, grey ? theme_.colors.secondary : theme_.colors.text, Qt::AlignLeft, 0.6});
  if (!view_.delta.isEmpty()) {
    const double left = pad + targetWidth + theme_.px(20);
    text.centred(QRectF(left, targetTop, width() - pad - left, y - targetTop), view_.delta,
                 {type_size::kValue, false, theme_.colors.secondary, Qt::AlignLeft, 0.75});
  }
  y += theme_.px(14);

  // From below: cost, feed; the reason takes what is left.
  double bottom = (accept_->isHidden() ? height() : accept_->y()) - theme_.px(16);
  const double lineHeight = theme_.px(27);
  for (const QString* lineText : {&view_.cost, &view_.feed}) {
    if (lineText->isEmpty()) continue;
    bottom -= lineHeight;
    text.centred(QRectF(pad, bottom, inner, lineHeight), *lineText,
                 {type_size::kBody, false, theme_.colors.secondary, Qt::AlignLeft, 0.75});
  }
  text.block(QRectF(pad, y, inner, bottom - y), view_.reason,
             {type_size::kBody, false, theme_.colors.text, Qt::AlignLeft, 0.75});
  clipped_ = text.clipped();
}

}  // namespace stillcut::ui
