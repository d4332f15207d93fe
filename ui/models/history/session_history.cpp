#include "ui/models/history/session_history.h"

#include <QDateTime>
#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

constexpr double kHour = 3600.0;

QString nameOf(const SessionEntry& entry, SessionOrder::By by) {
  switch (by) {
    case SessionOrder::Job:
      return entry.job;
    case SessionOrder::Tool:
      return entry.tool;
    case SessionOrder::Time:
      break;
  }
  return QDateTime::fromMSecsSinceEpoch(entry.beganMs()).toString(QStringLiteral("yyyy-MM-dd"));
}

}  // namespace

double HistoryGroup::alarmsPerHour() const {
  return recorded.value > 0.0 ? alarms * kHour / recorded.value : std::numeric_limits<double>::quiet_NaN();
}

std::vector<HistoryGroup> historyOf(const std::vector<SessionEntry>& entries, SessionOrder::By by) {
  std::map<QString, HistoryGroup> groups;
  for (const SessionEntry& entry : entries) {
    if (entry.inside != SessionEntry::Inside::Known) continue;
    HistoryGroup& group = groups[nameOf(entry, by)];
    ++group.recordings;
    group.alarms += entry.alarms;
    group.recorded += entry.length;
    group.alarmed += entry.alarmed;
  }
  std::vector<HistoryGroup> out;
  out.reserve(groups.size());
  for (auto& [name, group] : groups) {
    group.name = name;
    out.push_back(std::move(group));
  }
  if (by == SessionOrder::Time) {
    std::ranges::reverse(out);
  } else {
    std::ranges::stable_sort(out, std::greater(), &HistoryGroup::alarmed);
  }
  return out;
}

QString historyText(const HistoryGroup& group) {
  const QString recorded = say("recordings: %1, %2").arg(group.recordings).arg(duration(group.recorded));
  const QString alarms = say("alarms: %1").arg(group.alarms);
  if (group.alarms == 0) return QStringLiteral("%1\n%2").arg(recorded, alarms);
  return QStringLiteral("%1\n%2").arg(
      recorded,
      say("%1, %2 an hour, %3 long").arg(alarms, significant(group.alarmsPerHour()), duration(group.alarmed)));
}

void HistoryModel::show(std::vector<HistoryGroup> groups) {
  if (groups == groups_) return;
  const bool sameNames = std::ranges::equal(groups, groups_, {}, &HistoryGroup::name, &HistoryGroup::name);
  if (!sameNames) beginResetModel();
  groups_ = std::move(groups);
  if (sameNames) {
    emit dataChanged(index(0), index(rowCount() - 1));
  } else {
    endResetModel();
  }
}

int HistoryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(groups_.size());
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const HistoryGroup& group = groups_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      return QStringLiteral("%1\n%2").arg(group.name, historyText(group));
    case NameRole:
      return group.name;
    default:
      return {};
  }
}

}  // namespace stillcut::ui
