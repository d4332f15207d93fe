#include "ui/pages/event_panel.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QListView>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/pages/tool_button.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/wrapped_list.h"

namespace stillcut::ui {

EventPanel::EventPanel(const QString& name, QWidget* parent)
    : Panel(parent),
      find_(new QLineEdit),
      list_(new QListView),
      none_(new TextLabel({type_size::kBody, false, true, true})),
      judgements_(new QHBoxLayout),
      wasTrue_(toolButton(tr("WAS CHATTER"), tr("The chosen alarm was chatter"), "")),
      wasFalse_(toolButton(tr("FALSE ALARM"), tr("The chosen alarm was no chatter"), "")) {
  auto* column = new QVBoxLayout(this);
  find_->setObjectName(name + QStringLiteral("-find"));
  find_->setPlaceholderText(tr("What happened at 13:58, or a word"));
  find_->setAccessibleName(tr("Search the events by time of day or by a word"));
  list_->setObjectName(name);
  list_->setAccessibleName(tr("What happened"));
  found_.setSourceModel(&model_);
  found_.setFilterCaseSensitivity(Qt::CaseInsensitive);
  list_->setModel(&found_);
  showWrapped(*list_);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setResizeMode(QListView::Adjust);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(find_);
  column->addWidget(list_, 1);
  column->addWidget(none_);
  wasTrue_->setObjectName(name + QStringLiteral("-was-true"));
  wasFalse_->setObjectName(name + QStringLiteral("-was-false"));
  for (TouchButton* button : {wasTrue_, wasFalse_}) {
    button->setCheckable(true);
    button->hide();
    judgements_->addWidget(button);
  }
  column->addLayout(judgements_);
  connect(wasTrue_, &TouchButton::clicked, this, [this] { judge(AlarmJudgement::Chatter); });
  connect(wasFalse_, &TouchButton::clicked, this, [this] { judge(AlarmJudgement::False); });
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, &EventPanel::showJudgement);
  none_->setText(tr("Nothing has happened yet"));
  connect(find_, &QLineEdit::textChanged, this, &EventPanel::search);
  const auto go = [this](const QModelIndex& index) {
    if (index.isValid()) emit wentTo(model_.eventAt(found_.mapToSource(index).row()).time);
  };
  connect(list_, &QListView::clicked, this, go);
  connect(list_, &QListView::activated, this, go);
}

// Where nothing happened at the time that was asked for, what happened next to it.
void EventPanel::search() {
  const QString asked = find_->text().trimmed();
  found_.setFilterFixedString(asked);
  nearestShown_ = false;
  none_->setText(model_.rowCount() == 0 ? tr("Nothing has happened yet") : tr("Nothing like that"));
  if (const auto nearest = found_.rowCount() == 0 ? model_.nearestTo(asked) : std::nullopt) {
    nearestShown_ = true;
    found_.setFilterFixedString({});
    const QModelIndex there = found_.mapFromSource(model_.index(*nearest));
    list_->setCurrentIndex(there);
    list_->scrollTo(there, QAbstractItemView::PositionAtCenter);
    none_->setText(tr("Nothing at %1. The nearest is chosen").arg(asked));
    return none_->setVisible(true);
  }
  none_->setVisible(found_.rowCount() == 0);
}

const RunEvent* EventPanel::chosenAlarm() const {
  const QModelIndex chosen = list_->currentIndex();
  if (!chosen.isValid()) return nullptr;
  const RunEvent& event = model_.eventAt(found_.mapToSource(chosen).row());
  return isAlarm(event) ? &event : nullptr;
}

// The same touch again takes the mark back, the other one takes its place.
void EventPanel::judge(AlarmJudgement touched) {
  const RunEvent* alarm = chosenAlarm();
  if (alarm != nullptr && marks_ != nullptr) emit judged(judgeAlarm(alarm->time, touched, marks_->of(alarm->time)));
  showJudgement();
}

void EventPanel::setJudging(bool may) {
  if (may == mayJudge_) return;
  mayJudge_ = may;
  showJudgement();
}

void EventPanel::showJudgement() {
  const RunEvent* alarm = marks_ != nullptr ? chosenAlarm() : nullptr;
  const AlarmJudgement stands = alarm != nullptr ? marks_->of(alarm->time) : AlarmJudgement::None;
  for (TouchButton* button : {wasTrue_, wasFalse_}) {
    button->setVisible(marks_ != nullptr);
    button->setEnabled(alarm != nullptr && mayJudge_);
  }
  wasTrue_->setChecked(stands == AlarmJudgement::Chatter);
  wasFalse_->setChecked(stands == AlarmJudgement::False);
}

void EventPanel::display(const std::vector<RunEvent>& events, const std::function<qint64(Instant)>& wallMs,
                         UnitSystem units, const AlarmMarks* marks) {
  // Whoever has scrolled away from the newest event goes on reading where he is.
  const bool reading = list_->verticalScrollBar()->value() > 0;
  const QPersistentModelIndex top = reading ? list_->indexAt({list_->width() / 2, 1}) : QModelIndex();
  const int place = top.isValid() ? list_->visualRect(top).top() : 0;
  marks_ = marks;
  model_.show(events, wallMs, units, marks);
  showJudgement();
  if (top.isValid()) {
    list_->doItemsLayout();
    list_->verticalScrollBar()->setValue(list_->verticalScrollBar()->value() + list_->visualRect(top).top() - place);
  }
  if (nearestShown_ && !events.empty()) return;  // and says so
  none_->setText(events.empty() ? tr("Nothing has happened yet") : tr("Nothing like that"));
  none_->setVisible(found_.rowCount() == 0);
}

void EventPanel::applyTheme(const Theme& theme) {
  Panel::applyTheme(theme);
  layout()->setContentsMargins(theme.px(10), theme.px(8), theme.px(10), theme.px(8));
  layout()->setSpacing(theme.px(8));
  judgements_->setSpacing(std::max(theme.px(12), pixelsFor(kTouchGapMm, this)));
  find_->setFont(theme.font(type_size::kBody));
  find_->setFixedHeight(touchHeight(theme, this, 48));
  list_->setFont(theme.font(type_size::kBody));
}

}  // namespace stillcut::ui
