// The steps of a trial, one under the other, each in the tone of what became of it. GUI thread.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/base/themed.h"

class QVBoxLayout;

namespace stillcut::ui {

class TextLabel;

struct StepLine {
  QString text;
  Tone tone = Tone::Normal;
};

class StepList : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit StepList(QWidget* parent = nullptr);

  void display(const std::vector<StepLine>& lines);
  void applyTheme(const Theme& theme) override;

 private:
  Theme theme_;
  QVBoxLayout* column_;
  std::vector<TextLabel*> labels_;
};

}  // namespace stillcut::ui
