// The rules and sets of a fuzzy strategy on the Tune page: shown, changed on the running cut through the desk (undo, A
// and B as for every parameter), and what learning has made of them. GUI thread.
#pragma once

#include "core/model/rule_tables.h"
#include "ui/base/themed.h"
#include "ui/models/tune/tuning.h"
#include "ui/models/tune/tuning_controller.h"
#include "ui/pages/rule_grid.h"

class QHBoxLayout;

namespace stillcut::ui {

class MembershipPlot;
class TextLabel;
class TouchButton;

class RuleEditor : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit RuleEditor(TuningController& controller, QWidget* parent = nullptr);
  void work(TuningController& controller) { controller_ = &controller; }

  // Null, or a part without rules: nothing to edit, hidden. The part lives as long as it is shown.
  void show(const TunableComponent* part);
  // The values, and what the running strategy says of its rules; null: it says nothing new.
  void refresh(const RuleTables* told);
  void applyTheme(const Theme& theme) override;

 private:
  const std::vector<const config::ParamDecl*>& decls() const;
  void takeTable(bool feed);
  void step(int cell, int direction);

  TuningController* controller_;
  const TunableComponent* part_ = nullptr;
  bool feed_ = false;
  RuleTables now_;
  bool hasNow_ = false;
  QHBoxLayout* line_;
  TouchButton *speedTable_, *feedTable_, *less_, *more_;
  RuleGrid* grid_;
  MembershipPlot* sets_;
  TextLabel *cell_, *learned_;
};

}  // namespace stillcut::ui
