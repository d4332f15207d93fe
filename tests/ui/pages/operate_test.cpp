// The operator page driven as a person at the machine would: by touch and by key.
#include "tests/ui/support/ui_fixture.h"
#include "ui/base/format.h"
#include "ui/pages/intervention_list.h"
#include "ui/plots/spectrogram/spectrogram_widget.h"
#include "ui/shell/display_panel.h"
#include "ui/shell/manual_panel.h"
#include "ui/shell/page_table.h"
#include "ui/widgets/advice_panel.h"
#include "ui/widgets/command_bar.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/status_strip.h"
#include "ui/widgets/verdict_sign.h"

namespace stillcut {

inline bool operator==(const OperatorInput& a, const OperatorInput& b) {
  return a.action == b.action && a.authority == b.authority;
}

}  // namespace stillcut

namespace stillcut::ui {
namespace {

class Operate : public WindowTest {
 protected:
  const VerdictView& verdict() const { return find<VerdictSign>()->view(); }
  const AdviceView& advice() const { return find<AdvicePanel>()->view(); }
  void playToChatter() {
    for (int k = 0; k < 200 && session_.snapshot().verdicts[0].state != CutState::Chatter; ++k) play(0.04);
    play(0.2);
    ASSERT_EQ(session_.snapshot().verdicts[0].state, CutState::Chatter);
  }
  OperatorInput lastSent() const { return session_.sent().empty() ? OperatorInput{} : session_.sent().back(); }
  bool enabled(const QString& name) const { return find<TouchButton>(name)->isEnabled(); }
};

TEST_F(Operate, TellsTheStoryFromStableToChatterToQuiet) {
  open();
  EXPECT_EQ(verdict().word, "NO VERDICT");
  press("advise");
  play(2);
  EXPECT_EQ(verdict().word, "STABLE");
  EXPECT_EQ(advice().target, "Nothing to do");
  EXPECT_FALSE(enabled("accept"));
  playToChatter();
  EXPECT_EQ(verdict().word, "CHATTER");
  EXPECT_TRUE(verdict().kind.contains("regenerative"));
  EXPECT_EQ(advice().mode, AdviceView::Mode::Open);
  EXPECT_TRUE(enabled("accept"));
  press("accept");
  EXPECT_EQ(lastSent().action, OperatorAction::Accept);
  play(2);
  EXPECT_EQ(verdict().word, "STABLE");
  EXPECT_EQ(advice().mode, AdviceView::Mode::InForce);
  EXPECT_EQ(find<InterventionList>()->shownCards(), 2);
}

TEST_F(Operate, SaysHowMuchDeeperAStableCutCouldGoAndNothingOfOneThatChatters) {
  open();
  play(2);
  EXPECT_TRUE(advice().feed.isEmpty()) << "nobody can tell";
  session_.setDepthMargin(DepthMargin{Metres(0.42e-3), Metres(0.21e-3), Metres(0.68e-3)});
  play(0.1);
  EXPECT_EQ(advice().feed, QStringLiteral("Depth could rise by about 0.4\u00a0mm (0.2 to 0.7)"));
  session_.setDepthMargin(DepthMargin{Metres(0.01e-3), Metres(-0.1e-3), Metres(0.1e-3)});
  play(0.1);
  EXPECT_TRUE(advice().feed.contains(QStringLiteral("close to its limit")));
  playToChatter();
  EXPECT_FALSE(advice().feed.contains(QStringLiteral("limit")));
}

TEST_F(Operate, AcceptAndRefuseByKey) {
  open();
  press("advise");
  playToChatter();
  QTest::keyClick(window_.get(), Qt::Key_F6);
  EXPECT_EQ(lastSent().action, OperatorAction::Refuse);
  play(0.04);
  QTest::keyClick(window_.get(), Qt::Key_F5);
  EXPECT_EQ(lastSent().action, OperatorAction::Accept);
}

TEST_F(Operate, NothingCanBeAcceptedThatIsNotOffered) {
  open();
  play(1);
  press("accept");
  QTest::keyClick(window_.get(), Qt::Key_F5);
  EXPECT_TRUE(session_.sent().empty());
}

TEST_F(Operate, AuthorityIsShownAsTheSessionSaysNotAsTouched) {
  open();
  play(1);
  session_.snapshot().authority = Authority::Off;
  press("advise");
  EXPECT_EQ(lastSent(), (OperatorInput{OperatorAction::SetAuthority, Authority::Advise}));
  session_.snapshot().authority = Authority::Off;  // the gate has refused
  session_.touch();
  tick(40);
  EXPECT_TRUE(find<TouchButton>("off")->isChecked());
  EXPECT_FALSE(find<TouchButton>("advise")->isChecked());
}

TEST_F(Operate, AutoWithAWatchdogTakesOneTouch) {
  open();
  play(1);
  EXPECT_EQ(find<TouchButton>("auto")->hint(), QStringLiteral("F4"));
  press("auto");
  EXPECT_EQ(lastSent(), (OperatorInput{OperatorAction::SetAuthority, Authority::Auto}));
}

TEST_F(Operate, AutoWithoutAWatchdogTakesADeliberateSecondTouch) {
  session_.mutableInfo().machineWatchdog = false;
  open();
  play(1);
  EXPECT_EQ(find<TouchButton>("auto")->hint(), QStringLiteral("F4, no watchdog"));  // said before it is chosen
  press("auto");
  EXPECT_TRUE(session_.sent().empty());
  EXPECT_TRUE(find<TouchButton>("auto")->asking());
  tick(100);
  press("auto");  // a bouncing finger
  EXPECT_TRUE(session_.sent().empty());
  tick(1100);
  press("auto");
  EXPECT_EQ(lastSent(), (OperatorInput{OperatorAction::SetAuthority, Authority::Auto}));
  EXPECT_FALSE(find<TouchButton>("auto")->asking());
}

TEST_F(Operate, AKeyThatIsHeldDownIsNoSecondTouch) {
  session_.mutableInfo().machineWatchdog = false;
  open();
  play(1);
  press("auto");
  tick(660);  // until a keyboard repeats
  for (int k = 0; k < 60; ++k) {
    press("auto");
    tick(40);
  }
  EXPECT_TRUE(session_.sent().empty());
}

TEST_F(Operate, TheQuestionForASecondTouchIsWithdrawn) {
  session_.mutableInfo().machineWatchdog = false;
  open();
  play(1);
  press("auto");
  tick(6000);
  EXPECT_FALSE(find<TouchButton>("auto")->asking());
  press("auto");
  EXPECT_TRUE(session_.sent().empty()) << "a touch long after the question is a first touch again";
  press("off");
  EXPECT_FALSE(find<TouchButton>("auto")->asking());
}

TEST_F(Operate, AutoThatIsNotGrantedCannotBeTouched) {
  open();
  session_.advance(Seconds(1));
  session_.snapshot().autoAllowed = false;
  tick(40);
  EXPECT_FALSE(enabled("auto"));
  press("auto");
  EXPECT_TRUE(session_.sent().empty());
}

TEST_F(Operate, BackTo100WorksByTouchByKeyAndWhenStale) {
  open();
  play(1);
  press("back");
  EXPECT_EQ(lastSent().action, OperatorAction::BackToProgrammed);
  QTest::keyClick(window_.get(), Qt::Key_Backspace);
  EXPECT_EQ(session_.sent().size(), 2U);
  tick(5000);
  press("back");
  EXPECT_EQ(session_.sent().size(), 3U);
}

TEST_F(Operate, HoldAndEndHold) {
  open();
  play(1);
  press("hold");
  EXPECT_EQ(lastSent().action, OperatorAction::Hold);
  play(0.04);
  EXPECT_EQ(find<TouchButton>("hold")->text(), "END HOLD");
  press("hold");
  EXPECT_EQ(lastSent().action, OperatorAction::EndHold);
}

TEST_F(Operate, AlarmsAreJudgedWithOneTouch) {
  session_.snapshot().interventionCount = 0;
  open();
  play(1);
  EXPECT_FALSE(enabled("was-false"));
  playToChatter();
  press("was-false");
  EXPECT_EQ(lastSent().action, OperatorAction::FalseAlarm);
  EXPECT_TRUE(find<TouchButton>("was-false")->isChecked());
  press("was-true");
  EXPECT_EQ(lastSent().action, OperatorAction::TrueAlarm);
  EXPECT_FALSE(find<TouchButton>("was-false")->isChecked());
}

// An alarm is counted once, and the touch names it.
TEST_F(Operate, AMarkOfAnAlarmIsTakenBackByTheSameTouchAndReplacedByTheOther) {
  open();
  playToChatter();
  press("was-false");
  EXPECT_TRUE(find<TouchButton>("was-false")->hint().contains("undo"));
  press("was-false");
  EXPECT_EQ(lastSent().action, OperatorAction::UndoMark);
  EXPECT_FALSE(find<TouchButton>("was-false")->isChecked());
  press("was-false");
  press("was-true");
  // Of one alarm all three: the recording keeps its last mark alone (Markers.AnAlarmHasOneMark).
  const double alarm = lastSent().value;
  EXPECT_NE(alarm, 0.0);
  for (const OperatorInput& input : session_.sent()) EXPECT_EQ(input.value, alarm);
  EXPECT_EQ(lastSent().action, OperatorAction::TrueAlarm);
  const Snapshot& s = session_.snapshot();
  const Instant began = s.interventions[(s.interventionCount - 1) % kInterventionsShown].began;
  EXPECT_TRUE(find<TouchButton>("was-true")->hint().contains(clockTime(session_.info().wallMs(began))));
}

TEST_F(Operate, AMarkNamesItsAlarmSoThatALaterMarkLeavesItAlone) {
  open();
  play(1);
  const Snapshot& s = session_.snapshot();
  const double began = sinceEpoch(s.interventions[(s.interventionCount - 1) % kInterventionsShown].began).value;
  press("was-true");
  EXPECT_EQ(lastSent().value, began);
  press("hear");
  EXPECT_EQ(lastSent().action, OperatorAction::ReportChatter);
  play(0.1);
  press("was-true");
  EXPECT_EQ(lastSent().action, OperatorAction::UndoMark);
  EXPECT_EQ(lastSent().value, began) << "that of the alarm, not the newer one";
  press("hear");
  EXPECT_EQ(lastSent().action, OperatorAction::UndoMark);
  EXPECT_EQ(lastSent().value, 0.0);
  press("was-true");
  Snapshot& now = session_.snapshot();
  now.interventions[now.interventionCount++ % kInterventionsShown].began = now.time;
  play(0.1);
  EXPECT_TRUE(enabled("was-true"));
  EXPECT_FALSE(find<TouchButton>("was-true")->isChecked()) << "another alarm";
}

TEST_F(Operate, EscClosesWhatIsOnTopAndNeverMovesTheMachine) {
  session_.mutableInfo().machineWatchdog = false;
  open();
  play(1);
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QTest::keyClick(window_.get(), Qt::Key_F1);
  ASSERT_TRUE(find<ManualPanel>()->isVisible());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_FALSE(find<ManualPanel>()->isVisible());
  QTest::keyClick(window_.get(), Qt::Key_F11);
  ASSERT_TRUE(find<DisplayPanel>()->isVisible());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_FALSE(find<DisplayPanel>()->isVisible());
  press("auto");
  ASSERT_TRUE(find<TouchButton>("auto")->asking());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  EXPECT_FALSE(find<TouchButton>("auto")->asking());
  EXPECT_TRUE(session_.sent().empty());
}

TEST_F(Operate, AFaultStandsOverTheNewestCardInLargeLetters) {
  open();
  play(1);
  const auto* list = find<InterventionList>();
  EXPECT_GT(list->shownCards(), 0);
  Snapshot& s = session_.snapshot();
  s.eventCount = 1;
  s.events[0] = {s.time, 0, EventLevel::Fault, {ReasonCode::StrategyFault, {}}};
  tick(40);
  EXPECT_GT(list->shownCards(), 0);
  const QColor red = makeTheme(ThemeKind::Light, 1.0).colors.chatter;
  const QPoint inside = list->mapTo(window_.get(), QPoint(24, 60));
  EXPECT_EQ(picture().pixelColor(inside), red);
  EXPECT_FALSE(list->clipped());
  s.events[0].level = EventLevel::Warning;
  tick(40);
  EXPECT_NE(picture().pixelColor(inside), red) << "only a fault is worth that";
}

TEST_F(Operate, NoAlarmAndNoAdviceGoesUnseenOnAnotherPage) {
  open();
  press("advise");
  playToChatter();
  const auto* accept = find<TouchButton>("accept-here");
  EXPECT_FALSE(accept->isVisible()) << "the page has its own";
  for (const PageEntry& entry : pageTable()) {
    if (QLatin1String(entry.id) == QStringLiteral("operate")) continue;
    window_->showPage(QLatin1String(entry.id));
    tick(40);
    const CommandView& bar = find<CommandBar>()->view();
    EXPECT_EQ(bar.verdict.word, "CHATTER") << entry.id;
    EXPECT_EQ(bar.verdict.shape, Shape::Octagon) << entry.id;
    EXPECT_TRUE(accept->isVisible() && accept->isEnabled()) << entry.id;
    EXPECT_TRUE(accept->hint().contains(bar.advice) && !bar.advice.isEmpty()) << entry.id;
    EXPECT_FALSE(find<CommandBar>()->clipped() || accept->clipped()) << entry.id;
  }
  const std::uint32_t number = session_.snapshot().adviceNumber;
  QTest::keyClick(window_.get(), Qt::Key_F5);
  EXPECT_EQ(lastSent().action, OperatorAction::Accept);
  EXPECT_EQ(lastSent().advice, number);
}

TEST_F(Operate, AStalePictureSaysSoEverywhere) {
  open();
  play(3);
  tick(2300);
  EXPECT_EQ(verdict().word, "NO VERDICT");
  EXPECT_TRUE(verdict().detail.contains("stale"));
  EXPECT_EQ(advice().target, "No advice");
  EXPECT_EQ(find<StatusStrip>()->items()[1].tone, Tone::Chatter);
  play(0.04);
  EXPECT_EQ(verdict().word, "STABLE");
}

TEST_F(Operate, ChatterPaintsThePanelRedAndQuietGrey) {
  open();
  play(2);
  const Theme theme = makeTheme(ThemeKind::Light, 1.0);
  const auto colour = [&] { return find<VerdictSign>()->grab().toImage().pixelColor(20, 20); };
  EXPECT_EQ(colour(), theme.colors.panel);
  playToChatter();
  EXPECT_EQ(colour(), theme.colors.chatter);
}

TEST_F(Operate, EveryControlHasANameForScreenReaders) {
  open();
  play(1);
  for (const TouchButton* button : window_->findChildren<TouchButton*>())
    EXPECT_FALSE(button->accessibleName().isEmpty());
  EXPECT_TRUE(find<VerdictSign>()->accessibleDescription().contains("STABLE"));
  EXPECT_FALSE(find<SpectrogramWidget>()->accessibleName().isEmpty());
}

TEST_F(Operate, ChatterThatNobodyToldOfIsMarkedInOneTouch) {
  open();
  EXPECT_FALSE(enabled("hear")) << "nothing is measured yet";
  play(2.0);
  press("hear");
  EXPECT_EQ(lastSent().action, OperatorAction::ReportChatter);
  EXPECT_TRUE(find<TouchButton>("hear")->isChecked());
  press("hear");
  EXPECT_EQ(lastSent().action, OperatorAction::UndoMark);
  EXPECT_FALSE(find<TouchButton>("hear")->isChecked());
  press("hear");
  playToChatter();
  EXPECT_FALSE(enabled("hear")) << "it has been told";
  EXPECT_FALSE(find<TouchButton>("hear")->isChecked());
}

TEST_F(Operate, ThemesFollowTheKey) {
  open();
  EXPECT_EQ(window_->look().theme, ThemeKind::Light);
  QTest::keyClick(window_.get(), Qt::Key_F12);
  EXPECT_EQ(window_->look().theme, ThemeKind::Dark);
  press("display");
  press("theme-2");
  QCoreApplication::processEvents();
  EXPECT_EQ(window_->look().theme, ThemeKind::HighContrast);
}

}  // namespace
}  // namespace stillcut::ui
