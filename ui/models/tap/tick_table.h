// Rows that can be ticked: hits, modes. A touch anywhere on a row ticks it. GUI thread.
#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <vector>

namespace stillcut::ui {

struct TickRow {
  QStringList cells;  // as many as there are columns
  bool ticked = true;
  QString hint;  // why it is as it is
  bool operator==(const TickRow&) const = default;
};

class TickTable : public QAbstractTableModel {
  Q_OBJECT
 public:
  using QAbstractTableModel::QAbstractTableModel;

  void show(const QStringList& header, std::vector<TickRow> rows);
  // Asks by tickAsked(); what comes of it is shown by show().
  void toggle(const QModelIndex& index);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

 signals:
  void tickAsked(int row, bool ticked);

 private:
  QStringList header_;
  std::vector<TickRow> rows_;
};

}  // namespace stillcut::ui
