// One parameter: what it is, its value as slider, buttons and text, whether the part finds it itself, why it cannot be
// set. Made from its declaration alone. GUI thread.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/base/themed.h"
#include "ui/models/tune/param_model.h"

class QHBoxLayout;
class QLineEdit;

namespace stillcut::ui {

class TextLabel;
class TouchButton;
class ValueSlider;

class ParamRow : public QWidget, public Themed {
  Q_OBJECT
 public:
  // `row` of the model; the model outlives the widget.
  ParamRow(ParamModel& model, TuningController& controller, int row, QWidget* parent = nullptr);

  void refresh();
  // Only where what the part set itself has changed: what is being typed and said stays.
  void seeAutomatic();
  const ParamView& view() const { return view_; }
  void applyTheme(const Theme& theme) override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void makeChoices();
  void makeNumber();
  void set(double value);
  void type();

  ParamModel& model_;
  TuningController& controller_;
  const config::ParamDecl& decl_;
  int row_;
  ParamView view_;
  Theme theme_;
  QHBoxLayout* controls_;
  TextLabel* label_;
  TextLabel* meaning_;
  TextLabel* note_;
  ValueSlider* slider_ = nullptr;
  QLineEdit* edit_ = nullptr;
  TouchButton* less_ = nullptr;
  TouchButton* more_ = nullptr;
  TouchButton* automatic_ = nullptr;
  std::vector<TouchButton*> choices_;
};

}  // namespace stillcut::ui
