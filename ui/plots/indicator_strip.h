// One indicator of a detector over the last seconds, with the limit that decides beside it as it was at each moment: an
// alarm is where the line passes it. Times are the clock's. GUI thread.
#pragma once

#include <QWidget>
#include <deque>

#include "core/base/time.h"
#include "core/model/verdict.h"
#include "ui/base/themed.h"

namespace stillcut::ui {

class IndicatorStrip : public QWidget, public Themed {
  Q_OBJECT
 public:
  static constexpr Seconds kShown{20.0};

  struct Point {
    Instant time{};
    double value = 0.0;  // not a number: no verdict
    double limit = 0.0;  // not a number: not known
    CutState state = CutState::AirCutting;
  };

  explicit IndicatorStrip(QWidget* parent = nullptr);

  void add(const Point& point);
  void clear();
  // `wallMs`: the clock on the wall at stream time 0, ms since 1970.
  void display(const QString& name, qint64 wallMs);
  const std::deque<Point>& points() const { return points_; }

  void applyTheme(const Theme& theme) override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double fullScale() const;
  void paintTimes(QPainter& p, const QRectF& plot) const;

  Theme theme_;
  std::deque<Point> points_;
  QString name_;
  qint64 wallMs_ = 0;
};

}  // namespace stillcut::ui
