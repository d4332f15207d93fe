// What every detector said over time, one row each, side by side: the state as a step (and a colour), the first
// indicator as a curve with its scale and its limit, and its value at the cursors. GUI thread.
#pragma once

#include <QString>
#include <deque>
#include <limits>
#include <vector>

#include "ui/models/history/run_history.h"
#include "ui/plots/time_plot.h"

namespace stillcut::ui {

class TrackPlot : public TimePlot {
  Q_OBJECT
 public:
  explicit TrackPlot(AnalyseView& view, QWidget* parent = nullptr);

  struct Row {
    QString name;
    double limit = std::numeric_limits<double>::quiet_NaN();  // of the first indicator; not a number: none
  };
  // Rows in the order of the tracks; `inCharge` is set in bold.
  void display(const RunHistory* history, std::vector<Row> rows, int inCharge);
  // At every display tick, in the same order: since when each limit has decided.
  void seeLimits(Instant now, const std::vector<double>& limits);
  void restart();
  // That decided then; not a number: none, or not seen.
  double limitAt(std::size_t track, Instant t) const;
  bool clipped() const override { return clipped_; }
  QSize minimumSizeHint() const override;

 protected:
  void drawPlot(QPainter& p, const QRect& plot) override;

 private:
  QFont fitting(const QString& name, bool bold, double room);
  void drawTrack(QPainter& p, const QRectF& row, const std::deque<TrackPoint>& track, double full) const;
  void drawScale(QPainter& p, const QRectF& row, double full) const;
  void drawLimit(QPainter& p, const QRectF& row, double full, double limit, std::size_t track) const;
  void drawReadings(QPainter& p, const QRectF& row, const std::deque<TrackPoint>& track) const;

  struct Limit {
    Instant from{};
    double value = 0.0;
  };

  const RunHistory* history_ = nullptr;
  std::vector<std::deque<Limit>> limits_;  // of each track, oldest first
  std::vector<Row> rows_;
  int inCharge_ = 0;
  bool clipped_ = false;
};

}  // namespace stillcut::ui
