// How much deeper a simulated stable cut could go, told from its signal beside what the exact lobes know of it.
#include "app/session/lobes/margin_watch.h"

#include <gtest/gtest.h>

#include <QFile>

#include "app/session/cut_run.h"
#include "core/milling/simulation/scenario.h"
#include "core/milling/stability/exact_lobes.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

// The demonstration's cut at one depth throughout.
class Margin : public testing::Test {
 protected:
  void open(const char* depthMm) {
    QFile demo(QStringLiteral(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml"));
    ASSERT_TRUE(demo.open(QIODevice::ReadOnly));
    QByteArray text = demo.readAll();
    for (const char* deeper : {"0.7", "1.5", "1.8"}) {
      for (const char* key : {"\nvalue = ", "\nfrom_value = ", "\nto_value = "}) {
        text.replace(QByteArray(key) + deeper, QByteArray(key) + depthMm);
      }
    }
    text.replace("duration_s = 30.0", "duration_s = 14.0").replace("exit_at_s = 29.0", "exit_at_s = 13.0");
    const std::string path = folder_ / "cut.toml";
    QFile file(QString::fromStdString(path));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    file.close();
    auto scenario = milling::loadScenario(path);
    ASSERT_TRUE(scenario.ok()) << scenario.error().line();
    scenario_ = *scenario;
    auto run = openScenarioRun(path, false);
    ASSERT_TRUE(run.ok()) << run.error().line();
    run_ = std::move(run).value();
    run_->send({OperatorAction::SetAuthority, Authority::Off});
  }
  Metres depth() const { return Metres(scenario_.programme.depth.highest(0.0)); }
  void learns(bool described) {
    std::optional<learn::CutEvidence> cut;
    if (described) {
      cut.emplace();
      cut->assembly.machine = "Mill 3";
      cut->assembly.tool = "T12";
      cut->teeth = scenario_.model.tool.teeth;
      cut->diameter = scenario_.model.tool.diameter;
      cut->depth = depth();
      cut->engagement = scenario_.model.engagement;
    }
    run_->lobes()->learnFrom(folder_ / "cuts.sqlite", cut);
    run_->tellMargin();
  }
  // What was told last while it cut.
  std::optional<ui::DepthMargin> toTheEnd() {
    std::optional<ui::DepthMargin> told;
    constexpr int kBlocks = 3;  // a display tick
    for (bool more = true; more;) {
      for (int k = 0; k < kBlocks && more; ++k) more = run_->rig().advance();
      run_->read();
      run_->readSignal([](const SampleBlock&) {});
      if (run_->lobes()->learnedWorker() != nullptr) run_->lobes()->learnedWorker()->wait();
      if (run_->margin()) told = run_->margin();
    }
    return told;
  }

  record::TempFolder folder_;
  milling::Scenario scenario_;
  std::unique_ptr<CutRun> run_;
};

TEST_F(Margin, HoldsTheExactLimitOfAStableCutAndIsGoneWithTheCut) {
  open("0.7");
  learns(true);
  const auto told = toTheEnd();
  ASSERT_TRUE(told.has_value());
  milling::LimitOptions options;
  options.maxAxialDepth = Metres(4e-3);
  options.firstOnly = true;
  const auto lobes = milling::ExactLobes::make(scenario_.model, "test");
  ASSERT_TRUE(lobes.ok());
  const auto limits = lobes->limits(scenario_.programme.speed, options);
  ASSERT_TRUE(limits.ok() && limits->hasLimit());
  const double left = (limits->crossings.front().depth - depth()).value;
  EXPECT_NEAR(told->rise.value, left, 0.3 * left) << told->low.value << " to " << told->high.value;
  EXPECT_LT(told->low.value, left);
  EXPECT_GT(told->high.value, left);
  EXPECT_FALSE(run_->margin()) << "the tool has left the material";
}

TEST_F(Margin, NothingIsToldOfACutThatChattersOrIsNotDescribed) {
  open("1.5");
  learns(true);
  EXPECT_FALSE(toTheEnd());
  open("0.7");
  learns(false);
  EXPECT_FALSE(toTheEnd());
}

}  // namespace
}  // namespace stillcut::app
