// "What happened?": the events of a run or a recording as sentences with their time of day, searched by typing a time
// ("13:58") or a word; where nothing happened at that time, the nearest is chosen. A touch on one asks to go there, and
// any alarm of a run can be judged. GUI thread.
#pragma once

#include <QSortFilterProxyModel>

#include "ui/models/history/event_list_model.h"
#include "ui/widgets/panel.h"

class QHBoxLayout;
class QLineEdit;
class QListView;

namespace stillcut::ui {

class TextLabel;
class TouchButton;

class EventPanel : public Panel {
  Q_OBJECT
 public:
  // `name`: what tests find the list by, with "-find" its field.
  explicit EventPanel(const QString& name, QWidget* parent = nullptr);

  // `marks` null: there is nothing to judge.
  void display(const std::vector<RunEvent>& events, const std::function<qint64(Instant)>& wallMs, UnitSystem units,
               const AlarmMarks* marks = nullptr);
  // False: no touch reaches the recording any more.
  void setJudging(bool may);
  void applyTheme(const Theme& theme) override;

 signals:
  void wentTo(Instant time);
  void judged(const stillcut::OperatorInput& input);

 private:
  void search();
  void judge(AlarmJudgement touched);
  void showJudgement();
  const RunEvent* chosenAlarm() const;

  EventListModel model_;
  bool nearestShown_ = false;  // of the time of day that is asked for
  QSortFilterProxyModel found_;
  QLineEdit* find_;
  QListView* list_;
  TextLabel* none_;
  QHBoxLayout* judgements_;
  TouchButton *wasTrue_, *wasFalse_;
  const AlarmMarks* marks_ = nullptr;
  bool mayJudge_ = true;
};

}  // namespace stillcut::ui
