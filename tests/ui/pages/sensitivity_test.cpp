// Less or more sensitive, where it is seen: one control on the Tune page beside the indicators and their limits.
#include <QLabel>

#include "tests/ui/support/fake_tuning.h"
#include "tests/ui/support/page_picture.h"
#include "tests/ui/support/ui_fixture.h"
#include "ui/models/tune/sensitivity.h"
#include "ui/plots/indicator_strip.h"
#include "ui/widgets/param_row.h"

namespace stillcut::ui {
namespace {

using detect::kErChatter;
using detect::kErEvidence;

// Asked about other limits, it answers what a test tells it to.
class TriedTuning final : public Tuning {
 public:
  std::uint32_t tuningRun() const override { return inner.tuningRun(); }
  const std::vector<TunableComponent>& tunableParts() const override { return inner.tunableParts(); }
  TuningController& controller() override { return inner.controller(); }
  std::vector<AutoReading> ownNow(const TunableComponent& part) override { return inner.ownNow(part); }
  Result<QString> saveValues(const config::ParamSet& values) override { return inner.saveValues(values); }
  void tryOnRecordings(const QString& detector, const QStringList& settings) override {
    asked = settings;
    of = detector;
  }
  SensitivityTrial trial() override { return answer; }

  FakeTuning inner;
  SensitivityTrial answer;
  QStringList asked;
  QString of;
};

class SensitivityPage : public WindowTest {
 protected:
  void openTune(Language language = Language::English) {
    session_.setTuning(&tuning_);
    open(1280, 800, ThemeKind::Light, language);
    window_->showPage(QStringLiteral("tune"));
    play(0.4);
  }
  double sent(const config::ParamDecl& decl) const {
    double value = std::nan("");
    for (const OperatorInput& input : session_.sent()) {
      const bool this_ =
          input.action == OperatorAction::SetParameter && input.parameter == config::parameterId(decl.key);
      if (this_) value = input.value;
    }
    return value;
  }
  QString text(const char* name) const { return find<QLabel>(QLatin1String(name))->text(); }

  TriedTuning tuning_;
};

TEST(SensitivitySteps, AreSmallAndKnownAgainByTheirValues) {
  FakeTuning tuning;
  const Sensitivity sensitivity(tuning.tunableParts().front());
  ASSERT_TRUE(sensitivity.known());
  for (int step = -Sensitivity::kMost; step <= Sensitivity::kMost; ++step) {
    std::map<const config::ParamDecl*, double> values;
    for (const auto& [decl, value] : sensitivity.at(step)) {
      EXPECT_TRUE(config::isLegal(*decl, value)) << decl->key;
      values[decl] = value;
    }
    EXPECT_EQ(sensitivity.stepOf([&](const config::ParamDecl& decl) { return values.at(&decl); }), step);
    if (step == 0) {
      EXPECT_DOUBLE_EQ(values.at(&kErChatter), 0.2) << "as delivered";
    }
    if (step == -1) {
      EXPECT_DOUBLE_EQ(values.at(&kErChatter), 0.24) << "and not 0.5";
    }
  }
  EXPECT_FALSE(sensitivity.stepOf([](const config::ParamDecl& decl) { return 0.77 * decl.fallback; }));
}

TEST_F(SensitivityPage, OneTouchMovesTheLimitsThatDecideAndAsksTheLastRecordings) {
  openTune();
  EXPECT_TRUE(window_->findChildren<ParamRow*>().isEmpty() || !window_->findChildren<ParamRow*>().front()->isVisible())
      << "single parameters are the expert's";
  EXPECT_EQ(text("sensitivity-now"), QStringLiteral("As delivered"));
  press("sensitivity-less");
  tick(40);
  EXPECT_NEAR(sent(kErChatter), 0.24, 1e-9);
  EXPECT_GT(sent(kErEvidence), kErEvidence.fallback);
  EXPECT_EQ(text("sensitivity-now"), QStringLiteral("One step less sensitive"));
  EXPECT_EQ(tuning_.of, QStringLiteral("energy-ratio"));
  EXPECT_TRUE(tuning_.asked.contains(QStringLiteral("energy-ratio.chatter=0.24")))
      << tuning_.asked.join(u' ').toStdString();
  tuning_.answer = {false, 4, 4, 3, 1, 5, 2, {}};
  tick(40);
  EXPECT_TRUE(
      text("sensitivity-trial").contains(QStringLiteral("last 4 recordings it would have alarmed 3 times, 1 of")));
  EXPECT_TRUE(text("sensitivity-trial").contains(QStringLiteral("5 times, 2 of them")));
  press("tune-undo");
  tick(40);
  EXPECT_NEAR(sent(kErChatter), 0.2, 1e-9) << "one touch, one step back";
  EXPECT_EQ(text("sensitivity-now"), QStringLiteral("As delivered"));
}

TEST_F(SensitivityPage, TheLimitBesideTheIndicatorIsTheOneThatDecides) {
  openTune();
  const auto strips = window_->findChildren<IndicatorStrip*>();
  ASSERT_EQ(strips.size(), 2);
  ASSERT_FALSE(strips[0]->points().empty());
  EXPECT_DOUBLE_EQ(strips[0]->points().back().limit, 0.2);
  press("sensitivity-more");
  play(0.2);
  EXPECT_LT(strips[0]->points().back().limit, 0.2) << "at once";
  EXPECT_DOUBLE_EQ(strips[0]->points().front().limit, 0.2) << "what was, was by the limit of then";
  tuning_.inner.own = {{"energy-ratio.full", QStringLiteral("Full chatter"), {}, {}, 0.41}};
  play(0.2);
  EXPECT_DOUBLE_EQ(strips[0]->points().back().limit, 0.41) << "a channel that is loud in the calm cut";
}

TEST_F(SensitivityPage, ExpertShowsEveryParameterAndComesBack) {
  openTune();
  press("tune-expert");
  play(0.1);
  ASSERT_FALSE(window_->findChildren<ParamRow*>().isEmpty());
  EXPECT_TRUE(window_->findChildren<ParamRow*>().front()->isVisible());
  EXPECT_FALSE(find<TouchButton>("sensitivity-less")->isVisible());
  press("tune-expert");
  play(0.1);
  EXPECT_TRUE(find<TouchButton>("sensitivity-less")->isVisible());
}

class SensitivityFits : public SensitivityPage, public testing::WithParamInterface<Language> {};

TEST_P(SensitivityFits, InEveryLanguage) {
  openTune(GetParam());
  play(5.5);
  tuning_.answer = {true, 4, 5, 13, 11, 15, 12, {}};
  press("sensitivity-less");
  play(0.2);
  QCoreApplication::processEvents();
  expectNothingCut(*window_, QStringLiteral("sensitivity"), {1280, 800});
  expectNames(*window_, QStringLiteral("sensitivity"));
  ASSERT_TRUE(QDir().mkpath(QStringLiteral(STILLCUT_SCREENSHOT_DIR)));
  EXPECT_TRUE(window_->grab().save(
      QStringLiteral("%1/sensitivity-%2.png").arg(QStringLiteral(STILLCUT_SCREENSHOT_DIR), languageCode(GetParam()))));
}

INSTANTIATE_TEST_SUITE_P(Languages, SensitivityFits, testing::ValuesIn(kLanguages),
                         [](const auto& language) { return languageCode(language.param).toStdString(); });

}  // namespace
}  // namespace stillcut::ui
