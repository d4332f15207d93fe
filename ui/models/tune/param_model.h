// ParamModel: the parameters of one part as a table: what they are called, their value, what it was at the start, and
// why some cannot be set just now. Values are set through the desk. GUI thread.
#pragma once

#include <QAbstractTableModel>
#include <utility>
#include <vector>

#include "ui/models/tune/tuning.h"
#include "ui/models/tune/tuning_controller.h"

namespace stillcut::ui {

// One parameter as a row shows it.
struct ParamView {
  QString label, meaning, unit, value, range;
  QString automatic;  // what the part chose, or that it learns it; empty: not automatic
  QString locked;     // why it cannot be set now; empty: it can
  QString fallback;   // the default
  double fraction = 0.0, fallbackFraction = 0.0;
  bool mayBeAutomatic = false, isAutomatic = false;
  bool changed = false;    // not the default
  bool otherSide = false;  // A and B differ
  QStringList choices;     // of a choice or a switch
  int chosen = -1;
  bool operator==(const ParamView&) const = default;
};

class ParamModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { Name, Value, Unit, Default, ColumnCount };
  explicit ParamModel(TuningController& controller, QObject* parent = nullptr);
  void work(TuningController& controller);

  // Null: none. The part must live as long as it is shown.
  void show(const TunableComponent* part);
  // Whether blocks are being worked on: locked parameters may be set only between runs.
  // True: that has changed.
  bool setRunning(bool running);

  // What the part has set itself, now.
  void tell(std::vector<AutoReading> own) { own_ = std::move(own); }
  // Not a number: it has set nothing for this parameter.
  double ownValue(const config::ParamDecl& decl) const;
  // Of those that are no parameter: a line each, with the reason.
  QString otherOwnText() const;

  const TunableComponent* part() const { return part_; }
  const config::ParamDecl& decl(int row) const { return *part_->params[static_cast<std::size_t>(row)]; }
  ParamView view(int row) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString lockReason(const config::ParamDecl& decl) const;
  QString automaticText(const config::ParamDecl& decl) const;
  const AutoReading* reading(const config::ParamDecl& decl) const;  // null: the part tells none of it

  TuningController* controller_ = nullptr;
  const TunableComponent* part_ = nullptr;
  bool running_ = false;
  std::vector<AutoReading> own_;
};

// The parts of a run as a list: those that run first.
class ComponentListModel : public QAbstractListModel {
  Q_OBJECT
 public:
  using QAbstractListModel::QAbstractListModel;
  void show(const std::vector<TunableComponent>& parts);
  const TunableComponent* part(int row) const;
  int rowOf(const QString& id) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

 private:
  std::vector<const TunableComponent*> parts_;
};

}  // namespace stillcut::ui
