#include "ui/models/history/event_list_model.h"

#include <QDateTime>
#include <QRegularExpression>
#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

QString judgementText(AlarmJudgement judged) {
  switch (judged) {
    case AlarmJudgement::Chatter:
      return say(", marked: was chatter");
    case AlarmJudgement::False:
      return say(", marked: false alarm");
    case AlarmJudgement::None:
      break;
  }
  return {};
}

}  // namespace

void EventListModel::show(const std::vector<RunEvent>& events, const std::function<qint64(Instant)>& wallMs,
                          UnitSystem units, const AlarmMarks* marks) {
  std::vector<Row> rows;
  rows.reserve(events.size());
  for (const RunEvent& event : events) {
    const qint64 wall = wallMs(event.time);
    QString text = QStringLiteral("%1  %2").arg(clockTime(wall), eventSentence(event, units));
    if (marks != nullptr && isAlarm(event)) text += judgementText(marks->of(event.time));
    rows.push_back({event, text, wall});
  }
  dropOldest(rows);
  const auto sameText = [](const Row& a, const Row& b) { return a.text == b.text; };
  const auto older = std::mismatch(rows_.begin(), rows_.end(), rows.begin(), rows.end(), sameText);
  const auto newer = std::mismatch(rows_.rbegin(), std::make_reverse_iterator(older.first), rows.rbegin(),
                                   std::make_reverse_iterator(older.second), sameText);
  const auto lead = static_cast<int>(newer.first - rows_.rbegin());  // rows on top that stay
  const auto were = static_cast<int>(newer.first.base() - older.first);
  const auto are = static_cast<int>(newer.second.base() - older.second);
  // What is left between them on both sides is the same event told anew, as a move that goes on.
  const int told = std::min(were, are);
  if (are > were) beginInsertRows({}, lead, lead + are - were - 1);
  if (were > are) beginRemoveRows({}, lead, lead + were - are - 1);
  rows_ = std::move(rows);
  if (are > were) endInsertRows();
  if (were > are) endRemoveRows();
  if (told > 0) emit dataChanged(index(lead + are - told), index(lead + are - 1));
}

// The log is of bounded length: its oldest events are gone.
void EventListModel::dropOldest(const std::vector<Row>& rows) {
  if (rows_.empty() || rows.empty()) return;
  const auto first =
      std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.text == rows.front().text; });
  if (first == rows_.begin() || first == rows_.end()) return;
  beginRemoveRows({}, static_cast<int>(rows_.end() - first), rowCount() - 1);
  rows_.erase(rows_.begin(), first);
  endRemoveRows();
}

int EventListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant EventListModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid) || role != Qt::DisplayRole) return {};
  return at(index.row()).text;
}

std::optional<int> EventListModel::nearestTo(const QString& timeOfDay) const {
  static const QRegularExpression kTime(QStringLiteral("^(\\d{1,2}):(\\d{2})(?::(\\d{2}))?$"));
  const auto typed = kTime.match(timeOfDay.trimmed());
  const QTime wanted(typed.captured(1).toInt(), typed.captured(2).toInt(), typed.captured(3).toInt());
  if (!typed.hasMatch() || !wanted.isValid() || rows_.empty()) return std::nullopt;
  constexpr int kDay = 24 * 3600 * 1000;
  const auto away = [&](const Row& row) {
    const int apart = std::abs(QDateTime::fromMSecsSinceEpoch(row.wallMs).time().msecsTo(wanted));
    return std::min(apart, kDay - apart);
  };
  const auto nearest = std::ranges::min_element(rows_.rbegin(), rows_.rend(), {}, away);
  return static_cast<int>(nearest - rows_.rbegin());
}

}  // namespace stillcut::ui
