// What happened as a list to read and to search: the newest first, each with its time of day. GUI thread.
#pragma once

#include <QAbstractListModel>
#include <functional>
#include <optional>
#include <vector>

#include "ui/models/alarm_marks.h"
#include "ui/models/history/event_log.h"

namespace stillcut::ui {

// The beginning of an alarm, which the operator may judge.
inline bool isAlarm(const RunEvent& event) {
  return event.what == RunEvent::What::Event && event.reason.code == ReasonCode::ChatterBegan;
}

class EventListModel : public QAbstractListModel {
  Q_OBJECT
 public:
  using QAbstractListModel::QAbstractListModel;
  // `wallMs`: the clock on the wall at a time of the events. Only rows that differ are changed, so that selection and
  // place in the list stay while events come. `marks` may be null: what was said of the alarms.
  void show(const std::vector<RunEvent>& events, const std::function<qint64(Instant)>& wallMs, UnitSystem units,
            const AlarmMarks* marks = nullptr);
  const RunEvent& eventAt(int row) const { return at(row).event; }
  // The row nearest to a time of day, "13:58" or "13:58:04"; none: it is no time, or there are no rows.
  std::optional<int> nearestTo(const QString& timeOfDay) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

 private:
  struct Row {
    RunEvent event;
    QString text;
    qint64 wallMs = 0;
  };
  const Row& at(int row) const { return rows_[rows_.size() - 1 - static_cast<std::size_t>(row)]; }
  void dropOldest(const std::vector<Row>& rows);

  std::vector<Row> rows_;  // oldest first
};

}  // namespace stillcut::ui
