// How the screens look: light, dark or high contrast; how large the text is; metric or inch; the language; and the way
// to the manual. Lies over the page, takes no focus away from the bar, and goes when its button is touched again. GUI
// thread.
#pragma once

#include <QWidget>
#include <functional>
#include <utility>
#include <vector>

#include "ui/base/themed.h"
#include "ui/base/units.h"
#include "ui/shell/language.h"

namespace stillcut::ui {

class TouchButton;

struct DisplayChoice {
  ThemeKind theme = ThemeKind::Light;
  TextSize text = TextSize::Normal;
  UnitSystem units = UnitSystem::Metric;
  Language language = Language::English;
  bool operator==(const DisplayChoice&) const = default;
};

class DisplayPanel : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit DisplayPanel(QWidget* parent);

  void show(const DisplayChoice& choice);
  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override;

 signals:
  void chosen(const stillcut::ui::DisplayChoice& choice);
  void helpAsked();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  template <class Value>
  void addRow(const QString& name, const std::vector<std::pair<Value, QString>>& values, Value DisplayChoice::*member);
  void showChecked();

  struct Item {
    TouchButton* button;
    std::function<bool(const DisplayChoice&)> isChosen;
  };
  Theme theme_;
  DisplayChoice choice_;
  std::vector<Item> items_;
  TouchButton* help_ = nullptr;
};

}  // namespace stillcut::ui
