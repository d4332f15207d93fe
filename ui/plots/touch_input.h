// Fingers on a plot, or on a page that is longer than its window. A tap is a click on what lies under it. One finger
// moves the picture where `pans` says so, and is the mouse's elsewhere: what it began on is pressed only then, so that
// a page can be taken hold of by its buttons and sliders. Two fingers zoom along the axis they lie along, and move. A
// picture that was flung runs on and comes to rest. The mouse itself works as ever. GUI thread.
#pragma once

#include <QElapsedTimer>
#include <QEvent>
#include <QObject>
#include <QPointF>
#include <QPointer>
#include <QTimer>
#include <functional>
#include <optional>
#include <vector>

class QAbstractScrollArea;
class QTouchEvent;
class QWidget;

namespace stillcut::ui {

class TouchInput : public QObject {
  Q_OBJECT
 public:
  struct Moves {
    // The picture goes along by so many pixels.
    std::function<void(QPointF by)> pan;
    // What is shown becomes `factor` times as long along one axis; what is at `around` stays there. Empty: no zoom.
    std::function<void(double factor, QPointF around, Qt::Orientation along)> zoom;
    // Whether a finger that begins to move this way moves the picture. Empty: one finger is the mouse.
    std::function<bool(QPointF by)> pans;
    bool flings = false;  // the mouse's own drag moves the picture as `pan` does, so it may run on
  };
  // `surface` owns it.
  TouchInput(QWidget* surface, Moves moves);

  // Long pages, lists and tables. Once for each.
  static void scroll(QAbstractScrollArea& area);

  bool running() const { return timer_.isActive(); }
  // In the place of the real time [ms].
  void setClock(std::function<qint64()> clock) { clock_ = std::move(clock); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Does { Nothing, Press, Pan, Pinch };
  struct Pair {
    QPointF a, b;
  };
  struct Seen {
    qint64 ms;
    QPointF at;
  };
  void touched(const QTouchEvent& event);
  void moveOne(const QPointF& to);
  void liftOne(const QPointF& at);
  void pinch(const Pair& now);
  void fling();
  void runOn();
  void tap();
  void press(QEvent::Type how);
  void mouse(QEvent::Type type, const QPointF& at);

  QWidget* surface_;
  Moves moves_;
  std::function<qint64()> clock_;
  QElapsedTimer time_;
  QTimer timer_;
  Does does_ = Does::Nothing;
  QPointF begin_, last_;
  std::optional<Pair> pair_;
  std::vector<Seen> seen_;      // where one finger has been lately
  QPointer<QWidget> pressed_;   // what the finger began on
  std::optional<Seen> tapped_;  // the tap before
  QPointF velocity_;            // [px/s] while it runs on
  qint64 ran_ms_ = 0;
  bool sending_ = false;
};

}  // namespace stillcut::ui
