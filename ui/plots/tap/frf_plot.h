// A measured frequency response with the one of its modes: real and imaginary part, magnitude and phase, coherence, on
// one frequency axis. Modes are marked; outside the band of the fit it is hatched. GUI thread.
#pragma once

#include <QWidget>
#include <functional>

#include "ui/base/themed.h"
#include "ui/facade/tap_controller.h"

namespace stillcut::ui {

class FrfPlot : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit FrfPlot(QWidget* parent = nullptr);

  // Copied when it is another version.
  void display(const TapResponse& response);
  bool hasResponse() const { return !shown_.frequency.empty(); }

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override { return {theme_.px(560), theme_.px(430)}; }
  QSize minimumSizeHint() const override { return {theme_.px(380), theme_.px(320)}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  using Value = std::function<double(std::complex<double>)>;
  struct Box {
    QRect place;
    QString title, unit;
    double low = 0.0, high = 1.0;
    Value value;
  };
  void fitRange(Box& box) const;
  void drawBox(QPainter& p, const Box& box) const;
  void drawCoherence(QPainter& p, const Box& box) const;
  void drawFrame(QPainter& p, const Box& box) const;
  void drawCurve(QPainter& p, const Box& box, const QPen& pen, const std::function<double(std::size_t)>& value) const;
  double across(double frequency, const QRect& box) const;
  QPen pen(const QColor& color, Qt::PenStyle style = Qt::SolidLine) const;

  Theme theme_;
  TapResponse shown_;
};

}  // namespace stillcut::ui
