// The recordings of a folder and the markers of one as lists. GUI thread.
#pragma once

#include <QAbstractListModel>
#include <QSortFilterProxyModel>

#include "ui/facade/session_controller.h"

namespace stillcut::ui {

class SessionListModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role { PathRole = Qt::UserRole, JobRole, ToolRole, TimeRole };
  using QAbstractListModel::QAbstractListModel;
  void show(const std::vector<SessionEntry>& entries);
  const SessionEntry& entry(int row) const { return entries_[static_cast<std::size_t>(row)]; }
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

 private:
  std::vector<SessionEntry> entries_;
};

// By job, tool or time (newest first), and those that contain what was typed.
class SessionOrder : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  enum By { Job, Tool, Time };
  explicit SessionOrder(QObject* parent = nullptr);
  void orderBy(By by);

 protected:
  bool lessThan(const QModelIndex& a, const QModelIndex& b) const override;

 private:
  By by_ = Time;
};

class MarkerModel : public QAbstractListModel {
  Q_OBJECT
 public:
  using QAbstractListModel::QAbstractListModel;
  void show(const SessionController& controller);
  const Marker* marker(int row) const;
  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

 private:
  std::vector<Marker> markers_;
  std::vector<Seconds> times_;
};

QString markerText(const std::string& label);  // "true alarm"
QString timeText(Seconds time);                // "0:12.35"

}  // namespace stillcut::ui
