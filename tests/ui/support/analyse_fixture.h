// The Analyse page opened on six seconds of the scripted cut, and the mouse on its plots.
#pragma once

#include <QWheelEvent>

#include "tests/ui/support/ui_fixture.h"
#include "ui/pages/analyse_page.h"
#include "ui/plots/spectrogram/history_map.h"

namespace stillcut::ui {

class Analyse : public WindowTest {
 protected:
  void openPage() {
    open();
    press("page-analyse");
    play(6.0);
  }
  AnalyseView& view() const { return find<AnalysePage>()->view(); }
  QPoint inMap(double x, double y) const {
    const QRect plot = find<HistoryMap>()->plotRect();
    return {plot.left() + static_cast<int>(x * plot.width()), plot.top() + static_cast<int>(y * plot.height())};
  }
  void drag(QWidget* widget, QPoint from, QPoint to, Qt::KeyboardModifiers keys = {}) const {
    QTest::mousePress(widget, Qt::LeftButton, keys, from);
    QTest::mouseMove(widget, (from + to) / 2);
    QTest::mouseMove(widget, to);
    QTest::mouseRelease(widget, Qt::LeftButton, keys, to);
  }
  void wheel(QWidget* widget, QPoint at, int notches, Qt::KeyboardModifiers keys = {}) const {
    QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, keys, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(widget, &event);
  }
  static int differentPixels(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    }
    return count;
  }
};

}  // namespace stillcut::ui
