// A cut of one's own on the Lobes page, entered as a person would, with no run behind it.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTableView>
#include <QTableWidget>

#include "tests/ui/support/fake_lobe_entry.h"
#include "tests/ui/support/page_picture.h"
#include "tests/ui/support/ui_fixture.h"
#include "ui/pages/lobes/cut_form.h"
#include "ui/plots/lobe_chart.h"

namespace stillcut::ui {
namespace {

class OwnCut : public WindowTest {
 protected:
  void openPage(Language language = Language::English) {
    session_.forgetLobes();
    session_.setLobeEntry(&entry_);
    open(1280, 800, ThemeKind::Light, language);
    press("page-lobes");
    tick(40);
  }
  void type(const char* field, const char* text) const {
    auto* box = find<QDoubleSpinBox>(QLatin1String(field));
    ASSERT_NE(box, nullptr) << field;
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, QLatin1String(text));
    QTest::keyClick(box, Qt::Key_Return);
  }
  void setMode(int row, const char* along, const char* hertz, const char* damping, const char* stiffness) const {
    auto* table = find<QTableWidget>("cut-modes");
    const std::array<const char*, 4> texts{along, hertz, damping, stiffness};
    for (int column = 0; column < 4; ++column)
      table->item(row, column)->setText(QLatin1String(texts[static_cast<std::size_t>(column)]));
  }
  bool said(const QString& text) const {
    for (const QLabel* label : window_->findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains(text)) return true;
    }
    return false;
  }

  FakeLobeEntry entry_;
};

TEST_F(OwnCut, IsEnteredWithoutARunAndAnsweredInFourTouches) {
  openPage();
  EXPECT_TRUE(said(QStringLiteral("YOUR OWN CUT")));
  press("lobes-own");
  tick(40);
  ASSERT_TRUE(find<CutForm>()->isVisible());
  type("cut-teeth", "4");
  type("cut-diameter", "20");
  type("cut-width", "10");
  type("cut-depth", "2");
  setMode(0, "x", "800", "3", "12");
  press("cut-add-mode");
  setMode(1, "y", "760,5", "3.5", "10");
  press("cut-enter");
  ASSERT_TRUE(entry_.entered);
  const EnteredCut& cut = *entry_.entered;
  EXPECT_EQ(cut.teeth, 4);
  EXPECT_NEAR(cut.diameter.value, 20e-3, 1e-9);
  EXPECT_NEAR(cut.immersion, 0.5, 1e-9);
  EXPECT_NEAR(cut.depth.value, 2e-3, 1e-9);
  ASSERT_EQ(cut.modes.size(), 2U);
  EXPECT_NEAR(cut.modes[0].stiffness, 12e6, 1.0);
  EXPECT_NEAR(cut.modes[0].damping, 0.03, 1e-9);
  EXPECT_NEAR(cut.modes[1].frequency.value, 760.5, 1e-9) << "with a decimal comma";
  EXPECT_EQ(cut.modes[1].direction, (std::array{0.0, 1.0}));
  tick(40);
  EXPECT_TRUE(find<LobeChart>()->isVisible());
  ASSERT_TRUE(entry_.fakeLobes().asked()) << "and computes by itself";
  entry_.fakeLobes().finish();
  tick(40);
  EXPECT_GT(find<QTableView>()->model()->rowCount(), 0);
  EXPECT_FALSE(find<QLabel>("what-if")->text().isEmpty());
}

TEST_F(OwnCut, WhatCannotBeIsSaidInTheForm) {
  openPage();
  press("lobes-own");
  press("cut-enter");
  EXPECT_FALSE(entry_.entered);
  EXPECT_TRUE(find<QLabel>("cut-said")->text().contains(QStringLiteral("none is entered")));
}

