// The strip at the foot of every page: link, sensor, rate, drops, overruns, block age, recording.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/base/themed.h"
#include "ui/models/strip_view.h"

namespace stillcut::ui {

class StatusStrip : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit StatusStrip(QWidget* parent = nullptr);

  void display(const std::vector<StripItem>& items);
  const std::vector<StripItem>& items() const { return items_; }
  bool clipped() const override { return clipped_; }

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Theme theme_;
  std::vector<StripItem> items_;
  std::vector<double> widest_;  // pixels every value has ever needed
  bool clipped_ = false;
};

}  // namespace stillcut::ui
