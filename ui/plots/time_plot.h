// What plots over time have in common: one axis, shared with the others through the view; the cursors; wheel, drag and
// keys that move and zoom. A click puts cursor A, with Shift cursor B; a drag moves, with Control it zooms to what was
// drawn over; the wheel zooms; fingers do as touch_input.h says. Keys: arrows, plus, minus, Home (first), End (newest),
// A and B (cursor to the middle), Delete (no cursors). GUI thread.
#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "ui/base/themed.h"
#include "ui/facade/session_info.h"
#include "ui/models/history/analyse_view.h"

namespace stillcut::ui {

class TimePlot : public QWidget, public Themed {
  Q_OBJECT
 public:
  // The view outlives the plot. `title` stands above it.
  TimePlot(AnalyseView& view, const QString& title, QWidget* parent = nullptr);

  // Stream time as the clock on the wall.
  void setClock(std::function<qint64(Instant)> wallMs) { wallMs_ = std::move(wallMs); }
  // Times count from the beginning, where no clock on the wall is known.
  void setElapsed(bool elapsed);
  // Only the lowest of several plots carries the time.
  void setTimesShown(bool shown);
  // How it is read, beside the title where there is room.
  void setLegend(const QString& legend) { legend_ = legend; }
  void setPlotState(PlotState plotState);

  QRect plotRect() const;
  Instant timeAt(double x) const;
  double xOf(Instant t) const;

  void applyTheme(const Theme& theme) override;
  const Theme& shownTheme() const { return theme_; }

 protected:
  // What is special to the plot; times and cursors are drawn by this class.
  virtual void drawPlot(QPainter& p, const QRect& plot) = 0;
  // Time lies along the lower axis, unless a plot says otherwise. A drag of `share` of the plot's width to the right;
  // the wheel at x; a stretch drawn over.
  virtual void panRight(double share);
  virtual void zoomRight(double factor, double x);
  virtual void showBetween(double left, double right);
  // The same across it, where the plot has a second axis; `share` of its height, upwards.
  virtual void panUp(double share) { static_cast<void>(share); }
  virtual void zoomUp(double factor, double y) { static_cast<void>(factor), static_cast<void>(y); }
  virtual void clicked(const QPointF& at, Qt::KeyboardModifiers modifiers);
  virtual void drawCursors(QPainter& p, const QRect& plot) const;
  // What is read at a cursor, beside its line at the top of `row`.
  void drawReading(QPainter& p, const QRectF& row, Instant t, const QString& text) const;
  // Whether there are numbers below the plot.
  virtual bool lowerAxis() const { return timesShown_; }

  const Theme& theme() const { return theme_; }
  AnalyseView& view() const { return view_; }

  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void drawTimes(QPainter& p, const QRect& plot) const;
  void moveBy(const QPointF& by);  // the picture, by pixels

  AnalyseView& view_;
  QString title_, legend_;
  Theme theme_;
  std::function<qint64(Instant)> wallMs_;
  bool timesShown_ = true;
  bool elapsed_ = false;
  PlotState plotState_ = PlotState::Moves;
  std::optional<QPointF> pressed_;  // where a touch began
  QPointF last_;
  bool dragged_ = false;
  bool boxing_ = false;
};

}  // namespace stillcut::ui
