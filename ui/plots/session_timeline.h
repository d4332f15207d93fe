// One time axis for a whole recording: the vibration, what was recorded, what each detector would have said before and
// after a change, the markers, a selected span, and where the replay is. Click goes there, drag selects, the wheel and
// the keys zoom. Paints values; knows no session. GUI thread.
#pragma once

#include <QWidget>
#include <memory>
#include <utility>
#include <vector>

#include "core/model/marker.h"
#include "ui/base/themed.h"
#include "ui/facade/session_controller.h"

namespace stillcut::ui {

class SessionTimeline : public QWidget, public Themed {
  Q_OBJECT
 public:
  struct Mark {
    Seconds begin{}, end{};
    QString text;
    Tone tone = Tone::Normal;
  };
  explicit SessionTimeline(QWidget* parent = nullptr);

  // What more is told of the same file leaves the picture and the selected span where they are.
  void setSummary(std::shared_ptr<const SessionSummary> summary);
  // Another recording on the same axis, both from their first sample; null: none. Not drawn beside itself.
  void setBeside(std::shared_ptr<const SessionSummary> beside);
  bool besideShown() const;
  void setTracks(const std::vector<DetectorTrack>& tracks);
  void setMarks(std::vector<Mark> marks);
  void setReplay(const ReplayState& state);

  // The span selected by dragging; empty (from == to): none.
  Seconds selectedFrom() const { return Seconds(std::min(from_, to_)); }
  Seconds selectedTo() const { return Seconds(std::max(from_, to_)); }
  bool hasSelection() const { return from_ != to_; }
  void select(Seconds from, Seconds to);

  void applyTheme(const Theme& theme) override;
  bool clipped() const override { return clipped_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void wentTo(double seconds);
  void selected();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  // Before scaling.
  static constexpr double kNames = 132.0;  // width of the rows' names
  static constexpr double kAxis = 24.0, kRow = 22.0;
  static constexpr double kFirstTime = 38.0;  // the first time stands as far left of the plot

  double length() const;
  double axisEnd() const;
  double scaleTop() const;
  QRectF plot() const;
  double xOf(double seconds) const;
  double timeAt(double x) const;
  void zoom(double factor, double around);
  void moveBy(double right);  // the picture, by pixels
  void paintCurve(QPainter& p, const QRectF& box) const;
  void paintBeside(QPainter& p, const QRectF& box) const;
  void paintLegend(QPainter& p, const QRectF& box);
  void paintBand(QPainter& p, const QRectF& box, const std::vector<AlarmSpan>& spans, const QColor& color) const;
  void paintMarks(QPainter& p, const QRectF& box) const;
  void paintAxis(QPainter& p, const QRectF& box) const;
  void paintSpeed(QPainter& p, const QRectF& box) const;
  std::pair<double, double> speedRange() const;  // slowest and fastest [rpm]; both 0: not known
  QString tickText(double seconds, double step) const;

  Theme theme_;
  std::shared_ptr<const SessionSummary> summary_;
  std::shared_ptr<const SessionSummary> beside_;
  std::vector<AlarmSpan> recorded_, besideAlarms_;
  std::vector<DetectorTrack> tracks_;
  std::vector<Mark> marks_;
  ReplayState replay_;
  double viewFrom_ = 0.0, viewTo_ = 0.0;
  double from_ = 0.0, to_ = 0.0;
  bool clipped_ = false;
  double pressed_ = -1.0;  // x where the button went down; below 0: it is up
};

}  // namespace stillcut::ui
