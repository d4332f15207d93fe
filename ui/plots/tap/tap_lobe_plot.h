// Stability limits with the band of their doubt, and the cut that is recommended in them. GUI thread.
#pragma once

#include <QWidget>

#include "ui/base/themed.h"
#include "ui/base/units.h"
#include "ui/facade/tap_controller.h"

namespace stillcut::ui {

class TapLobePlot : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit TapLobePlot(QWidget* parent = nullptr);

  // Copied when it is another version.
  void display(const TapLobes& lobes, UnitSystem units);

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override { return {theme_.px(560), theme_.px(430)}; }
  QSize minimumSizeHint() const override { return {theme_.px(380), theme_.px(260)}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPointF place(Rpm speed, Metres depth, const QRect& box) const;
  void drawLimits(QPainter& p, const QRect& box) const;
  void drawTries(QPainter& p, const QRect& box) const;

  Theme theme_;
  UnitSystem units_ = UnitSystem::Metric;
  TapLobes shown_;
  double top_ = 1.0;  // depth at the upper edge [m]
};

}  // namespace stillcut::ui
