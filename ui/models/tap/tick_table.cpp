#include "ui/models/tap/tick_table.h"

#include <utility>

namespace stillcut::ui {

void TickTable::show(const QStringList& header, std::vector<TickRow> rows) {
  if (header == header_ && rows == rows_) return;
  const bool same = header == header_ && rows.size() == rows_.size();
  if (!same) beginResetModel();
  header_ = header;
  rows_ = std::move(rows);
  if (!same) return endResetModel();
  if (!rows_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

void TickTable::toggle(const QModelIndex& index) {
  if (!index.isValid()) return;
  emit tickAsked(index.row(), !rows_[static_cast<std::size_t>(index.row())].ticked);
}

int TickTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int TickTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(header_.size());
}

QVariant TickTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const TickRow& row = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return row.cells.value(index.column());
    case Qt::CheckStateRole:
      return index.column() == 0 ? QVariant(row.ticked ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::ToolTipRole:
      return row.hint;
    case Qt::TextAlignmentRole:
      return QVariant(Qt::AlignVCenter | Qt::AlignLeft);
    default:
      return {};
  }
}

QVariant TickTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::DisplayRole) return header_.value(section);
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignVCenter | Qt::AlignLeft);
  return {};
}

}  // namespace stillcut::ui
