// What the Tune page is made of, without a screen: values on sliders, undo, two sides, the queue to the worker.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <cmath>

#include "tests/ui/support/fake_tuning.h"
#include "ui/models/tune/compare_tally.h"
#include "ui/models/tune/param_model.h"
#include "ui/models/tune/param_scale.h"
#include "ui/models/tune/tune_desk.h"

namespace stillcut::ui {
namespace {

using detect::kErChatter;
using detect::kErEvidence;
using detect::kErHarmonics;

TEST(ParamScale, EveryFractionIsALegalValueAndComesBack) {
  FakeTuning tuning;
  for (const TunablePart& part : tuning.tunableParts()) {
    for (const config::ParamDecl* decl : part.params) {
      for (int k = 0; k <= 20; ++k) {
        const double value = valueAt(*decl, k / 20.0);
        EXPECT_TRUE(config::isLegal(*decl, value)) << decl->key << " at " << k;
        if (decl->kind == config::ParamKind::Real) {
          EXPECT_NEAR(fractionOf(*decl, value), k / 20.0, 0.02) << decl->key;
        }
      }
      EXPECT_DOUBLE_EQ(valueAt(*decl, 0.0), decl->lowest) << decl->key;
      EXPECT_DOUBLE_EQ(valueAt(*decl, 1.0), decl->highest) << decl->key;
    }
  }
}

TEST(ParamScale, StepsGoUpAndDownToTheEndsOfEveryRange) {
  FakeTuning tuning;
  for (const TunablePart& part : tuning.tunableParts()) {
    for (const config::ParamDecl* decl : part.params) {
      for (const int direction : {1, -1}) {
        double value = stepFrom(*decl, decl->fallback, direction);
        for (int k = 0; k < 600; ++k) {
          const double next = stepFrom(*decl, value, direction);
          ASSERT_TRUE(config::isLegal(*decl, next)) << decl->key << " " << next;
          if (next == value) break;
          ASSERT_GT((next - value) * direction, 0.0) << decl->key << " from " << value;
          value = next;
        }
        EXPECT_DOUBLE_EQ(value, direction > 0 ? decl->highest : decl->lowest) << decl->key;
      }
    }
  }
}

TEST(ParamScale, ReadsWhatPeopleType) {
  EXPECT_EQ(valueFrom(kErChatter, QStringLiteral("0,35")), 0.35);
  EXPECT_EQ(valueFrom(kErChatter, QStringLiteral(" 0.35 ")), 0.35);
  for (const char* wrong : {"", "much", "nan", "inf", "2", "-0.2", "0.2 0.3"}) {
    EXPECT_FALSE(valueFrom(kErChatter, QString::fromLatin1(wrong)).has_value()) << wrong;
  }
  EXPECT_TRUE(std::isnan(valueFrom(kErHarmonics, QStringLiteral("auto")).value_or(0.0)));
  EXPECT_FALSE(valueFrom(kErChatter, QStringLiteral("auto")).has_value());
}

TEST(TuneDesk, OneDragIsOneStepOfUndo) {
  TuneDesk desk;
  desk.open({});
  for (const double value : {0.25, 0.3, 0.4}) desk.set(kErChatter, value);
  desk.settle();
  desk.set(kErChatter, 0.5);
  desk.set(kErEvidence, 20.0);
  EXPECT_EQ(desk.undoStack().count(), 3);
  desk.undoStack().undo();
  EXPECT_EQ(desk.value(kErEvidence), kErEvidence.fallback);
  desk.undoStack().undo();
  EXPECT_EQ(desk.value(kErChatter), 0.4);
  desk.undoStack().undo();
  EXPECT_EQ(desk.value(kErChatter), 0.2);
  desk.undoStack().redo();
  EXPECT_EQ(desk.value(kErChatter), 0.4);
}

TEST(TuneDesk, HandsOutTheNewestValueOfEachParameterOnce) {
  TuneDesk desk;
  desk.open({});
  desk.set(kErChatter, 0.3);
  desk.set(kErEvidence, 20.0);
  desk.set(kErChatter, 0.4);
  const auto first = desk.take(1);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].parameter, config::parameterId(kErEvidence.key));
  const auto rest = desk.take(4);
  ASSERT_EQ(rest.size(), 1U);
  EXPECT_EQ(rest[0].action, OperatorAction::SetParameter);
  EXPECT_EQ(rest[0].value, 0.4);
  EXPECT_TRUE(desk.take(4).empty());
}

