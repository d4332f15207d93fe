// How a run begins and ends on the screens: since when somebody is in command, what is no news, why nothing more comes.
#include <gtest/gtest.h>

#include "tests/ui/support/pictures.h"
#include "ui/base/format.h"
#include "ui/models/advice_view.h"
#include "ui/models/plot_state_text.h"
#include "ui/models/strip_view.h"
#include "ui/models/verdict_view.h"

namespace stillcut::ui {
namespace {

Scene alarmScene() {
  Scene s = stableScene();
  s.verdict().state = CutState::Chatter;
  s.verdict().frequency = Hertz(1713);
  return s;
}

TEST(AdviceView, UnderOffNoWishOfTheStrategyIsTold) {
  Scene s = alarmScene();
  s.snapshot.request.kind = RequestKind::Set;
  s.snapshot.request.reason = {ReasonCode::CentreOfNextPocket, {8565, 3, 1713, 8800}};
  EXPECT_TRUE(makeAdviceView(s.picture()).reason.contains("Authority is off"));
  s.snapshot.request.kind = RequestKind::None;
  s.snapshot.request.reason = {ReasonCode::TeethNotKnown, {1713, 8800}};
  EXPECT_FALSE(makeAdviceView(s.picture()).reason.contains("Authority is off")) << "what is missing is told";
}

TEST(CommandView, AnAuthorityThatNobodyHasChangedIsAsOldAsTheRun) {
  Scene s = stableScene();
  s.snapshot.health.blocks = 200;
  s.snapshot.health.blockLength = Seconds(0.01);
  const auto at = [&](int seconds) {
    return "since " + clockTime(s.info.wallMs(instantFromNs(seconds * 1'000'000'000LL)));
  };
  EXPECT_EQ(makeCommandView(s.picture()).since, at(8));
  s.snapshot.authoritySince = instantFromNs(9'000'000'000);
  EXPECT_EQ(makeCommandView(s.picture()).since, at(9));
}

TEST(EventLine, AMachineThatHadNotAnsweredYetWhenTheRunBeganIsNoNewsOnceItDoes) {
  Scene s = stableScene();  // at 10 s
  s.snapshot.health.blocks = 500;
  s.snapshot.health.blockLength = Seconds(0.01);
  s.snapshot.eventCount = 1;
  Event& lost = s.snapshot.events[0];
  lost = {.time = instantFromNs(5'010'000'000), .level = EventLevel::Warning, .reason = {ReasonCode::LinkLost, {0.01}}};
  EXPECT_TRUE(makeEventLine(s.picture()).text.isEmpty());
  s.snapshot.machine.linkUp = false;
  EXPECT_FALSE(makeEventLine(s.picture()).text.isEmpty()) << "it still does not";
  s.snapshot.machine.linkUp = true;
  lost.time = instantFromNs(6'000'000'000);
  EXPECT_FALSE(makeEventLine(s.picture()).text.isEmpty()) << "it had, and was lost";
}

TEST(Views, ARunThatIsOverSaysWhyAndHowToGoOn) {
  Scene s = alarmScene();
  s.snapshot.authority = Authority::Auto;
  s.snapshot.autoAllowed = s.snapshot.commanding = true;
  s.snapshot.command.kind = CommandKind::Set;
  s.snapshot.command.speed = s.snapshot.machine.speedOverride = Ratio(0.8);
  Picture p = s.picture();
  p.stale = true;
  p.age = Seconds(40.0);
  p.link.ended = "ALSA hw:1: unplugged";
  const VerdictView verdict = makeVerdictView(p, Trend::Growing);
  EXPECT_EQ(verdict.word, "NO VERDICT");
  EXPECT_EQ(verdict.detail, p.link.ended) << "not stale: nothing more is waited for";
  const AdviceView advice = makeAdviceView(p);
  EXPECT_EQ(advice.mode, AdviceView::Mode::Nothing) << "nothing is in force";
  EXPECT_TRUE(advice.reason.contains("Set up")) << advice.reason.toStdString();
  const CommandView command = makeCommandView(p);
  EXPECT_EQ(command.authority, Authority::Off);
  EXPECT_FALSE(command.live || command.autoAllowed);
  EXPECT_EQ(command.inCommand, "You are in command");
  EXPECT_EQ(command.since, p.link.ended);
  EXPECT_TRUE(command.moved.isEmpty()) << "nobody reads the overrides any more";
  EXPECT_EQ(plotStateTitle("SIGNAL", p.plotState()), "SIGNAL, ENDED");
  p.link.ended.clear();
  EXPECT_EQ(p.plotState(), PlotState::Stale);
  EXPECT_EQ(makeCommandView(p).authority, Authority::Auto);
}

}  // namespace
}  // namespace stillcut::ui
