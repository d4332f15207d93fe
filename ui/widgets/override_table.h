// Speed and feed: programmed, override, actual, in absolute values, under each other so that digits line up.
#pragma once

#include <QWidget>

#include "ui/base/themed.h"
#include "ui/models/machine_view.h"

namespace stillcut::ui {

class OverrideTable : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit OverrideTable(QWidget* parent = nullptr);

  void display(const MachineView& view);
  const MachineView& view() const { return view_; }
  bool clipped() const override { return clipped_; }

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Theme theme_;
  MachineView view_;
  bool clipped_ = false;
};

}  // namespace stillcut::ui
