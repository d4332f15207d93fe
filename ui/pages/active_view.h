// The active work-holder on the Tune page: identify its paths, start and stop control, what it earns on every line, the
// stroke it uses, why it let go, and how well and how long ago its model was fitted. GUI thread.
#pragma once

#include <QWidget>
#include <array>
#include <functional>

#include "ui/base/themed.h"
#include "ui/facade/active_controller.h"

class QHBoxLayout;

namespace stillcut::ui {

class PathFitPlot;
class TextLabel;
class TouchButton;

class ActiveView : public QWidget, public Themed {
  Q_OBJECT
 public:
  // Gives the desk of the session as it is now; null: there is no active work-holder, the view says so.
  using FindController = std::function<ActiveController*()>;
  explicit ActiveView(FindController controller, QWidget* parent = nullptr);

  // Every display tick while it is on screen; somebody polls the desk.
  void display();
  void applyTheme(const Theme& theme) override;

 private:
  void takeAxis(int axis);
  void tell(const Status& status);

  FindController controller_;
  int axis_ = 0;
  QString refused_;  // the last touch, and why; empty: it was not
  QString problemSeen_;
  QHBoxLayout *actions_, *axes_;
  TouchButton *identify_, *start_, *stop_;
  std::array<TouchButton*, kActiveAxes> axisButtons_{};
  TextLabel *device_, *problem_, *state_, *earned_, *model_;
  PathFitPlot* fit_;
};

}  // namespace stillcut::ui
