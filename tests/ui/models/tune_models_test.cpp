// What the Tune page is made of, without a screen: values on sliders, undo, two sides, the queue to the worker.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <cmath>

#include "tests/ui/support/fake_tuning.h"
#include "ui/models/tune/compare_tally.h"
#include "ui/models/tune/param_model.h"
#include "ui/models/tune/param_scale.h"
#include "ui/models/tune/tuning_controller.h"

namespace stillcut::ui {
namespace {

using detect::kErChatter;
using detect::kErEvidence;
using detect::kErHarmonics;

TEST(ParamScale, EveryFractionIsALegalValueAndComesBack) {
  FakeTuning tuning;
  for (const TunableComponent& part : tuning.tunableParts()) {
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
  for (const TunableComponent& part : tuning.tunableParts()) {
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

TEST(TuningController, OneDragIsOneStepOfUndo) {
  TuningController controller;
  controller.open({});
  for (const double value : {0.25, 0.3, 0.4}) controller.set(kErChatter, value);
  controller.settle();
  controller.set(kErChatter, 0.5);
  controller.set(kErEvidence, 20.0);
  EXPECT_EQ(controller.undoStack().count(), 3);
  controller.undoStack().undo();
  EXPECT_EQ(controller.value(kErEvidence), kErEvidence.fallback);
  controller.undoStack().undo();
  EXPECT_EQ(controller.value(kErChatter), 0.4);
  controller.undoStack().undo();
  EXPECT_EQ(controller.value(kErChatter), 0.2);
  controller.undoStack().redo();
  EXPECT_EQ(controller.value(kErChatter), 0.4);
}

TEST(TuningController, HandsOutTheNewestValueOfEachParameterOnce) {
  TuningController controller;
  controller.open({});
  controller.set(kErChatter, 0.3);
  controller.set(kErEvidence, 20.0);
  controller.set(kErChatter, 0.4);
  const auto first = controller.take(1);
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].parameter, config::parameterId(kErEvidence.key));
  const auto rest = controller.take(4);
  ASSERT_EQ(rest.size(), 1U);
  EXPECT_EQ(rest[0].action, OperatorAction::SetParameter);
  EXPECT_EQ(rest[0].value, 0.4);
  EXPECT_TRUE(controller.take(4).empty());
}

TEST(TuningController, TheOtherSideIsPutInForceWhole) {
  TuningController controller;
  controller.open({});
  controller.use(TuningController::B);
  controller.set(kErChatter, 0.5);
  controller.set(kErEvidence, 30.0);
  controller.take(9);
  controller.use(TuningController::A);
  EXPECT_EQ(controller.differences().size(), 2U);
  const auto back = controller.take(9);
  ASSERT_EQ(back.size(), 2U);
  for (const OperatorInput& input : back) {
    EXPECT_EQ(input.value, input.parameter == config::parameterId(kErChatter.key) ? 0.2 : kErEvidence.fallback);
  }
  controller.copyToOther();
  EXPECT_TRUE(controller.differences().empty());
  EXPECT_EQ(controller.value(kErChatter, TuningController::B), 0.2);
}

TEST(TuningController, IllegalValuesAreNotTaken) {
  TuningController controller;
  controller.open({});
  controller.set(kErChatter, 7.0);
  controller.set(kErChatter, config::kAutomatic);
  controller.set(kErChatter, std::numeric_limits<double>::infinity());
  EXPECT_EQ(controller.value(kErChatter), 0.2);
  EXPECT_FALSE(controller.undoStack().canUndo());
  EXPECT_FALSE(controller.pending());
}

TEST(ParamModel, PassesTheModelTester) {
  FakeTuning tuning;
  TuningController controller;
  controller.open({});
  ParamModel model(controller);
  ComponentListModel parts;
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
  TuningController controller;
  controller.open({});
  ParamModel model(controller);
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
  EXPECT_EQ(controller.value(kErChatter), 0.4);
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
