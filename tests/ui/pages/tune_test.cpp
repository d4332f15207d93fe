// The Tune page, driven as a person would.
#include <QLineEdit>
#include <QListView>
#include <algorithm>

#include "tests/ui/support/fake_tuning.h"
#include "tests/ui/support/page_picture.h"
#include "ui/base/format.h"
#include "ui/pages/rule_grid.h"
#include "ui/pages/tune_page.h"
#include "ui/plots/membership_plot.h"
#include "ui/widgets/param_row.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/value_slider.h"

namespace stillcut::ui {
namespace {

using detect::kErChatter;

class TunePageTest : public WindowTest {
 protected:
  void openTune(int width = 1280, int height = 800, ThemeKind theme = ThemeKind::Light) {
    session_.setTuning(&tuning_);
    open(width, height, theme);
    window_->showPage(QStringLiteral("tune"));
    press("tune-expert");  // every parameter; the one control has tests of its own
    play(0.4);
  }
  // Values of `decl` that have reached the session, in order.
  std::vector<double> sentValues(const config::ParamDecl& decl) const {
    std::vector<double> values;
    for (const OperatorInput& input : session_.sent()) {
      if (input.action != OperatorAction::SetParameter) continue;
      if (input.parameter == config::parameterId(decl.key)) values.push_back(input.value);
    }
    return values;
  }
  ParamRow* row(const char* key) const { return find<ParamRow>(QLatin1String(key)); }
  void choosePart(const char* id) const {
    auto* list = find<QListView>("tune-parts");
    for (int k = 0; k < list->model()->rowCount(); ++k) {
      list->setCurrentIndex(list->model()->index(k, 0));
      if (!window_->findChildren<ParamRow*>().isEmpty() &&
          window_->findChildren<ParamRow*>().front()->objectName().startsWith(QLatin1String(id))) {
        return;
      }
    }
    FAIL() << id;
  }

  FakeTuning tuning_;
};

TEST_F(TunePageTest, EveryParameterOfEveryPartHasItsRow) {
  openTune();
  auto* list = find<QListView>("tune-parts");
  ASSERT_GE(list->model()->rowCount(), 8);
  for (const TunableComponent& part : tuning_.tunableParts()) {
    const std::string_view key = part.params.front()->key;
    choosePart(std::string(key.substr(0, key.find('.'))).c_str());
  }
  list->setCurrentIndex(list->model()->index(0, 0));
  for (const config::ParamDecl* decl : detect::energyRatioParams()) {
    const ParamRow* made = row(std::string(decl->key).c_str());
    ASSERT_NE(made, nullptr) << decl->key;
    EXPECT_TRUE(made->accessibleName().contains(QString::fromStdString(std::string(decl->label))));
  }
}

TEST_F(TunePageTest, ButtonsSliderKeysAndTypingReachTheRun) {
  openTune();
  press("energy-ratio.chatter-more");
  tick(40);
  ASSERT_FALSE(sentValues(kErChatter).empty());
  EXPECT_GT(sentValues(kErChatter).back(), 0.2);

  auto* slider = find<ValueSlider>("energy-ratio.chatter-slider");
  QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(slider->width() / 2, slider->height() / 2));
  QTest::mouseMove(slider, QPoint(slider->width() * 3 / 4, slider->height() / 2));
  tick(40);
  const double dragged = sentValues(kErChatter).back();
  EXPECT_GT(dragged, 0.25);
  QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(slider->width() * 3 / 4, slider->height() / 2));

  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Left);
  tick(40);
  EXPECT_LT(sentValues(kErChatter).back(), dragged);

  auto* edit = find<QLineEdit>("energy-ratio.chatter-edit");
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, QStringLiteral("0,33"));
  QTest::keyClick(edit, Qt::Key_Return);
  tick(40);
  EXPECT_DOUBLE_EQ(sentValues(kErChatter).back(), 0.33);
}

TEST_F(TunePageTest, WhatIsNoValueIsRefusedInPlace) {
  openTune();
  auto* edit = find<QLineEdit>("energy-ratio.chatter-edit");
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, QStringLiteral("77"));
  QTest::keyClick(edit, Qt::Key_Return);
  tick(40);
  EXPECT_TRUE(sentValues(kErChatter).empty());
  bool told = false;
  for (const TextLabel* label : row("energy-ratio.chatter")->findChildren<TextLabel*>()) {
    told = told || label->text().contains(QStringLiteral("0.01"));
  }
  EXPECT_TRUE(told) << "the allowed range stands beside it";
}

