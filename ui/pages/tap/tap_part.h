// One step of the Tap test page. GUI thread.
#pragma once

#include "ui/base/units.h"
#include "ui/facade/tap_controller.h"
#include "ui/widgets/panel.h"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QSettings;
class QTableView;

namespace stillcut::ui {

class TextLabel;
class TickTable;
class TouchButton;

class TapPart : public Panel {
  Q_OBJECT
 public:
  explicit TapPart(TapController& controller, QWidget* parent = nullptr);

  // Something of the controller, or the axis looked at, has changed.
  virtual void refresh(int axis, UnitSystem units) = 0;
  virtual void keep(QSettings& settings) const { static_cast<void>(settings); }
  virtual void restore(const QSettings& settings) { static_cast<void>(settings); }
  void applyTheme(const Theme& theme) override;

 signals:
  void axisAsked(int axis);
  void stateChanged();

 protected:
  QComboBox* makeChoice(const QString& spoken, const QString& name);
  QDoubleSpinBox* makeNumber(const QString& spoken, const QString& name);
  QLineEdit* makeEdit(const QString& spoken, const QString& name);
  // A table whose rows a touch ticks.
  QTableView* makeTable(TickTable& rows, const QString& spoken, const QString& name);

  // A file of that name is there: the first touch asks, the second one overwrites.
  bool asksFirst(TouchButton* keep, TextLabel* said, const QString& there);
  // Of a field made after the theme was set, and of one that goes.
  void dressTyped(QWidget* field) const;
  void forgetTyped(QWidget* field) { typed_.removeOne(field); }
  const Theme& theme() const { return theme_; }

  TapController& controller_;

 private:
  Theme theme_;
  QList<QWidget*> typed_;
  QList<QTableView*> tables_;
};

}  // namespace stillcut::ui
