// Set up: a guide that ends in a running cut, and what it is made of: machine link, sensors, tools, what is recorded,
// the profile that holds them together and is tried out step by step. Knows no device.
#pragma once

#include <vector>

#include "ui/models/setup_draft.h"
#include "ui/pages/page.h"

class QStackedWidget;
class QVBoxLayout;

namespace stillcut::ui {

class SetupTab;
class TouchButton;

class SetupPage : public Page {
  Q_OBJECT
 public:
  // `desk` may be null: there is nothing to set up here, the page says so. It outlives the page.
  explicit SetupPage(SetupController* controller, QWidget* parent = nullptr);

  void see(const Picture& picture) override;
  void display(const Picture& picture) override;
  void applyTheme(const Theme& theme) override;
  void keep(QSettings& settings) const override;
  void restore(const QSettings& settings) override;

  void showTab(int tab);
  void setWaits(bool waits);
  void showStart();
  int firstTab(int kept) const;

 private:
  SetupController* controller_;
  SetupDraft draft_;
  QStackedWidget* stack_;
  QVBoxLayout* choices_ = nullptr;
  std::vector<SetupTab*> tabs_;
  std::vector<TouchButton*> buttons_;
  TouchButton* start_ = nullptr;
  bool waits_ = false;  // what was changed is not in force
};

}  // namespace stillcut::ui