TEST_F(TunePageTest, UndoRedoDefaultsAndTheKeysForThem) {
  openTune();
  press("energy-ratio.chatter-more");
  tick(40);
  const double more = sentValues(kErChatter).back();
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  tick(40);
  EXPECT_DOUBLE_EQ(sentValues(kErChatter).back(), 0.2);
  press("tune-redo");
  tick(40);
  EXPECT_DOUBLE_EQ(sentValues(kErChatter).back(), more);
  press("tune-reset");
  tick(40);
  EXPECT_DOUBLE_EQ(sentValues(kErChatter).back(), 0.2);
}

TEST_F(TunePageTest, AAndBAreSwappedOnTheRunningCut) {
  openTune();
  press("tune-b");
  press("energy-ratio.chatter-more");
  tick(40);
  const double b = sentValues(kErChatter).back();
  press("tune-a");
  tick(40);
  EXPECT_DOUBLE_EQ(sentValues(kErChatter).back(), 0.2);
  press("tune-b");
  tick(40);
  EXPECT_DOUBLE_EQ(sentValues(kErChatter).back(), b);
}

TEST_F(TunePageTest, LockedRowsSayWhyAndCannotBeMoved) {
  openTune();
  ParamRow* locked = row("energy-ratio.harmonics");
  ASSERT_NE(locked, nullptr);
  EXPECT_TRUE(locked->view().locked.contains(QStringLiteral("Locked")));
  QString told;
  for (const TextLabel* label : locked->findChildren<TextLabel*>()) told += label->text() + u'\n';
  EXPECT_TRUE(told.contains(QStringLiteral("auto: 12 tooth passings"))) << "why: " << told.toStdString();
  EXPECT_TRUE(told.contains(QStringLiteral("Automatic: chose 48"))) << "and what came of it: " << told.toStdString();
  EXPECT_TRUE(told.contains(QStringLiteral("Locked while the cut runs"))) << told.toStdString();
  EXPECT_FALSE(find<TouchButton>("energy-ratio.harmonics-more")->isEnabled());
  EXPECT_FALSE(find<ValueSlider>("energy-ratio.harmonics-slider")->isEnabled());
  session_.snapshot().running = false;
  session_.touch();
  tick(40);
  EXPECT_TRUE(find<TouchButton>("energy-ratio.harmonics-more")->isEnabled()) << "between runs it is open";
  // Out of automatic it begins at what the method chose.
  press("energy-ratio.harmonics-auto");
  EXPECT_EQ(locked->view().value, QStringLiteral("48"));
}

// What a detector sets itself while the cut runs stands in the row of its parameter, with the reason; what it learns
// besides stands above the rows.
TEST_F(TunePageTest, WhatItHasSetItselfIsToldWithItsReasonAsItChanges) {
  openTune();
  ParamRow* lambda = row("energy-ratio.lambda");
  ASSERT_NE(lambda, nullptr);
  const auto* own = find<TextLabel>("tune-own");
  EXPECT_FALSE(own->isVisible()) << "nothing told yet";
  tuning_.own = {{"energy-ratio.lambda", {}, {}, QStringLiteral("a memory of two turns at this speed"), 1.25e-5},
                 {"energy-ratio.floor",
                  QStringLiteral("Noise floor"),
                  {},
                  QStringLiteral("not yet: it is learned in the steady cut"),
                  config::kAutomatic}};
  play(0.1);
  EXPECT_TRUE(lambda->view().automatic.contains(QStringLiteral("a memory of two turns")));
  EXPECT_TRUE(lambda->view().automatic.contains(significant(1.25e-5, 3)));
  EXPECT_TRUE(own->isVisible());
  EXPECT_TRUE(own->text().contains(QStringLiteral("Noise floor: not yet")));
  tuning_.own[1].value = 0.0042;
  tuning_.own[1].why = QStringLiteral("mean of the stable cut so far");
  play(0.1);
  EXPECT_TRUE(own->text().contains(QStringLiteral("Noise floor: 0.0042"))) << own->text().toStdString();
  choosePart("coherence");
  play(0.1);
  EXPECT_FALSE(own->isVisible()) << "another part has told nothing";
}

