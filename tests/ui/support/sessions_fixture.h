// The Sessions page on a desk with three recordings.
#pragma once

#include <QLineEdit>
#include <QListView>

#include "tests/ui/support/fake_session_desk.h"
#include "tests/ui/support/ui_fixture.h"
#include "ui/plots/session_timeline.h"

namespace stillcut::ui {

class SessionsPageTest : public WindowTest {
 protected:
  void openSessions(int width = 1280, int height = 800, ThemeKind theme = ThemeKind::Light) {
    session_.setSessions(&controller_);
    open(width, height, theme);
    window_->showPage(QStringLiteral("sessions"));
    play(0.2);
  }
  void openFirst() {
    auto* list = find<QListView>("session-list");
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(0, 0)).center());
    tick(40);
  }
  QPoint at(double seconds) const {
    const auto* timeline = find<SessionTimeline>();
    // The axis begins behind the names of the rows; found by asking the widget itself.
    return {static_cast<int>(left_ + seconds / 30.0 * (right_ - left_)), timeline->height() / 3};
  }
  // Learns where the axis lies from what clicks near its ends say.
  void measureAxis() {
    auto* timeline = find<SessionTimeline>();
    const auto timeOf = [&](int x) {
      QTest::mouseClick(timeline, Qt::LeftButton, {}, QPoint(x, timeline->height() / 3));
      return controller_.state.position.value;
    };
    const int a = timeline->width() / 3, b = timeline->width() * 2 / 3;
    const double ta = timeOf(a), tb = timeOf(b);
    ASSERT_GT(tb, ta);
    const double perSecond = (b - a) / (tb - ta);
    left_ = a - ta * perSecond;
    right_ = left_ + 30.0 * perSecond;
  }

  FakeSessionDesk controller_;
  double left_ = 0.0, right_ = 1.0;
};

}  // namespace stillcut::ui
