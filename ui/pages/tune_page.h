// Tune: every parameter of every method as a panel made from its declaration, live on the running cut or on a replay;
// undo, A and B, reset, and keeping what was found. What the method sees now stands beside it.
#pragma once

#include <functional>
#include <vector>

#include "ui/models/tune/param_model.h"
#include "ui/models/tune/tuning.h"
#include "ui/models/tune/tuning_controller.h"
#include "ui/pages/page.h"

class QListView;
class QScrollArea;
class QHBoxLayout;
class QVBoxLayout;

namespace stillcut::ui {

class Panel;
class ActiveController;
class ActiveView;
class ParamRow;
class RuleEditor;
class SensitivityPanel;
class TextLabel;
class TouchButton;

class TunePage : public Page {
  Q_OBJECT
 public:
  // `tuning` may be null: there is nothing to tune, the page says so. It outlives the page. `active` gives the desk of
  // the active work-holder as it is now, or null.
  TunePage(Tuning* tuning, std::function<ActiveController*()> active, QWidget* parent = nullptr);

  void see(const Picture& picture) override;
  void display(const Picture& picture) override;
  void applyTheme(const Theme& theme) override;
  void keep(QSettings& settings) const override;
  void restore(const QSettings& settings) override;

  TuningController& controller() { return *controller_; }

 private:
  void build();
  QWidget* makeToolbar();
  QWidget* makeSide();
  void openRun();
  void work(TuningController& controller);
  void showPart(const TunableComponent* part);
  std::vector<const config::ParamDecl*> openParams() const;
  void refreshTools();
  void setExpert(bool expert);
  void showOwn();
  void showLive(const Picture& picture);
  void save();

  Tuning* tuning_;
  TuningController none_;                  // where there is nothing to tune
  TuningController* controller_ = &none_;  // of the run that is shown
  ParamModel params_{none_};
  ComponentListModel parts_;
  Theme theme_;
  std::uint32_t run_ = 0;

  bool expert_ = false;  // single parameters, instead of the one control
  SensitivityPanel* sensitivity_ = nullptr;
  QListView* list_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  QWidget* rowsBox_ = nullptr;
  QVBoxLayout* rowsLayout_ = nullptr;
  int rowsBefore_ = 0;  // widgets of the layout above the rows
  QHBoxLayout *tools_ = nullptr, *sides_ = nullptr;
  std::vector<ParamRow*> rows_;
  RuleEditor* rules_ = nullptr;
  ActiveView* active_;
  TouchButton *undo_ = nullptr, *redo_ = nullptr, *reset_ = nullptr, *start_ = nullptr, *save_ = nullptr;
  TouchButton *useA_ = nullptr, *useB_ = nullptr, *copy_ = nullptr, *expertButton_ = nullptr;
  TextLabel *title_ = nullptr, *source_ = nullptr, *live_ = nullptr, *numbers_ = nullptr, *tallyA_ = nullptr,
            *tallyB_ = nullptr, *note_ = nullptr, *differs_ = nullptr, *own_ = nullptr;
  Panel *sidePanel_ = nullptr, *rowsPanel_ = nullptr;
};

}  // namespace stillcut::ui