TEST(TuneDesk, TheOtherSideIsPutInForceWhole) {
  TuneDesk desk;
  desk.open({});
  desk.use(TuneDesk::B);
  desk.set(kErChatter, 0.5);
  desk.set(kErEvidence, 30.0);
  desk.take(9);
  desk.use(TuneDesk::A);
  EXPECT_EQ(desk.differences().size(), 2U);
  const auto back = desk.take(9);
  ASSERT_EQ(back.size(), 2U);
  for (const OperatorInput& input : back) {
    EXPECT_EQ(input.value, input.parameter == config::parameterId(kErChatter.key) ? 0.2 : kErEvidence.fallback);
  }
  desk.copyToOther();
  EXPECT_TRUE(desk.differences().empty());
  EXPECT_EQ(desk.value(kErChatter, TuneDesk::B), 0.2);
}

TEST(TuneDesk, IllegalValuesAreNotTaken) {
  TuneDesk desk;
  desk.open({});
  desk.set(kErChatter, 7.0);
  desk.set(kErChatter, config::kAutomatic);
  desk.set(kErChatter, std::numeric_limits<double>::infinity());
  EXPECT_EQ(desk.value(kErChatter), 0.2);
  EXPECT_FALSE(desk.undoStack().canUndo());
  EXPECT_FALSE(desk.pending());
}

TEST(ParamModel, PassesTheModelTester) {
  FakeTuning tuning;
  TuneDesk desk;
  desk.open({});
  ParamModel model(desk);
  PartModel parts;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  const QAbstractItemModelTester partTester(&parts, QAbstractItemModelTester::FailureReportingMode::Fatal);
  parts.show(tuning.tunableParts());
  for (int row = 0; row < parts.rowCount(); ++row) {
    model.show(parts.part(row));
    model.setRunning(row % 2 == 0);
    EXPECT_GT(model.rowCount(), 0);
    for (int k = 0; k < model.rowCount(); ++k) EXPECT_FALSE(model.index(k, 0).data().toString().isEmpty());
  }
  model.show(nullptr);
  EXPECT_EQ(model.rowCount(), 0);
  EXPECT_EQ(parts.part(0)->id, QStringLiteral("energy-ratio")) << "what is in charge comes first";
}

TEST(ParamModel, LockedParametersSayWhyAndStay) {
  FakeTuning tuning;
  TuneDesk desk;
  desk.open({});
  ParamModel model(desk);
  model.show(&tuning.tunableParts().front());
  int locked = -1, open = -1;
  for (int row = 0; row < model.rowCount(); ++row) {
    if (model.decl(row).key == kErHarmonics.key) locked = row;
    if (model.decl(row).key == kErChatter.key) open = row;
  }
  model.setRunning(true);
  EXPECT_TRUE(model.view(locked).locked.contains(QStringLiteral("Locked")));
  EXPECT_FALSE(model.setData(model.index(locked, ParamModel::Value), 8.0));
  EXPECT_FALSE((model.flags(model.index(locked, ParamModel::Value)) & Qt::ItemIsEditable) != 0);
  EXPECT_TRUE(model.view(locked).automatic.contains(QStringLiteral("48")));
  QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
  EXPECT_TRUE(model.setData(model.index(open, ParamModel::Value), QStringLiteral("0,4")));
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(desk.value(kErChatter), 0.4);
  EXPECT_TRUE(model.view(open).changed);
  model.setRunning(false);
  EXPECT_TRUE(model.setData(model.index(locked, ParamModel::Value), 8.0));
}

TEST(CompareTally, CountsWhatEachSideDid) {
  CompareTally tally;
  Snapshot s;
  const auto run = [&](int ticks, CutState state, std::size_t side) {
    for (int k = 0; k < ticks; ++k) {
      s.time += std::chrono::milliseconds(100);
      s.verdicts[0].valid = true;
      s.verdicts[0].state = state;
      s.verdicts[0].severity = Ratio(state == CutState::Chatter ? 0.5 : 0.01);
      tally.see(s, side);
    }
  };
  run(11, CutState::Stable, 0);
  run(5, CutState::Chatter, 0);
  run(5, CutState::Stable, 0);
  run(11, CutState::Stable, 1);
  EXPECT_EQ(tally.side(0).alarms, 1);
  EXPECT_NEAR(tally.side(0).alarming.value, 0.5, 1e-9);
  EXPECT_NEAR(tally.side(0).inForce.value, 2.0, 1e-9);
  EXPECT_DOUBLE_EQ(tally.side(0).highest, 0.5);
  EXPECT_EQ(tally.side(1).alarms, 0);
  EXPECT_NEAR(tally.side(1).inForce.value, 1.0, 1e-9);
}

}  // namespace
}  // namespace stillcut::ui
