// The stability diagram as a chart: limit, quiet region, where the cut is and has been, what is advised, and a handle
// to drag: "what if". Arrow keys move the handle, with Shift in large steps; the wheel, plus and minus zoom, zero shows
// the whole, and fingers do as touch_input.h says. GUI thread.
#pragma once

#include <QChartView>
#include <vector>

#include "ui/base/themed.h"
#include "ui/models/lobe_view.h"
#include "ui/plots/learned_layer.h"

class QAreaSeries;
class QLineSeries;
class QScatterSeries;
class QCategoryAxis;

namespace stillcut::ui {

class LobeChart : public QChartView, public Themed {
  Q_OBJECT
 public:
  explicit LobeChart(QWidget* parent = nullptr);

  void setUnits(UnitSystem units);
  // Null: none yet, the axes are those of the frame.
  void setDiagram(const LobeDiagram* diagram, const LobeFrame& frame);
  void setWork(std::optional<SpeedDepth> now, const std::vector<MetPoint>& met);
  // Where the advice would go, from where the cut is.
  void setAdvice(std::optional<Rpm> target);
  // Null: nothing was learned.
  void setLearned(std::shared_ptr<const LearnedLobes> learned);
  // The judged cut whose dot is there on the widget; null: none.
  const LearnedCut* cutAt(const QPoint& at) const;
  void setHandle(SpeedDepth handle);
  SpeedDepth handle() const { return handle_; }
  std::optional<SpeedDepth> now() const { return now_; }
  Rpm leftmost() const { return from_; }
  Rpm rightmost() const { return to_; }
  Metres deepest() const { return deepest_; }

  // Where a point of the diagram is on the widget.
  QPoint place(SpeedDepth point) const;

  void applyTheme(const Theme& theme) override;
  bool clipped() const override { return clipped_; }
  QSize minimumSizeHint() const override;

 signals:
  void handleMoved();

 protected:
  bool viewportEvent(QEvent* event) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double shown(Metres depth) const;  // in the unit of the axis
  Metres depthOf(double shown) const;
  void moveHandle(SpeedDepth to);
  void moveHandleTo(const QPoint& at);
  QPointF onChart(SpeedDepth point) const;
  QPointF fromView(const QPointF& at) const;
  void drawIslands(QPainter& p) const;
  void showFrame();
  void showWhole();
  // `around` on the chart; `factor` times as much is shown.
  void zoom(double factor, const QPointF& around, Qt::Orientation along);
  void moveBy(double right);  // the picture, by pixels

  Theme theme_;
  UnitSystem units_ = UnitSystem::Metric;
  QCategoryAxis* speed_;
  QCategoryAxis* depth_;
  QLineSeries* limit_;
  QLineSeries* floor_;
  QAreaSeries* quiet_;
  QLineSeries* trail_;
  QScatterSeries* metStable_;
  QScatterSeries* metOnset_;
  QScatterSeries* metChatter_;
  LobeFrame frame_;
  Rpm from_{}, to_{};  // what is on show of the frame
  Metres deepest_{};
  struct Island {
    Rpm left{}, right{};
    DepthSpan span;
  };
  std::vector<Island> islands_;
  LearnedLayer learned_;
  std::optional<SpeedDepth> now_;
  std::optional<Rpm> advice_;
  SpeedDepth handle_;
  bool dragging_ = false;
  bool clipped_ = false;
};

}  // namespace stillcut::ui
