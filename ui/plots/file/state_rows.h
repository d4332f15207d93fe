// What was said over a recording, a row each: what was recorded with it, and every detector now. The state is told by
// height as well as by colour: low is stable, half is onset, full is chatter; what was not judged is hatched, air is
// empty. The line over it is what the detector looks at, its first indicator, with the limit of full chatter as a
// dashed line; its value stands beside a cursor. Where the view is never changes any of it. GUI thread.
#pragma once

#include <vector>

#include "ui/facade/file_controller.h"
#include "ui/plots/time_plot.h"

namespace stillcut::ui {

class StateRows : public TimePlot {
  Q_OBJECT
 public:
  explicit StateRows(AnalyseView& view, QWidget* parent = nullptr);

  // `answering`: the row whose answer stands on the page; its name is bold.
  void display(std::vector<FileTrack> rows, int answering);
  const std::vector<FileTrack>& rows() const { return rows_; }

  QSize minimumSizeHint() const override;
  bool clipped() const override { return clipped_; }

 protected:
  void drawPlot(QPainter& p, const QRect& plot) override;

 private:
  void drawRow(QPainter& p, const QRectF& row, const FileTrack& track) const;
  void drawCurve(QPainter& p, const QRectF& row, const FileCurve& curve) const;
  void drawScale(QPainter& p, const QRectF& row, const FileCurve& curve) const;
  void drawReadings(QPainter& p, const QRectF& row, const FileCurve& curve) const;
  QFont fitting(const QString& name, bool bold, double room);

  std::vector<FileTrack> rows_;
  int answering_ = 0;
  bool clipped_ = false;
};

}  // namespace stillcut::ui
