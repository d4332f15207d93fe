// A session whose pages show a replay: the machine is commanded as before, and an answer reaches it only where the
// screen has shown what is answered.
#include <gtest/gtest.h>

#include <QTemporaryDir>

#include "app/compose/scenario_rig.h"
#include "app/session/session.h"
#include "tests/support/demo_cut.h"
#include "tests/ui/support/wait_for.h"

namespace stillcut::app {
namespace {

class ReplayBesideACut : public testing::Test {
 protected:
  void SetUp() override {
    const std::string path = folder_.filePath(QStringLiteral("demo.h5")).toStdString();
    auto built = buildScenarioRig(test::demoCut(), {});
    ASSERT_TRUE(built.ok());
    ASSERT_TRUE(built->rig->recordTo(path, "").ok());
    built->rig->runToEnd({});
    ASSERT_TRUE(built->rig->recorder()->finish().ok());
    auto opened = openScenarioSession(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml", false);
    ASSERT_TRUE(opened.ok()) << opened.error().line();
    session_ = std::move(opened).value();
    ui::SessionController& controller = *session_->sessions();
    controller.open(QString::fromStdString(path));
    test::waitFor(controller, [&] { return controller.replay().open && controller.replayed() != nullptr; });
  }
  // Some blocks of the machine's own cut.
  const Snapshot& blocks(int count) {
    for (int k = 0; k < count; ++k) EXPECT_TRUE(session_->advance());
    (void)session_->pull();
    return *session_->live();
  }
  void send(OperatorAction action, Authority authority = Authority::Off, std::uint32_t advice = 0) {
    session_->send({action, authority, advice}, session_->generation());
  }
  void showReplay(bool on) {
    ASSERT_TRUE(session_->sessions()->showEverywhere(on).ok());
    ASSERT_EQ(session_->replayShown(), on);
  }

  QTemporaryDir folder_;
  std::unique_ptr<Session> session_;
};

TEST_F(ReplayBesideACut, AnAdviceThatNobodySawIsNotAccepted) {
  send(OperatorAction::SetAuthority, Authority::Advise);
  for (int k = 0; k < 2000 && !blocks(1).adviceOpen; ++k) continue;
  ASSERT_TRUE(session_->live()->adviceOpen);
  const std::uint32_t advice = session_->live()->adviceNumber;
  showReplay(true);
  EXPECT_NE(session_->pull(), session_->live()) << "the pages show the replay";
  const std::uint32_t ofReplay = session_->generation();
  send(OperatorAction::Accept, Authority::Off, advice);
  EXPECT_FALSE(blocks(3).commanding) << "whose number may be the same by chance";
  showReplay(false);
  session_->send({OperatorAction::Accept, Authority::Off, advice}, ofReplay);
  EXPECT_FALSE(blocks(3).commanding) << "touched while the replay was on the screen";
  ASSERT_TRUE(session_->live()->adviceOpen);
  send(OperatorAction::Accept, Authority::Off, session_->live()->adviceNumber);
  EXPECT_TRUE(blocks(20).commanding) << "now it was seen";
}

TEST_F(ReplayBesideACut, OffActsOnTheMachineAndWhoeverGivesAuthoritySeesIt) {
  send(OperatorAction::SetAuthority, Authority::Advise);
  ASSERT_EQ(blocks(3).authority, Authority::Advise);
  showReplay(true);
  send(OperatorAction::SetAuthority, Authority::Off);
  EXPECT_EQ(blocks(3).authority, Authority::Off);
  EXPECT_TRUE(session_->replayShown()) << "nothing is in our hands: the replay may stay";
  (void)session_->sessions()->poll();
  send(OperatorAction::SetAuthority, Authority::Advise);
  EXPECT_FALSE(session_->replayShown());
  EXPECT_EQ(session_->pull(), session_->live());
  EXPECT_TRUE(session_->sessions()->poll()) << "the page is told";
  EXPECT_EQ(blocks(3).authority, Authority::Advise);
}

}  // namespace
}  // namespace stillcut::app
