// The hand on a replay: to the beginning, a step back, play or pause, a step on, the pace, a loop. GUI thread.
#pragma once

#include <QWidget>

#include "ui/base/themed.h"
#include "ui/facade/session_controller.h"

namespace stillcut::ui {

class TextLabel;
class TouchButton;
class ValueSlider;

class TransportBar : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit TransportBar(QWidget* parent = nullptr);

  void display(const ReplayState& state);
  // 0 .. 1 of the pace slider is 0.1 .. 1000 times real time; its very end is "as fast as possible".
  static double paceAt(double fraction);
  static double fractionOfPace(double pace);

  void applyTheme(const Theme& theme) override;

 signals:
  void playAsked();
  void pauseAsked();
  void toStartAsked();
  void stepAsked(int blocks);
  void paceAsked(double times);
  void loopAsked(bool on);

 private:
  void movePace(double fraction);

  TouchButton *start_, *back_, *play_, *step_, *loop_;
  ValueSlider* pace_;
  TextLabel *time_, *times_;
  bool playing_ = false;
  double asked_ = 1.0;
};

}  // namespace stillcut::ui
