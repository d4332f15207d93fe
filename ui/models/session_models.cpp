#include "ui/models/session_models.h"

#include <QDateTime>
#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {

QString markerText(const std::string& label) {
  if (label == kLabelTrueAlarm) return say("true alarm");
  if (label == kLabelFalseAlarm) return say("false alarm");
  if (label == kLabelOperatorChatter) return say("heard");
  if (label == kLabelNote) return say("note");
  return QString::fromStdString(label);
}

QString timeText(Seconds time) {
  const double t = std::max(time.value, 0.0);
  const auto minutes = static_cast<int>(t / 60.0);
  return QStringLiteral("%1:%2").arg(minutes).arg(t - 60.0 * minutes, 5, 'f', 2, u'0');
}

void SessionListModel::show(const std::vector<SessionEntry>& entries) {
  if (entries == entries_) return;
  const auto samePath = [](const SessionEntry& a, const SessionEntry& b) { return a.path == b.path; };
  if (std::equal(entries.begin(), entries.end(), entries_.begin(), entries_.end(), samePath)) {
    entries_ = entries;  // only what is known of them: whoever is choosing keeps his place
    emit dataChanged(index(0), index(rowCount() - 1));
    return;
  }
  beginResetModel();
  entries_ = entries;
  endResetModel();
}

int SessionListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

QVariant SessionListModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const SessionEntry& e = entry(index.row());
  const QString when = QDateTime::fromMSecsSinceEpoch(e.beganMs()).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
  const QString size =
      join(number(static_cast<double>(e.bytes) / 1e6, e.bytes < 10'000'000 ? 1 : 0), QStringLiteral("MB"));
  const bool known = e.inside == SessionEntry::Inside::Known;
  const QString inside = known ? tr("%1, markers: %2").arg(duration(e.length)).arg(e.markers) : QString();
  switch (role) {
    case Qt::DisplayRole:
      return QStringLiteral("%1 · %2\n%3 · %4").arg(e.job, e.tool, when, size) + (known ? u'\n' + inside : QString());
    case Qt::AccessibleTextRole:
      return tr("%1, tool %2, of %3").arg(e.job, e.tool, when) + (known ? u' ' + inside : QString());
    case Qt::ToolTipRole:
    case PathRole:
      return e.path;
    case JobRole:
      return e.job;
    case ToolRole:
      return e.tool;
    case TimeRole:
      return e.beganMs();
    default:
      return {};
  }
}

SessionOrder::SessionOrder(QObject* parent) : QSortFilterProxyModel(parent) {
  setFilterCaseSensitivity(Qt::CaseInsensitive);
  setFilterRole(Qt::DisplayRole);
  setDynamicSortFilter(true);
  sort(0);
}

void SessionOrder::orderBy(By by) {
  by_ = by;
  invalidate();
}

bool SessionOrder::lessThan(const QModelIndex& a, const QModelIndex& b) const {
  const auto time = [](const QModelIndex& i) { return i.data(SessionListModel::TimeRole).toLongLong(); };
  if (by_ != Time) {
    const int role = by_ == Job ? SessionListModel::JobRole : SessionListModel::ToolRole;
    const int order = QString::compare(a.data(role).toString(), b.data(role).toString(), Qt::CaseInsensitive);
    if (order != 0) return order < 0;
  }
  return time(a) > time(b);
}

void MarkerModel::show(const SessionController& controller) {
  beginResetModel();
  markers_ = controller.markers();
  times_.clear();
  for (const Marker& marker : markers_) times_.push_back(controller.markerTime(marker));
  endResetModel();
}

const Marker* MarkerModel::marker(int row) const {
  return row >= 0 && row < rowCount() ? &markers_[static_cast<std::size_t>(row)] : nullptr;
}

int MarkerModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(markers_.size());
}

QVariant MarkerModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  if (role != Qt::DisplayRole && role != Qt::AccessibleTextRole) return {};
  const Marker& m = markers_[static_cast<std::size_t>(index.row())];
  QString text =
      QStringLiteral("%1  %2").arg(timeText(times_[static_cast<std::size_t>(index.row())]), markerText(m.label));
  if (m.end > m.begin) text += say(", ") + duration(secondsBetween(m.begin, m.end));
  if (!m.note.empty()) text += QStringLiteral(": ") + QString::fromStdString(m.note);
  return text;
}

}  // namespace stillcut::ui
