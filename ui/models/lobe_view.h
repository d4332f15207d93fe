// What the Lobes page reads out of a diagram: the limit at a speed, the quiet pockets at a depth with what they remove,
// "what if", and the points met so far. GUI thread; pure functions and a table model.
#pragma once

#include <QAbstractTableModel>
#include <optional>
#include <vector>

#include "ui/base/theme.h"
#include "ui/base/units.h"
#include "ui/facade/lobe_service.h"
#include "ui/models/history/run_history.h"

namespace stillcut::ui {

// Between two speeds looked at the limit runs straight; none outside the diagram.
std::optional<Metres> limitAt(const LobeDiagram& diagram, Rpm speed);

// Whether limitAt() is only where the search ended: no limit was found on either side.
bool openBelow(const LobeDiagram& diagram, Rpm speed);

// Whether the speeds looked at on both sides are quiet again this deep, above their limit.
bool onIsland(const LobeDiagram& diagram, Rpm speed, Metres depth);

// Stretches of speed whose limit lies deeper than `depth`, by speed: from between the speeds of the diagram.
std::vector<Pocket> pocketsAt(const LobeDiagram& diagram, const LobeFrame& frame, Metres depth);

struct WhatIf {
  bool known = false;
  bool stable = false;
  QString verdict;  // "STABLE" or "CHATTER", with the margin
  QString detail;   // limit, removal rate, cutting time against the programme
  Tone tone = Tone::Faint;
  bool operator==(const WhatIf&) const = default;
};

// `closeUp` goes before the diagram where it is of this place.
WhatIf whatIf(const LobeDiagram* diagram, const LobeFrame& frame, const SpeedDepth& at, UnitSystem units,
              const LobeCloseUp* closeUp = nullptr);

// The same for the pockets at a depth.
std::vector<Pocket> pocketsAt(const LobeDiagram* diagram, const LobeFrame& frame, Metres depth,
                              const LobeCloseUp* closeUp);

// Where the cut has been, and whether it was quiet there: stable, onset or chatter.
struct MetPoint {
  Rpm speed{};
  Metres depth{};
  CutState state = CutState::Stable;
};
std::vector<MetPoint> pointsMet(const RunHistory& history, const LobeService& service);

class PocketTable : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { Speeds, Best, Limit, Removal, kColumns };
  using QAbstractTableModel::QAbstractTableModel;

  void setPockets(std::vector<Pocket> pockets, UnitSystem units);
  const Pocket& pocket(int row) const { return pockets_[static_cast<std::size_t>(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

 private:
  QVariant hintOf(const Pocket& pocket, Column column) const;

  std::vector<Pocket> pockets_;
  UnitSystem units_ = UnitSystem::Metric;
};

}  // namespace stillcut::ui
