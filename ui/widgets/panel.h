// The plain surface a group of widgets lies on.
#pragma once

#include <QWidget>

#include "ui/base/themed.h"

namespace stillcut::ui {

class Panel : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit Panel(QWidget* parent = nullptr);
  void applyTheme(const Theme& theme) override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Theme theme_;
};

}  // namespace stillcut::ui
