#include "ui/pages/intervention_list.h"

#include <QPainter>
#include <algorithm>

#include "ui/widgets/intervention_card.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

constexpr double kPad = 16;
constexpr double kHead = 30;
constexpr double kFault = 76;

}  // namespace

InterventionList::InterventionList(QWidget* parent)
    : QWidget(parent),
      theme_(makeTheme(ThemeKind::Light, 1.0)),
      wasTrue_(new TouchButton(tr("WAS CHATTER"), TouchButton::Look::Plain, this)),
      wasFalse_(new TouchButton(tr("FALSE ALARM"), TouchButton::Look::Plain, this)),
      hear_(new TouchButton(tr("MISSED CHATTER"), TouchButton::Look::Plain, this)) {
  setAccessibleName(tr("Last interventions"));
  wasTrue_->setObjectName(QStringLiteral("was-true"));
  wasFalse_->setObjectName(QStringLiteral("was-false"));
  wasTrue_->setKey(Qt::Key_F9);
  wasFalse_->setKey(Qt::Key_F10);
  hear_->setObjectName(QStringLiteral("hear"));
  hear_->setKey(Qt::Key_F8);
  hear_->setToolTip(tr("Marks chatter now that no alarm told of; another touch takes the mark back"));
  for (TouchButton* button : {wasTrue_, wasFalse_, hear_}) {
    button->setCheckable(true);
    button->setEnabled(false);
    button->setBaseHeight(44);
  }
  connect(hear_, &TouchButton::clicked, this, &InterventionList::hear);
  connect(wasTrue_, &TouchButton::clicked, this, [this] { judge(AlarmJudgement::Chatter); });
  connect(wasFalse_, &TouchButton::clicked, this, [this] { judge(AlarmJudgement::False); });
  for (int k = 0; k < kInterventionsShown; ++k) widgets_.push_back(new InterventionCard(this));
}

void InterventionList::display(const std::vector<CardView>& cards, const NewestAlarm& newest, const EventLine& event,
                               bool live, bool alarming, bool answerable) {
  if (cards == cards_ && newest == newest_ && event == event_ && live == live_ && alarming == alarming_ &&
      answerable == answerable_) {
    return;
  }
  cards_ = cards;
  newest_ = newest;
  event_ = event;
  // Stays pressed until the alarm comes or another picture does: that is what the touch asked for.
  if (alarming != alarming_ || live != live_) heard_ = false;
  live_ = live;
  alarming_ = alarming;
  answerable_ = answerable;
  hear_->setEnabled(live && !alarming && answerable);
  for (std::size_t k = 0; k < widgets_.size() && k < cards.size(); ++k) widgets_[k]->display(cards[k]);
  showJudgement();
  place();
  update();
}

// The same touch again takes the mark back, the other one takes its place: an alarm is counted once.
void InterventionList::judge(AlarmJudgement touched) {
  emit asked(judgeAlarm(newest_.began, touched, newest_.judged));
  newest_.judged = touched == newest_.judged ? AlarmJudgement::None : touched;
  showJudgement();
}

void InterventionList::hear() {
  emit asked({heard_ ? OperatorAction::UndoMark : OperatorAction::ReportChatter, Authority::Off});
  heard_ = !heard_;
  showJudgement();
}

void InterventionList::showJudgement() {
  const bool judgeable = answerable_ && (alarming_ || newest_.count > 0);
  wasTrue_->setEnabled(judgeable);
  wasFalse_->setEnabled(judgeable);
  wasTrue_->setChecked(newest_.judged == AlarmJudgement::Chatter);
  wasFalse_->setChecked(newest_.judged == AlarmJudgement::False);
  hear_->setChecked(heard_);
  // Which alarm is meant, by its time; and how to take the mark back.
  const QString meant = newest_.time.isEmpty() || !judgeable ? QString() : QStringLiteral(", ") + newest_.time;
  const auto hint = [&](bool marked, const QString& key) { return marked ? tr("%1 undoes it").arg(key) : key; };
  wasTrue_->setHint(hint(newest_.judged == AlarmJudgement::Chatter, QStringLiteral("F9")) + meant);
  wasFalse_->setHint(hint(newest_.judged == AlarmJudgement::False, QStringLiteral("F10")) + meant);
  hear_->setHint(hint(heard_, QStringLiteral("F8")));
}

