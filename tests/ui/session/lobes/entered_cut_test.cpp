// A cut that is entered on the Lobes page, without a run: its diagram, and one place of it from near, which says what
// the command `advise` says.
#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "app/session/lobes/entered_cut.h"
#include "core/milling/stability/advice.h"
#include "ui/models/lobe_view.h"

namespace stillcut::app {
namespace {

constexpr Metres kDepth{2e-3};

// Two axes with three and two modes, four teeth, half immersion, down milling.
const char* const kCut = R"(name = "T5 in aluminium"
[[mode]]
frequency_hz = 800.0153409478113
damping = 0.030003404739860035
stiffness_n_per_m = 12003062.88986539
direction = [1.0, 0.0]
[[mode]]
frequency_hz = 1700.006919784976
damping = 0.020007443776906955
stiffness_n_per_m = 29985584.454900466
direction = [1.0, 0.0]
[[mode]]
frequency_hz = 2900.059628528483
damping = 0.015006837353827185
stiffness_n_per_m = 80019997.3330126
direction = [1.0, 0.0]
[[mode]]
frequency_hz = 759.9840578399624
damping = 0.035079963227307616
stiffness_n_per_m = 9994371.724694476
direction = [0.0, 1.0]
[[mode]]
frequency_hz = 1650.049789413741
damping = 0.02502529615226897
stiffness_n_per_m = 24982236.672454327
direction = [0.0, 1.0]
[tool]
teeth = 4
diameter_mm = 20.0
[material]
tangential_n_per_m2 = 800e6
radial_n_per_m2 = 250e6
[engagement]
radial_immersion = 0.5
side = "down"
[chart]
max_depth_mm = 8.0
)";

class EnteredCut : public testing::Test {
 protected:
  QString write(const char* name, const QByteArray& text) const {
    QFile file(folder_.filePath(QLatin1String(name)));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  }
  ui::EnteredCut pocketCut() const {
    auto read = entry_.read({}, write("pocket.toml", kCut));
    EXPECT_TRUE(read.ok());
    ui::EnteredCut cut = read.ok() ? *read : ui::EnteredCut{};
    cut.depth = kDepth;
    return cut;
  }
  static std::shared_ptr<const ui::LobeCloseUp> closeUp(ui::LobeService& lobes, const ui::SpeedDepth& at) {
    lobes.look(at);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
          const auto seen = lobes.closeUp();
          return seen && seen->at == at && seen->pocketsKnown;
        },
        60'000));
    return lobes.closeUp();
  }
  static const ui::Pocket* around(const std::vector<ui::Pocket>& pockets, Rpm speed) {
    const auto found = std::ranges::find_if(
        pockets, [speed](const ui::Pocket& pocket) { return pocket.from <= speed && speed <= pocket.to; });
    return found == pockets.end() ? nullptr : &*found;
  }

  QTemporaryDir folder_;
  EnteredCutLobes entry_;
};

// By an independent program: quiet from 5 821 to 6 150 rev/min at 2 mm, best near 5 980, which carries 2.91 mm; 5 771
// carries 1.825 mm. The tip, 2.95 mm, lies at 5 975.
TEST_F(EnteredCut, APlaceFromNearHasItsEdgesAndItsDepthAndIsWhatTheCommandSays) {
  ui::EnteredCut cut = pocketCut();
  cut.lowest = Rpm(5000);
  cut.highest = Rpm(7000);
  ASSERT_TRUE(entry_.enter(cut).ok());
  ui::LobeService& lobes = *entry_.service();
  EXPECT_EQ(lobes.frame().lowest, Rpm(5000)) << "the machine's range is what is looked at";
  const auto seen = closeUp(lobes, {Rpm(5771), kDepth});
  ASSERT_TRUE(seen->limit);
  EXPECT_NEAR(seen->limit->depth.value, 1.825e-3, 0.01e-3);
  const ui::WhatIf told = ui::whatIf(nullptr, lobes.frame(), seen->at, ui::UnitSystem::Metric, seen.get());
  EXPECT_TRUE(told.verdict.startsWith(QStringLiteral("CHATTER"))) << told.verdict.toStdString();
  const ui::Pocket* pocket = around(seen->pockets, Rpm(5980));
  ASSERT_NE(pocket, nullptr);
  EXPECT_NEAR(pocket->from.value, 5821.0, 1.0);
  EXPECT_NEAR(pocket->to.value, 6150.0, 1.0);
  EXPECT_NEAR(pocket->best.value, 5975.0, 1.0);
  EXPECT_NEAR(pocket->limit.value, 2.954e-3, 0.01e-3);
  EXPECT_TRUE(pocket->reachable);
  EXPECT_NEAR(closeUp(lobes, {Rpm(5980), kDepth})->limit->depth.value, 2.914e-3, 0.005e-3);

  const auto file = loadCutFile(write("pocket.toml", kCut).toStdString());
  ASSERT_TRUE(file.ok());
  milling::AdviceRequest request;
  request.depth = kDepth;
  request.lowest = cut.lowest;
  request.highest = cut.highest;
  const auto advice = milling::adviseSpeeds(file->model, request, "test");
  ASSERT_TRUE(advice.ok());
  ASSERT_EQ(advice->pockets.size(), seen->pockets.size());
  for (std::size_t k = 0; k < seen->pockets.size(); ++k) {
    EXPECT_DOUBLE_EQ(seen->pockets[k].from.value, advice->pockets[k].from.speed.value);
    EXPECT_DOUBLE_EQ(seen->pockets[k].best.value, advice->pockets[k].best.value);
  }
}

