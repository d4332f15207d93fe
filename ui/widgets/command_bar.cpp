#include "ui/widgets/command_bar.h"

#include <QPainter>
#include <algorithm>

#include "ui/widgets/painting.h"
#include "ui/widgets/touch_button.h"
#include "ui/widgets/verdict_shape.h"

namespace stillcut::ui {
namespace {

constexpr qint64 kAskForMs = 5000;
const QString kBackKey = QStringLiteral("Backspace");
// Touches closer than this to the one before are a bouncing finger or a key that is held down: a keyboard repeats after
// 660 ms at most by its defaults, and then 25 times a second, not always marked as repeats.
constexpr qint64 kDeliberateAfterMs = 1000;

}  // namespace

CommandBar::CommandBar(QWidget* parent)
    : QWidget(parent),
      theme_(makeTheme(ThemeKind::Light, 1.0)),
      authority_{new TouchButton(tr("OFF"), TouchButton::Look::Plain, this),
                 new TouchButton(tr("ADVISE"), TouchButton::Look::Plain, this),
                 new TouchButton(tr("AUTO"), TouchButton::Look::Plain, this)},
      hold_(new TouchButton(tr("HOLD"), TouchButton::Look::Plain, this)),
      back_(new TouchButton(tr("BACK TO 100 %"), TouchButton::Look::Plain, this)),
      accept_(new TouchButton(tr("ACCEPT"), TouchButton::Look::Advice, this)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Authority"));
  const std::array<Qt::Key, 3> keys{Qt::Key_F2, Qt::Key_F3, Qt::Key_F4};
  const std::array<QString, 3> names{QStringLiteral("off"), QStringLiteral("advise"), QStringLiteral("auto")};
  for (std::size_t k = 0; k < authority_.size(); ++k) {
    authority_[k]->setObjectName(names[k]);
    authority_[k]->setKey(keys[k]);
    authority_[k]->setCheckable(true);
    connect(authority_[k], &TouchButton::clicked, this, [this, k] { touchAuthority(static_cast<Authority>(k)); });
  }
  authority_[2]->setCheckedTone(Tone::Advice);
  hold_->setObjectName(QStringLiteral("hold"));
  hold_->setKey(Qt::Key_F7);
  hold_->setCheckable(true);
  connect(hold_, &TouchButton::clicked, this, [this] {
    const bool wasHeld = view_.held;
    emit asked({wasHeld ? OperatorAction::EndHold : OperatorAction::Hold, view_.authority});
    showButtons();
  });
  back_->setObjectName(QStringLiteral("back"));
  back_->setKey(Qt::Key_Backspace);
  connect(back_, &TouchButton::clicked, this, [this] {
    withdrawQuestion();
    emit asked({OperatorAction::BackToProgrammed, Authority::Off});
  });
  accept_->setObjectName(QStringLiteral("accept-here"));
  accept_->setKey(Qt::Key_F5);
  connect(accept_, &TouchButton::clicked, this, [this] {
    emit asked({OperatorAction::Accept, Authority::Off, view_.adviceNumber});
  });
  for (TouchButton* button : {authority_[0], authority_[1], authority_[2], hold_, back_, accept_})
    button->setBaseHeight(66);
  showButtons();
}

void CommandBar::display(const CommandView& view, qint64 nowMs) {
  nowMs_ = nowMs;
  if (askedMs_ >= 0 && nowMs - askedMs_ > kAskForMs) withdrawQuestion();
  if (view == view_) return;
  view_ = view;
  if (view.authority == Authority::Auto || !view.autoAllowed) withdrawQuestion();
  setAccessibleDescription(view.inCommand + u' ' + view.since + u' ' + view.verdict.spoken());
  showButtons();
  update();
}

// What the buttons show is what the session says, never what was touched last.
void CommandBar::showButtons() {
  for (std::size_t k = 0; k < authority_.size(); ++k)
    authority_[k]->setChecked(view_.authority == static_cast<Authority>(k));
  authority_[1]->setEnabled(view_.machine && !view_.over);
  hold_->setEnabled(view_.machine && !view_.over);
  authority_[1]->setToolTip(view_.over      ? tr("The run is over: there is nothing to advise on")
                            : view_.machine ? QString()
                                            : tr("No machine link: the advice is for your hand"));
  authority_[2]->setEnabled(view_.machine && (view_.autoAllowed || view_.authority == Authority::Auto));
  authority_[2]->setToolTip(!view_.machine      ? tr("No machine link: there is nothing to move")
                            : view_.autoAllowed ? QString()
                                                : tr("This profile does not grant Auto"));
  // Said before it is chosen: where this program and its keeper die there, the overrides stay where they are.
  authority_[2]->setHint(view_.machine && view_.autoNeedsSecondTouch ? tr("F4, no watchdog") : QStringLiteral("F4"));
  hold_->setChecked(view_.held);
  hold_->setText(view_.held ? tr("END HOLD") : tr("HOLD"));
  accept_->setVisible(tellsVerdict_ && !view_.advice.isEmpty());
  accept_->setHint(QStringLiteral("F5, %1").arg(view_.advice));
  back_->setHint(view_.moved.isEmpty() ? kBackKey : tr("%1, now %2").arg(kBackKey, view_.moved));
}

void CommandBar::setTellsVerdict(bool tells) {
  if (tells == tellsVerdict_) return;
  tellsVerdict_ = tells;
  showButtons();
  update();
}

void CommandBar::touchAuthority(Authority authority) {
  if (authority == Authority::Auto) {
    touchAuto();
  } else {
    withdrawQuestion();
    // Off is sent whatever is shown: the picture may be older than the machine.
    if (authority == Authority::Off || authority != view_.authority)
      emit asked({OperatorAction::SetAuthority, authority});
  }
  showButtons();
}

// A machine that cannot bring 100 % back by itself gets Auto only by a deliberate second touch.
void CommandBar::touchAuto() {
  if (view_.authority == Authority::Auto) return;
  const bool deliberate = askedMs_ >= 0 && nowMs_ - touchedMs_ >= kDeliberateAfterMs;
  touchedMs_ = nowMs_;
  if (view_.autoNeedsSecondTouch && !deliberate) {
    if (askedMs_ < 0) askedMs_ = nowMs_;
    authority_[2]->setAsking(true, tr("AUTO?"), tr("touch again to confirm"));
    update();
    return;
  }
  withdrawQuestion();
  emit asked({OperatorAction::SetAuthority, Authority::Auto});
}

bool CommandBar::withdrawAsked() {
  const bool asking = askedMs_ >= 0;
  withdrawQuestion();
  return asking;
}

void CommandBar::withdrawQuestion() {
  askedMs_ = -1;
  authority_[2]->setAsking(false);
  update();
}

void CommandBar::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  placeButtons();
  update();
}

