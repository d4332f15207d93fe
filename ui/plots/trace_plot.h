// The samples of one channel over time, as far as they are kept; what was not measured is shaded. GUI thread.
#pragma once

#include "ui/models/history/signal_history.h"
#include "ui/plots/time_plot.h"

namespace stillcut::ui {

class TracePlot : public TimePlot {
  Q_OBJECT
 public:
  explicit TracePlot(AnalyseView& view, QWidget* parent = nullptr);

  void display(const SignalHistory* signal, const QString& unit);
  QSize minimumSizeHint() const override;

 protected:
  void drawPlot(QPainter& p, const QRect& plot) override;

 private:
  const SignalHistory* signal_ = nullptr;
  QString unit_;
  double full_ = 0.0;  // of the scale, both ways; grows at once, shrinks slowly
};

}  // namespace stillcut::ui
