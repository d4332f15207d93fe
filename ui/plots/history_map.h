// The spectrogram of the Analyse page: any stretch of the history, as a heat map over time or as a waterfall of
// spectra, in hertz or in orders of the spindle, in decibel or linear. Tooth passing and chatter are marked, gaps
// hatched. Up and down move, Page Up and Page Down (or the wheel left of the plot) zoom the frequency. GUI thread.
#pragma once

#include "ui/models/run_history.h"
#include "ui/plots/heat_image.h"
#include "ui/plots/level_range.h"
#include "ui/plots/time_plot.h"

namespace stillcut::ui {

class HistoryMap : public TimePlot {
  Q_OBJECT
 public:
  explicit HistoryMap(AnalyseView& view, QWidget* parent = nullptr);

  // `history` is looked at until the next call; null: nothing to show.
  void display(const RunHistory* history, int teeth);
  void restart();

  QSize minimumSizeHint() const override;

 protected:
  void drawPlot(QPainter& p, const QRect& plot) override;
  void panUp(double share) override;
  void zoomUp(double factor, double y) override;
  void clicked(const QPointF& at, Qt::KeyboardModifiers modifiers) override;

 private:
  Hertz frequencyAt(double y) const;
  double yOf(Hertz f, const QRect& plot) const;
  // 0 at the palette's lower end, 1 at its upper.
  double placeOf(float level_dB) const;
  void drawHeat(QPainter& p, const QRect& plot);
  void drawHoles(QPainter& p, const QRect& plot) const;
  void drawMarks(QPainter& p, const QRect& plot) const;
  void drawWaterfall(QPainter& p, const QRect& plot) const;

  const RunHistory* history_ = nullptr;
  int teeth_ = 0;
  LevelRange range_;
  Instant seen_{};  // newest column the range knows
  HeatImage heat_;
};

}  // namespace stillcut::ui
