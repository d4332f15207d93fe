// The waterfall of the Analyse page: spectra one behind the other, the newest in front and lowest, frequency to the
// right. Where each stands follows from its time alone, so that they travel with the samples. A spectrum under a cursor
// is always among them. GUI thread.
#pragma once

#include <QPainter>
#include <QRect>
#include <functional>
#include <vector>

#include "ui/base/theme.h"
#include "ui/models/history/analyse_view.h"
#include "ui/models/history/run_history.h"

namespace stillcut::ui {

class WaterfallStack {
 public:
  // 0 at the lowest level of the scale, 1 at the highest.
  using LevelPlace = std::function<double(float level_dB)>;

  struct Line {
    const SpectrumColumn* column = nullptr;
    bool a = false, b = false;  // under that cursor
  };

  // All three outlive the stack; the history is not empty.
  WaterfallStack(const RunHistory& history, const AnalyseView& view, const QRect& plot, LevelPlace place);

  // By time, the oldest first.
  const std::vector<Line>& lines() const { return lines_; }
  double footOf(Instant t) const;
  Instant timeAt(double foot) const;
  // A drag down by this share of the plot's height moves the newest moment on show by so much.
  Seconds moveBy(double share) const;
  double xOf(Hertz f, const SpectrumColumn& column) const;
  // How high the spectrum reaches there.
  double crestAt(const SpectrumColumn& column, double x) const;
  // The spectrum that is seen at this place, in front of all others.
  const SpectrumColumn& under(const QPointF& at) const;

  void draw(QPainter& p, const Theme& theme) const;

 private:
  void gather();
  QPolygonF outline(const SpectrumColumn& column) const;
  void drawLine(QPainter& p, const Theme& theme, const Line& line) const;
  void drawGaps(QPainter& p, const Theme& theme, Instant after, Instant until) const;
  void drawFlag(QPainter& p, const Theme& theme, const Line& line) const;
  void drawTimes(QPainter& p, const Theme& theme) const;

  const RunHistory& history_;
  const AnalyseView& view_;
  QRect plot_;
  LevelPlace place_;
  Hertz newest_{};  // spindle of the newest column
  std::vector<Line> lines_;
};

}  // namespace stillcut::ui
