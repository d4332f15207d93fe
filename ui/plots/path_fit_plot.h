// How well the model of a path from actuator to sensor fits what was measured: magnitude of both, coherence, and the
// error of phase between them with the 90 degrees that FXLMS can stand (Morgan 1980). GUI thread.
#pragma once

#include <QPen>
#include <QWidget>

#include "core/model/active_state.h"
#include "ui/base/themed.h"

namespace stillcut::ui {

class PathFitPlot : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit PathFitPlot(QWidget* parent = nullptr);

  // Null: there is no model. Copied.
  void display(const PathFit* fit);
  bool hasFit() const { return !fit_.frequency.empty(); }
  // Between model and measurement [degrees], where the coherence tells; not a number elsewhere.
  static double phaseError(const PathFit& fit, std::size_t k);

  void applyTheme(const Theme& theme) override;
  QSize sizeHint() const override { return {theme_.px(420), theme_.px(330)}; }
  QSize minimumSizeHint() const override { return {theme_.px(300), theme_.px(280)}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawMagnitude(QPainter& p, const QRect& box) const;
  void drawPhase(QPainter& p, const QRect& box) const;
  void drawCoherence(QPainter& p, const QRect& box) const;
  QPen pen(const QColor& color, Qt::PenStyle style = Qt::SolidLine) const;
  template <class Value>
  void drawCurve(QPainter& p, const QRect& box, double low, double high, const QPen& pen, const Value& value) const;

  Theme theme_;
  PathFit fit_;
};

}  // namespace stillcut::ui
