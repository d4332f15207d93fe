// A slider for gloves: a wide handle, a tick where the default lies, arrow keys for steps. Hands on fractions; what
// they mean is its owner's affair. GUI thread.
#pragma once

#include <QWidget>

#include "ui/base/themed.h"

namespace stillcut::ui {

class ValueSlider : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit ValueSlider(QWidget* parent = nullptr);

  void display(double fraction, double fallback, bool automatic);
  double fraction() const { return fraction_; }

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void moved(double fraction);
  void stepped(int direction);
  void released();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF track() const;
  void moveTo(double x);

  Theme theme_;
  double fraction_ = 0.0, fallback_ = 0.0;
  bool automatic_ = false;
};

}  // namespace stillcut::ui
