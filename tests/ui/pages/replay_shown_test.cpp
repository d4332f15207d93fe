// A replay in the place of the cut: what commands the machine shows the machine and acts on it, and nothing that was
// advised or heard in the replay can be answered.
#include <QLabel>

#include "tests/ui/support/ui_fixture.h"
#include "ui/shell/page_table.h"
#include "ui/widgets/command_bar.h"
#include "ui/widgets/status_strip.h"

namespace stillcut::ui {
namespace {

class ReplayShown : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    FakeSession other;
    other.send({OperatorAction::SetAuthority, Authority::Advise}, 0);
    while (!other.snapshot().adviceOpen) other.advance(Seconds(0.04));
    recorded_ = other.snapshot();
    recorded_.operatorHold = true;
    open();
    play(0.4);
  }
  bool enabled(const char* name) const { return find<TouchButton>(QLatin1String(name))->isEnabled(); }

  Snapshot recorded_;
};

TEST_F(ReplayShown, TheBarAndTheStripAreOfTheMachine) {
  session_.showReplay(recorded_);
  tick(40);
  EXPECT_TRUE(find<TouchButton>("off")->isChecked()) << "whatever was in force in the recording";
  EXPECT_EQ(find<TouchButton>("hold")->text(), QStringLiteral("HOLD"));
  EXPECT_TRUE(find<CommandBar>()->accessibleDescription().contains(QStringLiteral("live, since")));
  press("hold");
  EXPECT_EQ(session_.sent().back().action, OperatorAction::Hold);
  press("off");
  EXPECT_EQ(session_.sent().back().action, OperatorAction::SetAuthority) << "Off is sent though it seems to be off";
  EXPECT_EQ(session_.sent().back().authority, Authority::Off);
  press("back");
  EXPECT_EQ(session_.sent().back().action, OperatorAction::BackToProgrammed);
  play(2.0);  // the replay stands still, the machine does not
  QStringList told;
  for (const StripItem& item : find<StatusStrip>()->items()) {
    EXPECT_NE(item.tone, Tone::Chatter) << item.label.toStdString() << ' ' << item.value.toStdString();
    told << item.value;
  }
  EXPECT_TRUE(told.contains(QStringLiteral("ok"))) << told.join(u',').toStdString();
}

// The page tells of the recording; the machine chatters, and its word stands in the bar of this page too.
TEST_F(ReplayShown, TheLiveVerdictStandsInTheBarOfEveryPage) {
  Snapshot quiet = recorded_;
  quiet.verdicts[0].state = CutState::Stable;
  session_.showReplay(quiet);
  play(7.0);
  const QImage before = find<CommandBar>()->grab().toImage();
  EXPECT_EQ(find<CommandBar>()->view().verdict.word, QStringLiteral("CHATTER"));
  const QColor red = makeTheme(ThemeKind::Light, 1.0).onPanel(Tone::Chatter);
  bool drawn = false;
  for (int y = 0; y < before.height() && !drawn; ++y) {
    for (int x = 0; x < before.width() && !drawn; ++x) drawn = before.pixelColor(x, y) == red;
  }
  EXPECT_TRUE(drawn) << "its shape is on the screen";
}

TEST_F(ReplayShown, NothingInItCanBeAnsweredOrJudged) {
  session_.showReplay(recorded_);
  tick(40);
  for (const char* name : {"accept", "refuse", "was-true", "was-false", "hear"}) EXPECT_FALSE(enabled(name)) << name;
  for (const Qt::Key key : {Qt::Key_F5, Qt::Key_F6, Qt::Key_F8, Qt::Key_F9, Qt::Key_F10}) {
    QTest::keyClick(window_.get(), key);
  }
  EXPECT_TRUE(session_.sent().empty());
}

// It stands still because somebody wants it so.
TEST_F(ReplayShown, APausedReplaySaysSoAndIsNotStale) {
  const auto told = [this] {
    QString all;
    for (const QWidget* widget : window_->findChildren<QWidget*>()) {
      if (!widget->isVisible()) continue;
      all += widget->accessibleDescription() + u'\n';
      if (const auto* label = qobject_cast<const QLabel*>(widget)) all += label->text() + u'\n';
    }
    return all;
  };
  session_.showReplay(recorded_);
  session_.setStands(true);
  for (const PageEntry& entry : pageTable()) {
    window_->showPage(QLatin1String(entry.id));
    play(2.0);
    EXPECT_FALSE(told().contains(QStringLiteral("stale"), Qt::CaseInsensitive)) << entry.id << told().toStdString();
    EXPECT_FALSE(told().contains(QStringLiteral("Nothing new arrives"))) << entry.id;
  }
  window_->showPage(QStringLiteral("operate"));
  play(0.1);
  EXPECT_TRUE(told().contains(QStringLiteral("The replay is paused")));
  EXPECT_TRUE(told().contains(QStringLiteral("CHATTER"))) << "what was the verdict there is still said";
  session_.setStands(false);  // it should move and does not
  play(2.0);
  EXPECT_TRUE(told().contains(QStringLiteral("stale")));
  EXPECT_FALSE(told().contains(QStringLiteral("The replay is paused")));
}

TEST_F(ReplayShown, WhatIsAnsweredSaysOfWhichRunItWas) {
  press("advise");
  while (!session_.snapshot().adviceOpen) play(0.04);
  ASSERT_TRUE(enabled("accept"));
  press("accept");
  ASSERT_EQ(session_.sent().back().action, OperatorAction::Accept);
  EXPECT_EQ(session_.seen().back(), session_.generation());
  // Something else is opened, and the finger is quicker than the screen.
  session_.openOther("Mill 7");
  press("off");
  EXPECT_EQ(session_.seen().back() + 1, session_.generation());
}

}  // namespace
}  // namespace stillcut::ui