int InterventionList::shownCards() const {
  return static_cast<int>(
      std::count_if(widgets_.begin(), widgets_.end(), [](const QWidget* w) { return !w->isHidden(); }));
}

void InterventionList::applyTheme(const Theme& theme) {
  theme_ = theme;
  updateGeometry();
  place();
  update();
}

QSize InterventionList::minimumSizeHint() const {
  const int gap = std::max(theme_.px(12), pixelsFor(kTouchGapMm, this));
  const int buttons = wasTrue_->sizeHint().height() * 3 + 2 * gap;
  return {theme_.px(420),
          std::max(buttons + theme_.px(2 * 8),
                   theme_.px(kHead + 12) + widgets_[0]->sizeHint().height() + widgets_[1]->sizeHint().height())};
}

QSize InterventionList::sizeHint() const {
  return {theme_.px(640), minimumSizeHint().height()};
}

void InterventionList::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place();
}

void InterventionList::place() {
  const int pad = theme_.px(kPad), gap = std::max(theme_.px(12), pixelsFor(kTouchGapMm, this));
  const int high = wasTrue_->sizeHint().height();
  const int buttonWidth =
      std::max({wasTrue_->sizeHint().width(), wasFalse_->sizeHint().width(), hear_->sizeHint().width()});
  const int left = width() - pad - buttonWidth;
  const int top = std::max((height() - 3 * high - 2 * gap) / 2, theme_.px(6));
  wasTrue_->setGeometry(left, top, buttonWidth, high);
  wasFalse_->setGeometry(left, top + high + gap, buttonWidth, high);
  hear_->setGeometry(left, top + 2 * (high + gap), buttonWidth, high);
  int y = theme_.px(faulty() ? kFault + kPad / 2 + 4 : kHead);
  for (std::size_t k = 0; k < widgets_.size(); ++k) {
    const int cardHeight = widgets_[k]->sizeHint().height();
    const bool fits = k < cards_.size() && y + cardHeight <= height() - theme_.px(6);
    widgets_[k]->setVisible(fits);
    widgets_[k]->setGeometry(pad, y, left - gap - pad, cardHeight);
    y += cardHeight;
  }
}

void InterventionList::paintEvent(QPaintEvent*) {
  QPainter p(this);
  drawPanel(p, rect(), theme_, theme_.colors.panel);
  TextPainter text(p, theme_);
  const double pad = theme_.px(kPad), room = wasTrue_->x() - 2 * pad;
  if (faulty()) return paintFault(p, QRectF(pad, pad / 2, room, theme_.px(kFault)));
  // What is only worth a look takes the place of the title: the cards explain themselves.
  const bool plain = event_.text.isEmpty();
  text.centred(QRectF(pad, theme_.px(4), room, theme_.px(kHead - 4)), plain ? tr("LAST INTERVENTIONS") : event_.text,
               {type_size::kLabel, true, plain ? theme_.colors.secondary : theme_.onPanel(event_.tone)});
  clipped_ = text.clipped();
  if (!cards_.empty()) return;
  text.centred(QRectF(pad, theme_.px(kHead), room, height() - 2 * theme_.px(kHead)), tr("None in this run"),
               {type_size::kBody, false, theme_.colors.faint});
}

// A fault takes the place of the older cards, in letters for the operator who stands at the machine.
void InterventionList::paintFault(QPainter& p, const QRectF& box) {
  drawPanel(p, box, theme_, theme_.back(event_.tone));
  TextPainter text(p, theme_);
  const double pad = theme_.px(kPad);
  text.block(box.adjusted(pad, pad / 4, -pad, -pad / 4), event_.text,
             {type_size::kFault, true, theme_.front(event_.tone), Qt::AlignLeft, 0.4});
  clipped_ = text.clipped();
}

}  // namespace stillcut::ui