QSize CommandBar::sizeHint() const {
  return {theme_.px(1000), back_->sizeHint().height() + theme_.px(24)};
}

void CommandBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeButtons();
}

void CommandBar::placeButtons() {
  const int pad = theme_.px(16), gap = std::max(theme_.px(12), pixelsFor(kTouchGapMm, this));
  const int high = back_->sizeHint().height(), top = (height() - high) / 2;
  int x = pad;
  for (TouchButton* button : authority_) {
    button->setGeometry(x, top, theme_.px(146), high);
    x += theme_.px(146) + gap;
  }
  const int backWidth = theme_.px(232), holdWidth = theme_.px(146);
  back_->setGeometry(width() - pad - backWidth, top, backWidth, high);
  hold_->setGeometry(width() - pad - backWidth - gap - holdWidth, top, holdWidth, high);
  accept_->setGeometry(hold_->x() - gap - holdWidth, top, holdWidth, high);
}

void CommandBar::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setPen(theme_.colors.border);
  p.drawLine(0, 0, width(), 0);
  TextPainter text(p, theme_);
  const double left = authority_[2]->geometry().right() + theme_.px(22);
  const double room = (accept_->isHidden() ? hold_ : accept_)->x() - theme_.px(14) - left;
  const bool asking = askedMs_ >= 0;
  const QString first = asking ? tr("This machine has no watchdog") : view_.inCommand;
  const QString dies =
      view_.kept ? tr("cable out or keeper dead: they stay") : tr("if Stillcut dies, its overrides stay");
  const QString second = asking ? dies : view_.since;
  const QColor color = asking             ? theme_.colors.onsetText
                       : view_.notYetBack ? theme_.colors.chatterText
                                          : theme_.colors.text;
  const double half = height() / 2.0, high = theme_.px(28);
  if (tellsVerdict_ && !asking) {
    paintVerdict(text, p, QRectF(left, half - high, room, high));
    text.centred(
        QRectF(left, half, room, high), first,
        {type_size::kLabel, view_.notYetBack, view_.notYetBack ? color : theme_.colors.secondary, Qt::AlignLeft, 0.7});
    clipped_ = text.clipped();
    return;
  }
  text.centred(QRectF(left, half - high, room, high), first, {type_size::kBody, true, color, Qt::AlignLeft, 0.8});
  text.centred(QRectF(left, half, room, high), second,
               {type_size::kBody, false, theme_.colors.secondary, Qt::AlignLeft, 0.8});
  clipped_ = text.clipped();
}

void CommandBar::paintVerdict(TextPainter& text, QPainter& p, const QRectF& box) const {
  const VerdictView& verdict = view_.verdict;
  const double side = box.height() * 0.8;
  p.setRenderHint(QPainter::Antialiasing);
  drawVerdictShape(p, QRectF(box.left(), box.center().y() - side / 2.0, side, side), verdict.shape, theme_,
                   theme_.onPanel(verdict.tone), theme_.colors.window);
  const QString words =
      verdict.frequency.isEmpty() ? verdict.word : verdict.word + QStringLiteral("  ") + verdict.frequency;
  text.centred(box.adjusted(side + theme_.px(8), 0, 0, 0), words,
               {type_size::kButton, true, theme_.onPanel(verdict.tone), Qt::AlignLeft, 0.6});
}

}  // namespace stillcut::ui