// Xu's tables on a run that learns: chosen by touch and keys, changed on the running cut, undone, and what learning
// did.
TEST_F(TunePageTest, FuzzyRulesAreShownChangedUndoneAndWhatWasLearnedIsTold) {
  tuning_ = FakeTuning("fuzzy-learning");
  openTune();
  auto* list = find<QListView>("tune-parts");
  auto* grid = find<RuleGrid>("rules");
  EXPECT_FALSE(grid->isVisible()) << "a detector has no rules";
  // What runs comes first in the list: the first with rules is the one that learns.
  for (int k = 0; k < list->model()->rowCount() && !grid->isVisible(); ++k) {
    list->setCurrentIndex(list->model()->index(k, 0));
  }
  ASSERT_TRUE(grid->isVisible());
  ASSERT_NE(grid->focusPolicy() & Qt::TabFocus, 0);
  grid->choose(0);
  EXPECT_EQ(grid->cellText(0), QStringLiteral("error NX, change NX: 8 (PB)")) << "figure 3.7";
  QTest::keyClick(grid, Qt::Key_Right);
  QTest::keyClick(grid, Qt::Key_Down);
  EXPECT_EQ(grid->chosen(), 10);
  const config::ParamDecl& cell = *control::fuzzyRuleParams()[10];
  EXPECT_EQ(cell.key, "fuzzy.speed-rule-nb-nb");
  QTest::keyClick(grid, Qt::Key_Minus);
  press("rule-less");
  tick(40);
  ASSERT_FALSE(sentValues(cell).empty());
  EXPECT_DOUBLE_EQ(sentValues(cell).back(), 6.0);
  press("tune-undo");
  tick(40);
  EXPECT_DOUBLE_EQ(sentValues(cell).back(), 6.5);
  QTest::keyClick(grid, Qt::Key_Delete);
  tick(40);
  EXPECT_DOUBLE_EQ(sentValues(cell).back(), 7.0) << "as printed";

  press("rules-feed");
  EXPECT_EQ(grid->cellText(0), QStringLiteral("error NX, change NX: 7 (PM)")) << "figure 3.8";
  RuleTables now;
  now.lessons = 3;
  for (std::size_t k = 0; k < 81; ++k) {
    now.feed[k / 9][k % 9] = static_cast<float>(control::fuzzyRuleParams()[81 + k]->fallback);
  }
  now.feed[8][8] = 2.4F;
  tuning_.rules = now;
  tick(40);
  EXPECT_TRUE(grid->cellText(80).endsWith(QStringLiteral("learned 2.4"))) << grid->cellText(80).toStdString();
  const auto told = [this](const QString& start) {
    const auto labels = window_->findChildren<TextLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const TextLabel* l) { return l->text().startsWith(start); });
  };
  EXPECT_TRUE(told(QStringLiteral("Lessons: 3. Rules of this table that moved: 1, the furthest by \u22120.6")));
  tuning_.rules->refused = true;
  tick(40);
  EXPECT_TRUE(told(QStringLiteral("These values cannot be used together: rules must fall as coherence rises")));
  tuning_.rules->refused = false;
  tick(40);
  EXPECT_FALSE(told(QStringLiteral("These values cannot be used together")));
}

TEST_F(TunePageTest, FuzzySetsFollowTheirPeaks) {
  openTune();
  auto* plot = find<MembershipPlot>();
  for (const config::ParamDecl* decl : control::fuzzyCentreParams()) EXPECT_EQ(decl->unit, "");
  auto* page = window_->findChild<TunePage*>();
  auto* list = find<QListView>("tune-parts");
  for (int k = 0; k < list->model()->rowCount() && !plot->isVisible(); ++k) {
    list->setCurrentIndex(list->model()->index(k, 0));
  }
  ASSERT_TRUE(plot->isVisible());
  EXPECT_EQ(plot->peaks()[5], 0.25);
  page->controller().set(*control::fuzzyCentreParams()[0], 0.1);
  EXPECT_EQ(plot->peaks()[5], 0.1);
  EXPECT_EQ(plot->peaks()[3], -0.1) << "alike on both sides";
}

TEST_F(TunePageTest, SavesAndSaysWhereOrWhyNot) {
  openTune();
  press("energy-ratio.chatter-more");
  press("tune-save");
  ASSERT_TRUE(tuning_.saved.has_value());
  EXPECT_GT(tuning_.saved->real(kErChatter), 0.2);
  tuning_.refuse = true;
  QTest::keyClick(window_.get(), Qt::Key_S, Qt::ControlModifier);
  bool told = false;
  for (const TextLabel* label : window_->findChildren<TextLabel*>()) {
    told = told || label->text().contains(QStringLiteral("the disk is full"));
  }
  EXPECT_TRUE(told);
}

TEST_F(TunePageTest, AnotherRunBeginsWithItsOwnValues) {
  openTune();
  press("energy-ratio.chatter-more");
  tuning_.openOther();
  tick(40);
  EXPECT_EQ(row("energy-ratio.chatter")->view().value, QStringLiteral("0.2"));
  EXPECT_FALSE(find<TouchButton>("tune-undo")->isEnabled());
}

