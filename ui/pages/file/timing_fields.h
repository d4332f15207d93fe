// What a recording does not say of its own times, asked for where it was refused for that: the unit of its times, or
// how many samples a second it has. GUI thread.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/base/themed.h"
#include "ui/facade/file_controller.h"

class QHBoxLayout;
class QLineEdit;

namespace stillcut::ui {

class TextLabel;
class TouchButton;

class TimingFields : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit TimingFields(QWidget* parent = nullptr);

  // Hidden where nothing is lacking.
  void display(FileLack lack);
  void applyTheme(const Theme& theme) override;

 signals:
  void told(const stillcut::ui::FileTiming& timing);

 private:
  void tellRate();

  TextLabel* question_;
  std::vector<TouchButton*> units_;
  QLineEdit* rate_;
  TouchButton* read_;
  QHBoxLayout* row_;
};

}  // namespace stillcut::ui
