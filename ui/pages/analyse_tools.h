// The row of controls above the plots of the Analyse page: how things are drawn, and of which channel. GUI thread.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "ui/base/themed.h"
#include "ui/models/history/analyse_view.h"

class QComboBox;
class QHBoxLayout;

namespace stillcut::ui {

class TouchButton;

class AnalyseTools : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit AnalyseTools(AnalyseView& view, QWidget* parent = nullptr);

  void setChannels(const QStringList& names);
  void setReference(bool on);
  void applyTheme(const Theme& theme) override;

 signals:
  void referenceAsked();
  void fileAsked();

 private:
  using Change = std::function<void(AnalyseOptions&)>;
  using IsOn = std::function<bool(const AnalyseOptions&)>;
  void addToggle(const QString& name, const QString& caption, Qt::Key key, const Change& change, const IsOn& isOn);
  TouchButton* addButton(const QString& name, const QString& caption, Qt::Key key);
  void showState();

  struct Toggle {
    TouchButton* button;
    IsOn isOn;
  };
  AnalyseView& view_;
  QHBoxLayout* row_;
  std::vector<Toggle> toggles_;
  TouchButton* live_;
  TouchButton* reference_;
  QComboBox* channel_;
  Theme theme_;
};

}  // namespace stillcut::ui
