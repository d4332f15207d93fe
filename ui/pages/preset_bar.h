// Below the spectrum of the Analyse page: what the cursors read, named presets, and the way to a moment. GUI thread.
#pragma once

#include <QWidget>

#include "ui/base/themed.h"
#include "ui/facade/session_info.h"
#include "ui/models/history/analyse_view.h"
#include "ui/models/tune/preset_list.h"

class QComboBox;
class QGridLayout;
class QLineEdit;

namespace stillcut::ui {

class TouchButton;

class PresetBar : public QWidget, public Themed {
  Q_OBJECT
 public:
  PresetBar(AnalyseView& view, PresetList& presets, QWidget* parent = nullptr);

  void display(const SessionInfo& info);
  bool clipped() const override { return clipped_; }
  void applyTheme(const Theme& theme) override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void choose(int row);
  void save();
  void drop();
  void offerBack(std::optional<std::pair<QString, AnalyseOptions>> dropped, const QString& shown);
  void go();
  QString cursorText() const;

  AnalyseView& view_;
  PresetList& presets_;
  const SessionInfo* info_ = nullptr;
  QGridLayout* grid_;
  QComboBox* names_;
  TouchButton* save_;
  TouchButton* drop_;
  QLineEdit* moment_;
  TouchButton* go_;
  std::optional<std::pair<QString, AnalyseOptions>> dropped_;  // the preset that was deleted last
  Theme theme_;
  bool refused_ = false;  // the text is no moment
  bool clipped_ = false;
};

}  // namespace stillcut::ui
