// What can be replayed: the recordings of a folder, or simulated cuts; found by what is typed, ordered by job, tool or
// time, opened by touch or key. In their place the history: what they come to by job, tool or day; a touch on one of
// these shows its recordings. GUI thread.
#pragma once

#include <QWidget>

#include "ui/base/themed.h"
#include "ui/models/history/session_history.h"
#include "ui/models/session_models.h"

class QHBoxLayout;
class QLineEdit;
class QListView;

namespace stillcut::ui {

class TextLabel;
class TouchButton;

class SessionList : public QWidget, public Themed {
  Q_OBJECT
 public:
  // `desk` may be null: the list stays empty and says so. It outlives the widget.
  explicit SessionList(SessionController* controller, QWidget* parent = nullptr);

  void refresh();
  void applyTheme(const Theme& theme) override;

 protected:
  void showEvent(QShowEvent* event) override;  // somebody looks: what was recorded since is listed
  void resizeEvent(QResizeEvent* event) override;

 private:
  void makeHistory();
  void orderBy(SessionOrder::By by);
  void showSimulated(bool simulated);
  void lookInsideShown();
  void showHistory(bool history);
  void refreshHistory();
  void sayWhatIsMissing();

  SessionController* controller_;
  SessionListModel sessions_;
  SessionOrder order_;
  SessionOrder::By by_ = SessionOrder::Time;
  HistoryModel groups_;
  QSortFilterProxyModel foundGroups_;
  QLineEdit *filter_, *folder_;
  QHBoxLayout *kinds_, *orders_, *ends_;
  TouchButton *recorded_, *simulated_, *byJob_, *byTool_, *byTime_, *history_;
  QListView *list_, *historyList_;
  TextLabel* empty_;
};

}  // namespace stillcut::ui
