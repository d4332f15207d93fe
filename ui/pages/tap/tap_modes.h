// Second step of a tap test: the modes that were found, to be ticked, and kept as the file that tools and lobes take.
// GUI thread.
#pragma once

#include "ui/models/tap/tick_table.h"
#include "ui/pages/tap/tap_part.h"

namespace stillcut::ui {

class TextLabel;
class TouchButton;

class TapModes : public TapPart {
  Q_OBJECT
 public:
  explicit TapModes(TapController& controller, QWidget* parent = nullptr);
  void refresh(int axis, UnitSystem units) override;

 private:
  int axis_ = 0;
  std::uint32_t seen_ = 0;
  TickTable modes_;
  QTableView* table_;
  TextLabel *sign_, *remarks_, *said_;
  QLineEdit* name_;
  TouchButton* keep_;
};

}  // namespace stillcut::ui
