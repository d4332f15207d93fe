// Speed, feed and overrides of the machine over time: what was programmed as a thin line, what it did as a thick one.
// GUI thread.
#pragma once

#include <deque>

#include "ui/base/units.h"
#include "ui/models/history/event_log.h"
#include "ui/plots/time_plot.h"

namespace stillcut::ui {

class MachinePlot : public TimePlot {
  Q_OBJECT
 public:
  explicit MachinePlot(AnalyseView& view, QWidget* parent = nullptr);

  // `points` outlives the picture; null: none.
  // The last values stand until `known`, as long as no other was read.
  void display(const std::deque<MachinePoint>* points, Instant known, UnitSystem units);
  QSize minimumSizeHint() const override;

 protected:
  void drawPlot(QPainter& p, const QRect& plot) override;

 private:
  struct Row;
  void drawRow(QPainter& p, const QRectF& box, const Row& row) const;

  const std::deque<MachinePoint>* points_ = nullptr;
  Instant known_{};
  UnitSystem units_ = UnitSystem::Metric;
};

}  // namespace stillcut::ui