TEST_F(OwnCut, AFileFillsTheFieldsAndGoesOnToTheLobes) {
  openPage();
  press("lobes-own");
  EnteredCut ofFile;
  ofFile.modes = {{Hertz(800), 0.03, 1.2e7, {1.0, 0.0}}, {Hertz(760), 0.035, 1e7, {0.0, 1.0}}};
  ofFile.teeth = 3;
  ofFile.tangential = 8e8;
  entry_.ofFile = ofFile;
  find<CutForm>()->openFile(QStringLiteral("/data/a-long-name-of-a-cut-without-any-end.toml"));
  ASSERT_TRUE(entry_.entered);
  EXPECT_EQ(entry_.entered->teeth, 3);
  EXPECT_EQ(entry_.entered->modes, ofFile.modes) << "nothing is lost in the fields";
  tick(40);
  EXPECT_TRUE(find<LobeChart>()->isVisible());
  press("lobes-own");
  tick(40);
  EXPECT_TRUE(find<CutForm>()->isVisible()) << "a second touch goes back to the fields";
  entry_.ofFile.reset();
  find<CutForm>()->openFile(QStringLiteral("/data/none.toml"));
  EXPECT_TRUE(find<QLabel>("cut-said")->text().contains(QStringLiteral("cannot be opened")));
}

TEST_F(OwnCut, OfTheToolBeforeNoVerdictStandsBesideTheNumbersOfThisOne) {
  session_.setLobeEntry(&entry_);
  open();
  press("page-lobes");
  play(0.2);
  session_.fakeLobes().finish();
  play(0.2);
  ASSERT_FALSE(find<QLabel>("what-if")->text().isEmpty());
  EnteredCut cut;
  cut.modes = {{Hertz(800), 0.03, 1.2e7, {1.0, 0.0}}};
  find<CutForm>()->fill(cut);
  press("lobes-own");
  press("cut-enter");
  play(0.1);
  EXPECT_TRUE(find<QLabel>("what-if")->text().isEmpty()) << find<QLabel>("what-if")->text().toStdString();
  press("lobes-run");
  play(0.1);
  EXPECT_FALSE(find<LobeChart>()->isHidden());
}

TEST_F(OwnCut, AMaterialOfTheTableBringsItsForcesAndForcesOfOnesOwnGoBeforeIt) {
  openPage();
  press("lobes-own");
  setMode(0, "x", "800", "3", "12");
  auto* material = find<QComboBox>("cut-material");
  material->setCurrentIndex(1);
  emit material->activated(1);
  EXPECT_NEAR(find<QDoubleSpinBox>("cut-tangential")->value(), 796.0, 0.5);
  press("cut-enter");
  ASSERT_TRUE(entry_.entered);
  EXPECT_EQ(entry_.entered->material, QStringLiteral("7075-T6"));
  press("lobes-own");
  type("cut-tangential", "900");
  press("cut-enter");
  EXPECT_TRUE(entry_.entered->material.isEmpty());
  EXPECT_NEAR(entry_.entered->tangential, 9e8, 1.0);
}

class OwnCutFits : public OwnCut, public testing::WithParamInterface<Language> {};

TEST_P(OwnCutFits, TheForm) {
  openPage(GetParam());
  press("lobes-own");
  tick(40);
  QCoreApplication::processEvents();
  EXPECT_EQ(window_->size(), QSize(1280, 800));
  expectNothingCut(*window_, QStringLiteral("own-cut"), {1280, 800});
  expectNames(*window_, QStringLiteral("own-cut"));
  ASSERT_TRUE(QDir().mkpath(QStringLiteral(STILLCUT_SCREENSHOT_DIR)));
  EXPECT_TRUE(window_->grab().save(
      QStringLiteral("%1/own-cut-%2.png").arg(QStringLiteral(STILLCUT_SCREENSHOT_DIR), languageCode(GetParam()))));
}

INSTANTIATE_TEST_SUITE_P(Languages, OwnCutFits, testing::ValuesIn(kLanguages),
                         [](const auto& language) { return languageCode(language.param).toStdString(); });

}  // namespace
}  // namespace stillcut::ui