// The run goes on with what was set while the screen is made anew.
TEST_F(TunePageTest, AnotherLanguageKeepsWhatRunsUndoAndBothSides) {
  openTune();
  press("tune-b");
  press("energy-ratio.chatter-more");
  tick(40);
  const double b = sentValues(kErChatter).back();
  play(1.0);
  const QString shown = row("energy-ratio.chatter")->view().value;
  QTest::keyClick(window_.get(), Qt::Key_F11);
  press("language-1");
  QCoreApplication::processEvents();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  tick(40);
  ASSERT_EQ(find<TouchButton>("tune-b")->accessibleName(), QStringLiteral("Werte der Seite B nutzen"));
  EXPECT_EQ(row("energy-ratio.chatter")->view().value, shown) << "what runs, not what it began with";
  EXPECT_TRUE(find<TouchButton>("tune-b")->isChecked());
  EXPECT_GT(tuning_.controller().tally().side(1).inForce.value, 0.5) << "what B did is still known";
  press("tune-a");
  tick(40);
  EXPECT_DOUBLE_EQ(sentValues(kErChatter).back(), 0.2);
  press("tune-b");
  press("tune-undo");
  tick(40);
  EXPECT_DOUBLE_EQ(sentValues(kErChatter).back(), 0.2) << "undone, of B";
  press("tune-redo");
  press("tune-save");
  ASSERT_TRUE(tuning_.saved.has_value());
  EXPECT_DOUBLE_EQ(tuning_.saved->real(kErChatter), b);
}

TEST_F(TunePageTest, WhatItSeesNowSaysThatItIsOld) {
  openTune();
  play(1.0);
  const auto said = [this](const char* text) {
    for (const TextLabel* label : window_->findChildren<TextLabel*>()) {
      if (label->isVisible() && label->text().contains(QLatin1String(text))) return true;
    }
    return false;
  };
  ASSERT_TRUE(said("learned noise floor")) << "the indicators";
  tick(2000);
  EXPECT_TRUE(said("The picture is stale"));
  EXPECT_FALSE(said("learned noise floor"));
}

TEST_F(TunePageTest, BothSidesAlikeCanBeUndone) {
  openTune();
  press("tune-b");
  press("energy-ratio.chatter-more");
  tick(40);
  const double b = sentValues(kErChatter).back();
  press("tune-a");
  tick(40);
  press("tune-copy");
  press("tune-b");
  tick(40);
  EXPECT_DOUBLE_EQ(tuning_.controller().value(kErChatter), 0.2) << "B is like A";
  press("tune-undo");
  tick(40);
  EXPECT_DOUBLE_EQ(tuning_.controller().value(kErChatter), b);
  EXPECT_DOUBLE_EQ(sentValues(kErChatter).back(), b) << "and the run has it";
}

TEST_F(TunePageTest, AReplayHasADeskOfItsOwnAndTheCutsComesBackAsItWas) {
  openTune();
  press("energy-ratio.chatter-more");
  tick(40);
  const QString cut = row("energy-ratio.chatter")->view().value;
  choosePart("coherence");
  auto replay = std::make_unique<TuningController>();
  tuning_.show(replay);
  tick(40);
  choosePart("energy-ratio");
  EXPECT_EQ(row("energy-ratio.chatter")->view().value, QStringLiteral("0.2"));
  EXPECT_FALSE(find<TouchButton>("tune-undo")->isEnabled());
  press("energy-ratio.chatter-less");
  EXPECT_NE(row("energy-ratio.chatter")->view().value, QStringLiteral("0.2"));
  tuning_.show(replay);
  tick(40);
  ASSERT_NE(row("energy-ratio.chatter"), nullptr) << "the same part is open";
  EXPECT_EQ(row("energy-ratio.chatter")->view().value, cut);
  press("tune-undo");
  EXPECT_EQ(row("energy-ratio.chatter")->view().value, QStringLiteral("0.2"));
}

class TunePictures : public TunePageTest, public testing::WithParamInterface<PageLook> {};

TEST_P(TunePictures, EveryPartFits) {
  openTune(GetParam().width, GetParam().height, GetParam().theme);
  play(5.2);
  press("tune-b");
  press("energy-ratio.chatter-more");
  play(0.4);
  savePage(*window_, "tune", GetParam(), "detector");
  choosePart("stable-pocket");
  play(0.1);
  savePage(*window_, "tune", GetParam(), "strategy");
  choosePart("gate");
  play(0.1);
  savePage(*window_, "tune", GetParam(), "gate");
}

INSTANTIATE_TEST_SUITE_P(Looks, TunePictures, testing::ValuesIn(kPageLooks), lookName);

}  // namespace
}  // namespace stillcut::ui