TEST_F(EnteredCut, TheDiagramIsRefinedWhereItIsNotStraightAndAtTheEdgesOfTheDepthAskedFor) {
  ui::EnteredCut cut = pocketCut();
  cut.lowest = Rpm(5600);
  cut.highest = Rpm(6300);
  ASSERT_TRUE(entry_.enter(cut).ok());
  ui::LobeService& lobes = *entry_.service();
  ui::LobeQuestion question;
  question.steps = 20;
  question.from = lobes.frame().lowest;
  question.to = lobes.frame().highest;
  question.maxAxialDepth = lobes.frame().maxAxialDepth;
  lobes.ask(question);
  ASSERT_TRUE(QTest::qWaitFor([&] { return lobes.progress().state == ui::LobeProgress::State::Done; }, 60'000))
      << lobes.progress().problem.toStdString();
  const auto diagram = lobes.diagram();
  ASSERT_TRUE(diagram);
  EXPECT_TRUE(std::ranges::is_sorted(diagram->limits, {}, &ui::LobeLimit::speed));
  EXPECT_NEAR(ui::limitAt(*diagram, Rpm(5771))->value, 1.825e-3, 0.02e-3);
  const auto pockets = ui::pocketsAt(*diagram, lobes.frame(), kDepth);
  const ui::Pocket* pocket = around(pockets, Rpm(5980));
  ASSERT_NE(pocket, nullptr);
  EXPECT_NEAR(pocket->from.value, 5821.0, 2.0) << "from steps of 35 rpm";
  EXPECT_NEAR(pocket->to.value, 6150.0, 2.0);
  EXPECT_NEAR(pocket->best.value, 5975.0, 8.0);
}

TEST_F(EnteredCut, WhereNoSpeedIsStableTheDeepestCutIsTold) {
  ui::EnteredCut cut = pocketCut();
  cut.lowest = Rpm(5200);
  cut.highest = Rpm(5600);
  ASSERT_TRUE(entry_.enter(cut).ok());
  const auto seen = closeUp(*entry_.service(), {Rpm(5400), kDepth});
  EXPECT_TRUE(seen->pockets.empty());
  ASSERT_TRUE(seen->deepest);
  EXPECT_LT(seen->deepest->depth, kDepth);
  EXPECT_GT(seen->deepest->depth.value, 0.0);
}

TEST_F(EnteredCut, FieldsGoBeforeTheFileAndAModesFileBringsOnlyItsModes) {
  ui::EnteredCut cut = pocketCut();
  EXPECT_EQ(cut.teeth, 4);
  EXPECT_NEAR(cut.diameter.value, 20e-3, 1e-9);
  EXPECT_FALSE(cut.upMilling);
  EXPECT_EQ(cut.modes.size(), 5U);
  const QString modes = write("modes.toml",
                              "[[mode]]\nfrequency_hz = 950.0\ndamping = 0.02\nstiffness_n_per_m = 3e6\n"
                              "direction = [1.0, 0.0]\n");
  const auto with = entry_.read(cut, modes);
  ASSERT_TRUE(with.ok());
  ASSERT_EQ(with->modes.size(), 1U);
  EXPECT_EQ(with->teeth, 4) << "the rest stays";
  ui::EnteredCut other = *with;
  other.teeth = 2;
  other.material = entry_.materials().front().id;
  ASSERT_TRUE(entry_.enter(other).ok());
  EXPECT_EQ(entry_.service()->frame().teeth, 2);
}

TEST_F(EnteredCut, WhatCannotBeIsOneLineAndLeavesWhatWasEntered) {
  ASSERT_TRUE(entry_.enter(pocketCut()).ok());
  const ui::LobeService* before = entry_.service();
  ui::EnteredCut none = pocketCut();
  none.modes.clear();
  const Status refused = entry_.enter(none);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().line().find("modes"), std::string::npos);
  ui::EnteredCut bad = pocketCut();
  bad.modes.front().damping = -0.1;
  EXPECT_FALSE(entry_.enter(bad).ok());
  EXPECT_EQ(entry_.service(), before);
  EXPECT_FALSE(entry_.read({}, folder_.filePath(QStringLiteral("none.toml"))).ok());
}

}  // namespace
}  // namespace stillcut::app
