// What every detector said over time, one row each, side by side: the state as a step (and a colour), the first
// indicator as a curve. GUI thread.
#pragma once

#include <QStringList>

#include "ui/models/run_history.h"
#include "ui/plots/time_plot.h"

namespace stillcut::ui {

class TrackPlot : public TimePlot {
  Q_OBJECT
 public:
  explicit TrackPlot(AnalyseView& view, QWidget* parent = nullptr);

  // Names in the order of the tracks; `inCharge` is set in bold.
  void display(const RunHistory* history, const QStringList& names, int inCharge);
  bool clipped() const override { return clipped_; }
  QSize minimumSizeHint() const override;

 protected:
  void drawPlot(QPainter& p, const QRect& plot) override;

 private:
  QFont fitting(const QString& name, bool bold, double room);
  void drawTrack(QPainter& p, const QRectF& row, const std::deque<TrackPoint>& track) const;

  const RunHistory* history_ = nullptr;
  QStringList names_;
  int inCharge_ = 0;
  bool clipped_ = false;
};

}  // namespace stillcut::ui
