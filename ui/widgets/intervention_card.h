// One past move of ours: when, what, how long it took, and speed, feed and vibration before and after.
#pragma once

#include <QWidget>

#include "ui/base/themed.h"
#include "ui/models/strip_view.h"

namespace stillcut::ui {

class InterventionCard : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit InterventionCard(QWidget* parent = nullptr);

  void display(const CardView& view);
  const CardView& view() const { return view_; }
  bool clipped() const override { return clipped_; }

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Theme theme_;
  CardView view_;
  bool clipped_ = false;
};

}  // namespace stillcut::ui
