// History over days: what the recordings of a folder come to by day, by tool and by job, from what the list has looked
// up inside each. GUI thread, pure functions but for the list.
#pragma once

#include <QAbstractListModel>
#include <vector>

#include "ui/facade/session_controller.h"
#include "ui/models/session_models.h"

namespace stillcut::ui {

struct HistoryGroup {
  QString name;  // "2026-11-27", a tool, a job
  int recordings = 0, alarms = 0;
  Seconds recorded{}, alarmed{};  // length of the recordings; of which in onset or chatter
  bool operator==(const HistoryGroup&) const = default;

  double alarmsPerHour() const;  // of recording; not a number: nothing was recorded
};

// Only recordings whose inside is known count. Days newest first; tools and jobs by their time in alarm, most first.
std::vector<HistoryGroup> historyOf(const std::vector<SessionEntry>& entries, SessionOrder::By by);
// "recordings: 5, 1 h 20 min" and below it "alarms: 12, 9 an hour, 45 s long".
QString historyText(const HistoryGroup& group);

class HistoryModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role { NameRole = Qt::UserRole };
  using QAbstractListModel::QAbstractListModel;
  void show(std::vector<HistoryGroup> groups);
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

 private:
  std::vector<HistoryGroup> groups_;
};

}  // namespace stillcut::ui
