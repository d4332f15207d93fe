// First step of a tap test: a device, its hammer and its sensor with their meters, "hit now", and the hits as they are
// judged; or files. GUI thread.
#pragma once

#include "ui/models/tap/tick_table.h"
#include "ui/pages/tap/tap_part.h"

class QGridLayout;

namespace stillcut::ui {

class LimitBar;
class TextLabel;
class TouchButton;

class TapMeasure : public TapPart {
  Q_OBJECT
 public:
  explicit TapMeasure(TapController& controller, QWidget* parent = nullptr);
  void refresh(int axis, UnitSystem units) override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void showDevices();
  void showChannels();
  void openFiles();
  void showQuestions();
  void answer();

  int axis_ = 0;
  QComboBox *device_, *force_, *response_;
  LimitBar *forceMeter_, *responseMeter_;
  TextLabel *sign_, *detail_;
  TouchButton *begin_, *files_;
  // What a file does not say; shown when it is asked for.
  QWidget* questions_;
  QGridLayout* questionRows_;
  TouchButton *flip_, *read_;
  std::vector<std::pair<TapQuestion, QLineEdit*>> asked_;
  TickTable hits_;
  QTableView* table_;
  QStringList channels_;  // that are offered
};

}  // namespace stillcut::ui
