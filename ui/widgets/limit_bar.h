// One measured value as a bar with its limits as marks, the label before and the number behind.
#pragma once

#include <QWidget>

#include "ui/base/themed.h"
#include "ui/models/machine_view.h"

namespace stillcut::ui {

class LimitBar : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit LimitBar(QWidget* parent = nullptr);

  void display(const BarView& view);
  const BarView& view() const { return view_; }
  bool clipped() const override { return clipped_; }

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawScale(QPainter& p, const QRectF& bed) const;
  void drawWithout(QPainter& p, const QRectF& bed) const;

  Theme theme_;
  BarView view_;
  bool clipped_ = false;
};

}  // namespace stillcut::ui
