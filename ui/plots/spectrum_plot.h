// One spectrum: the column under cursor A or the newest, with the highest of the stretch, a reference, the tooth
// passing as thin ticks, chatter as one labelled mark, and a harmonic cursor. A click puts the cursor; H puts it on the
// strongest line, Left and Right move it, Delete takes it away. The wheel zooms, a drag moves, fingers do as
// touch_input.h says. GUI thread.
#pragma once

#include <QWidget>
#include <optional>

#include "ui/base/themed.h"
#include "ui/facade/session_info.h"
#include "ui/models/history/spectrum_view.h"
#include "ui/plots/axis_painter.h"

namespace stillcut::ui {

class SpectrumPlot : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit SpectrumPlot(AnalyseView& view, QWidget* parent = nullptr);

  void display(const SpectrumView& spectrum);
  // Of the newest one.
  void setPlotState(PlotState plotState);
  // What the spectrum on show becomes the reference; again: none.
  void toggleReference();
  bool hasReference() const { return reference_.has_value(); }
  const SpectrumView& spectrum() const { return spectrum_; }

  void applyTheme(const Theme& theme) override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRect plotRect() const;
  Hertz frequencyAt(double x) const;
  double xOf(Hertz f) const;
  void moveBy(double right);  // the picture, by pixels
  AxisRange levels() const;
  void drawCurve(QPainter& p, const Levels& level_dB, const QPen& pen) const;
  void drawMarks(QPainter& p) const;

  AnalyseView& view_;
  SpectrumView spectrum_;
  std::optional<Levels> reference_;
  Theme theme_;
  double low_dB_ = -80.0, high_dB_ = 0.0;
  std::optional<QPointF> pressed_;
  QPointF last_;
  bool dragged_ = false;
  PlotState plotState_ = PlotState::Moves;
};

}  // namespace stillcut::ui
