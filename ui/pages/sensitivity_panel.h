// One control, less or more sensitive, beside what it acts on: the indicators of the detector in charge with the limits
// that decide, and what it would have done to the last recordings. GUI thread.
#pragma once

#include <array>
#include <map>

#include "ui/facade/session_info.h"
#include "ui/models/tune/sensitivity.h"
#include "ui/widgets/panel.h"

class QHBoxLayout;

namespace stillcut::ui {

class IndicatorStrip;
class TextLabel;
class TouchButton;

class SensitivityPanel : public Panel {
  Q_OBJECT
 public:
  explicit SensitivityPanel(QWidget* parent = nullptr);

  // Another run, or another detector in charge; null: none whose limits are known.
  void work(Tuning* tuning, const TunableComponent* detector);
  bool known() const { return sensitivity_.known(); }
  // At every display tick, also where another page is shown.
  void see(const Picture& picture);
  void display(const Picture& picture);
  void refresh();  // values have changed, by whomever

  void applyTheme(const Theme& theme) override;

 private:
  void step(int by);
  double limitOf(const char* own, const char* parameter) const;

  Tuning* tuning_ = nullptr;
  const TunableComponent* detector_ = nullptr;
  Sensitivity sensitivity_;
  std::map<std::string, double> own_;  // what the detector has set itself, by key
  QHBoxLayout* line_;
  TouchButton *less_, *more_;
  TextLabel *title_, *now_, *trial_;
  std::array<IndicatorStrip*, 2> strips_;
};

}  // namespace stillcut::ui
