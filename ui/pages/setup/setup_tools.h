// The tab of the shop's tools: teeth, diameter, pitch, modes, limits, notes, and where each chattered before.
#pragma once

#include <map>
#include <utility>

#include "ui/pages/setup/setup_tab.h"

class QListView;
class QPlainTextEdit;

namespace stillcut::ui {

class SetupTools : public SetupTab {
  Q_OBJECT
 public:
  SetupTools(SetupController& controller, SetupDraft& draft, QWidget* parent = nullptr);
  void refresh() override;
  void display(const Picture& picture) override;
  void applyTheme(const Theme& theme) override;

 private:
  ToolEntry typed() const;
  ToolEntry typedOver(int row) const;
  bool edited() const;
  void take(ToolEntry tool);
  void moveTyped(int from, int by);
  void showTool(int row);
  void showUnits();
  void keep(const QString& done);
  void noteChatter();
  // False, and it says so: the pitch does not go once around, or a file is not what it should be.
  bool fits();
  bool refuse(const QString& why);

  ToolModel tools_;
  QListView* list_;
  QLineEdit *name_, *holder_, *teeth_, *diameter_, *pitch_, *modes_, *material_, *response_, *stickOut_, *deepest_,
      *slowest_, *limit_;
  std::vector<QLineEdit*> fields_;
  QPlainTextEdit* notes_;
  struct Length {
    QLineEdit* edit;
    TextLabel* label;
    QString name;
  };
  std::vector<Length> lengths_;  // fields whose unit is the screen's
  TextLabel *chattered_, *note_;
  TouchButton *save_, *use_, *remove_, *putBack_, *here_;
  std::map<int, ToolEntry> typed_;     // by row: what was typed of a tool and not kept before another one was chosen
  std::pair<int, ToolEntry> removed_;  // the last one, and its row
  ChatterNote now_;                    // what the cut does
  bool alarming_ = false;
};

}  // namespace stillcut::ui
