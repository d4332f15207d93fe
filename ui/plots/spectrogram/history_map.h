// The spectrogram of the Analyse page: any stretch of the history, as a heat map over time or as a waterfall of
// spectra, in hertz or in orders of the spindle, in decibel or linear. Tooth passing and chatter are marked, gaps
// hatched. What moves or zooms along an axis does so with the axis that is drawn there: in the waterfall frequency lies
// to the right and time upwards, and a cursor is one of its spectra. GUI thread.
#pragma once

#include "ui/models/history/run_history.h"
#include "ui/plots/spectrogram/heat_image.h"
#include "ui/plots/spectrogram/level_range.h"
#include "ui/plots/spectrogram/waterfall_stack.h"
#include "ui/plots/time_plot.h"

namespace stillcut::ui {

class HistoryMap : public TimePlot {
  Q_OBJECT
 public:
  explicit HistoryMap(AnalyseView& view, QWidget* parent = nullptr);

  // `history` is looked at until the next call; null: nothing to show. `unit` is the signal's.
  void display(const RunHistory* history, int teeth, const QString& unit);
  void restart();

  QSize minimumSizeHint() const override;

 protected:
  void drawPlot(QPainter& p, const QRect& plot) override;
  void drawCursors(QPainter& p, const QRect& plot) const override;
  bool lowerAxis() const override { return waterfall() || TimePlot::lowerAxis(); }
  void panRight(double share) override;
  void zoomRight(double factor, double x) override;
  void showBetween(double left, double right) override;
  void panUp(double share) override;
  void zoomUp(double factor, double y) override;
  void clicked(const QPointF& at, Qt::KeyboardModifiers modifiers) override;

 private:
  bool waterfall() const;
  bool shown() const { return history_ != nullptr && !history_->columns().empty(); }
  WaterfallStack stack() const;
  // `share` along the axis of frequency.
  Hertz frequencyAt(double share) const;
  double shareAcross(double x) const;
  double xOfFrequency(Hertz f, const QRect& plot) const;
  double yOf(Hertz f, const QRect& plot) const;
  // 0 at the palette's lower end, 1 at its upper.
  double placeOf(float level_dB) const;
  void drawKey(QPainter& p, const QRect& plot) const;
  void drawHeat(QPainter& p, const QRect& plot);
  void drawHoles(QPainter& p, const QRect& plot) const;
  void drawTeeth(QPainter& p, const QRect& plot) const;
  void drawChatter(QPainter& p, const QRect& plot) const;
  void drawHarmonics(QPainter& p, const QRect& plot) const;

  const RunHistory* history_ = nullptr;
  int teeth_ = 0;
  QString unit_;
  LevelRange range_;
  Instant seen_{};  // newest column the range knows
  HeatImage heat_;
};

}  // namespace stillcut::ui
