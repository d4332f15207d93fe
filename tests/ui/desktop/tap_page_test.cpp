// The Tap test page from the first hit to the recommended cut, with a simulated hammer and tool behind it.
#include <QAbstractItemModel>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QTableView>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

#include "app/session/tap/tap_bench.h"
#include "core/milling/identify/model_files.h"
#include "core/milling/simulation/simulated_tap.h"
#include "core/milling/stability/lobe_case.h"
#include "tests/ui/support/page_picture.h"
#include "ui/plots/tap/frf_plot.h"

namespace stillcut::ui {
namespace {

class TapPageTest : public WindowTest {
 protected:
  void openTap(int width = 1280, int height = 800, ThemeKind theme = ThemeKind::Light) {
    bench_.setSimulatedPace(0.0);
    bench_.keepIn(folder_.path());
    session_.setTap(&bench_);
    open(width, height, theme);
    window_->showPage(QStringLiteral("tap"));
    tick(40);
  }
  // Ticks until it is so; the hammer hits as fast as the page takes it.
  bool until(const std::function<bool()>& done) {
    return QTest::qWaitFor(
        [&] {
          tick(40);
          return done();
        },
        60'000);
  }
  void choose(const char* box, int row) {
    auto* choice = find<QComboBox>(QLatin1String(box));
    choice->setCurrentIndex(row);
    emit choice->activated(row);
  }
  bool listen() {
    choose("tap-device", 1);
    return until([&] { return bench_.listening().state == TapListening::State::Running; });
  }
  bool measure(int axis) {
    press(axis == 0 ? QStringLiteral("tap-x") : QStringLiteral("tap-y"));
    press(QStringLiteral("tap-begin"));
    return until([&] {
      return bench_.run().phase == TapRun::Phase::Enough && bench_.run().axis == axis &&
             bench_.response(axis).state == TapResponse::State::Done;
    });
  }
  QString text(const char* label) const { return find<TextLabel>(QLatin1String(label))->text(); }
  QAbstractItemModel* table(const char* name) const { return find<QTableView>(QLatin1String(name))->model(); }
  void touchRow(const char* name, int row) {
    auto* view = find<QTableView>(QLatin1String(name));
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, view->visualRect(view->model()->index(row, 0)).center());
    tick(40);
  }

  QTemporaryDir folder_;
  app::TapBench bench_;
};

TEST_F(TapPageTest, FromTheHammerToTheRightSpeed) {
  openTap();
  EXPECT_EQ(text("tap-sign"), QStringLiteral("Choose a device"));
  ASSERT_TRUE(listen());
  EXPECT_EQ(find<QComboBox>(QStringLiteral("tap-force"))->currentText(), QStringLiteral("hammer"));
  EXPECT_EQ(find<QComboBox>(QStringLiteral("tap-response"))->currentText(), QStringLiteral("tip x"));
  ASSERT_TRUE(measure(0));
  QStringList judged;
  for (int row = 0; row < table("tap-hits")->rowCount(); ++row) {
    judged << table("tap-hits")->index(row, 3).data().toString();
  }
  EXPECT_EQ(judged.count(QStringLiteral("good")), 5) << judged.join(u',').toStdString();
  EXPECT_GE(judged.size(), 7) << "of eight blows three are bad";
  EXPECT_TRUE(judged.contains(QStringLiteral("overload of the hammer")) ||
              judged.contains(QStringLiteral("double hit")));
  ASSERT_TRUE(measure(1));
  EXPECT_EQ(text("tap-sign"), QStringLiteral("Done along y"));
  press(QStringLiteral("tap-find-modes"));
  tick(40);
  ASSERT_EQ(table("tap-modes")->rowCount(), 2);
  EXPECT_TRUE(find<FrfPlot>()->hasResponse());
  const auto truth = milling::usualTapStructure().modes;
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(bench_.response(1).modes[k].frequency.value, truth[2 + k].frequency.value, 3.0);
    EXPECT_NEAR(bench_.response(1).modes[k].stiffness, truth[2 + k].stiffness, 0.05 * truth[2 + k].stiffness);
  }
  press(QStringLiteral("tap-speeds"));
  ASSERT_TRUE(until([&] { return bench_.lobes().state == TapLobes::State::Done; }));
  tick(40);
  EXPECT_TRUE(text("tap-answer").contains(QStringLiteral("rpm"))) << text("tap-answer").toStdString();
  const double aluminium = bench_.lobes().depth.value;
  EXPECT_GE(aluminium, bench_.lobes().anySpeed.value);
  choose("tap-material", 2);
  ASSERT_TRUE(until([&] { return bench_.lobes().state == TapLobes::State::Done; }));
  EXPECT_LT(bench_.lobes().depth.value, aluminium) << "steel is harder";
  // The shop's tool gets modes and cut in one file, and the next start its lobes.
  std::vector<ToolEntry> shop(1);
  shop[0].name = QStringLiteral("T12 D12 Z4");
  shop[0].teeth = 4;
  bench_.library = [&] { return Result<std::vector<ToolEntry>>(shop); };
  bench_.keepLibrary = [&](const std::vector<ToolEntry>& tools) -> Status {
    shop = tools;
    return Done{};
  };
  press(QStringLiteral("tap-find-modes"));
  press(QStringLiteral("tap-speeds"));
  choose("tap-tool", 1);
  EXPECT_EQ(find<QDoubleSpinBox>(QStringLiteral("tap-teeth"))->value(), 4.0);
  ASSERT_TRUE(until([&] { return bench_.lobes().state == TapLobes::State::Done; }));
  tick(40);
  press(QStringLiteral("tap-keep-cut"));
  const auto kept = milling::loadLobeCase(shop[0].modes.toStdString());
  ASSERT_TRUE(kept) << kept.error().line();
  EXPECT_EQ(kept->model.modes.size(), 4U);
  EXPECT_EQ(kept->model.tool.teeth, 4);
  EXPECT_EQ(shop[0].history.size(), 1U);
}

TEST_F(TapPageTest, AHitAndAModeCanBeLeftOutAndTheRestIsKept) {
  openTap();
  ASSERT_TRUE(listen());
  ASSERT_TRUE(measure(0));
  int good = 0;
  while (!bench_.hits(0)[static_cast<std::size_t>(good)].used) ++good;
  touchRow("tap-hits", good);
  EXPECT_EQ(bench_.run().good, 4);
  ASSERT_TRUE(until([&] { return bench_.response(0).state == TapResponse::State::Done; }));
  press(QStringLiteral("tap-find-modes"));
  tick(40);
  touchRow("tap-modes", 1);
  EXPECT_FALSE(bench_.response(0).modes[1].used);
  find<QLineEdit>(QStringLiteral("tap-name"))->setText(QStringLiteral("T12"));
  press(QStringLiteral("tap-keep"));
  const auto kept = identify::loadModes(folder_.filePath(QStringLiteral("modes/T12.toml")).toStdString());
  ASSERT_TRUE(kept) << kept.error().line();
  ASSERT_EQ(kept->modes.size(), 1U);
  EXPECT_NEAR(kept->modes[0].mode.frequency.value, 872.0, 3.0);
  // A file that cannot be read leaves what was measured.
  bench_.openFiles({folder_.filePath(QStringLiteral("none.csv"))}, 0);
  ASSERT_TRUE(until([&] { return !bench_.reading().problem.isEmpty(); }));
  EXPECT_EQ(bench_.response(0).modes.size(), 2U);
  bench_.openFiles({folder_.filePath(QStringLiteral("modes/T12.toml"))}, 0);
  const auto taken = [&] { return !bench_.files().isEmpty() && bench_.response(0).state == TapResponse::State::Done; };
  ASSERT_TRUE(until(taken));
  EXPECT_EQ(bench_.response(0).modes.size(), 1U) << "and what was kept can be looked at again";
}

TEST_F(TapPageTest, WithoutAHammerSpeedsAreToldAndNoDepth) {
  openTap();
  ASSERT_TRUE(listen());
  choose("tap-force", 0);
  tick(40);
  EXPECT_TRUE(text("tap-detail").contains(QStringLiteral("no depth"))) << text("tap-detail").toStdString();
  ASSERT_TRUE(measure(0));
  EXPECT_NEAR(bench_.response(0).modes[0].frequency.value, 872.0, 5.0);
  EXPECT_EQ(bench_.response(0).modes[0].stiffness, 0.0);
  press(QStringLiteral("tap-speeds"));
  tick(40);
  EXPECT_TRUE(text("tap-answer-detail").contains(QStringLiteral("force of a hammer")));
  ASSERT_FALSE(bench_.lobes().toTry.empty());
}

TEST_F(TapPageTest, WhatIsNoTapTestIsSaidInOneLine) {
  openTap();
  const QString file = folder_.filePath(QStringLiteral("letter.csv"));
  QFile letter(file);
  ASSERT_TRUE(letter.open(QIODevice::WriteOnly));
  letter.write("Dear customer,\nthank you for your order.\n");
  letter.close();
  bench_.openFiles({file}, 0);
  ASSERT_TRUE(until([&] { return bench_.response(0).state == TapResponse::State::Failed; }));
  tick(40);
  EXPECT_EQ(text("tap-sign"), QStringLiteral("Not measured"));
  EXPECT_TRUE(text("tap-detail").contains(QStringLiteral("letter.csv"))) << text("tap-detail").toStdString();
}

// One hit on a structure of one mode, as a logger writes it.
void writeHit(const QString& path, const QString& header, double frequency, int responses, double perVolt = 1.0) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(header.toUtf8() + '\n');
  constexpr double kStep = 1.0 / 51200.0, kMass = 0.5, kPulse = 0.25e-3, kBefore = 0.01;
  const double w = kTwoPi * frequency, damping = 0.03;
  double x = 0.0, v = 0.0;
  for (int i = 0; i < 20480; ++i) {
    const double at = i * kStep, in = at - kBefore;
    const double force = in > 0.0 && in < kPulse ? 300.0 * std::sin(kTwoPi * 0.5 * in / kPulse) : 0.0;
    const double a = force / kMass - 2.0 * damping * w * v - w * w * x;
    v += a * kStep;
    x += v * kStep;
    QByteArray line = QByteArray::number(at, 'g', 9) + ',' + QByteArray::number(force * perVolt, 'g', 9);
    for (int c = 0; c < responses; ++c) line += ',' + QByteArray::number(a * perVolt * (1.0 - 0.2 * c), 'g', 9);
    file.write(line + '\n');
  }
}

TEST_F(TapPageTest, ChannelsThatNameBothAxesGiveBoth) {
  openTap();
  const QString file = folder_.filePath(QStringLiteral("both.csv"));
  writeHit(file, QStringLiteral("time [s],Force [N],AccX [m/s^2],AccY [m/s^2]"), 872.0, 2);
  bench_.openFiles({file}, 0);
  ASSERT_TRUE(until([&] { return !bench_.reading().runs; }));
  EXPECT_TRUE(bench_.reading().problem.isEmpty()) << bench_.reading().problem.toStdString();
  for (int axis = 0; axis < kTapAxes; ++axis) {
    ASSERT_EQ(bench_.response(axis).state, TapResponse::State::Done) << axis;
    EXPECT_NEAR(bench_.response(axis).modes[0].frequency.value, 872.0, 10.0);
  }
}

TEST_F(TapPageTest, TheSecondAxisIsOpenedBesideTheFirstAndAWrongFileLosesNothing) {
  openTap();
  const QString x = folder_.filePath(QStringLiteral("first.csv")), y = folder_.filePath(QStringLiteral("second.csv"));
  writeHit(x, QStringLiteral("time [s],Force [N],Acc [m/s^2]"), 700.0, 1);
  writeHit(y, QStringLiteral("time [s],Force [N],Acc [m/s^2]"), 900.0, 1);
  bench_.openFiles({x}, 0);
  ASSERT_TRUE(until([&] { return bench_.response(0).state == TapResponse::State::Done; }));
  press(QStringLiteral("tap-y"));
  bench_.openFiles({y}, 1);
  ASSERT_TRUE(until([&] { return bench_.response(1).state == TapResponse::State::Done; }));
  ASSERT_EQ(bench_.response(0).state, TapResponse::State::Done) << "the first axis is still there";
  EXPECT_NEAR(bench_.response(0).modes[0].frequency.value, 700.0, 10.0);
  EXPECT_NEAR(bench_.response(1).modes[0].frequency.value, 900.0, 10.0);
  bench_.openFiles({folder_.filePath(QStringLiteral("none.csv"))}, 1);
  ASSERT_TRUE(until([&] { return !bench_.reading().runs; }));
  tick(40);
  EXPECT_EQ(text("tap-sign"), QStringLiteral("Not measured"));
  for (int axis = 0; axis < kTapAxes; ++axis) EXPECT_EQ(bench_.response(axis).state, TapResponse::State::Done);
}

// A soft mode in the noise of a weak hit, beside a stiff one that is clear.
void writeNoisyResponse(const QString& path, unsigned seed) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("Frequency [Hz],Real [m/N],Imag [m/N]\n");
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss(0.0, 1.0);
  const auto mode = [](double f, double at, double damping, double stiffness) {
    return 1.0 / (stiffness * std::complex<double>(1.0 - f * f / (at * at), 2.0 * damping * f / at));
  };
  for (double f = 1.0; f <= 4000.0; f += 1.0) {
    const double noise = 4.5e-7 * 540.0 * 540.0 / (f * f), re = noise * gauss(random), im = noise * gauss(random);
    const std::complex<double> h = mode(f, 540.0, 0.028, 8.5e6) + mode(f, 1320.0, 0.022, 2.4e7) + std::complex(re, im);
    file.write(QByteArray::number(f) + ',' + QByteArray::number(h.real(), 'g', 9) + ',' +
               QByteArray::number(h.imag(), 'g', 9) + '\n');
  }
}

TEST_F(TapPageTest, NoDepthIsRecommendedWhereTheSoftestModeIsBuriedInNoise) {
  openTap();
  const QString file = folder_.filePath(QStringLiteral("noisy.csv"));
  const auto missing = [&] {
    const QStringList& remarks = bench_.response(0).remarks;
    return std::ranges::any_of(remarks,
                               [](const QString& r) { return r.contains(QLatin1String("deeper than every")); });
  };
  for (unsigned seed = 1; seed <= 8 && !missing(); ++seed) {
    writeNoisyResponse(file, seed);
    bench_.openFiles({file}, 0);
    ASSERT_TRUE(until([&] { return !bench_.reading().runs; }));
  }
  ASSERT_TRUE(missing());
  bench_.compute({});
  EXPECT_EQ(bench_.lobes().state, TapLobes::State::Failed);
  EXPECT_TRUE(bench_.lobes().problem.contains(QLatin1String("average more hits")))
      << bench_.lobes().problem.toStdString();
  EXPECT_EQ(bench_.lobes().depth, Metres());
}

TEST_F(TapPageTest, WhatAFileDoesNotSayIsAskedOnThePage) {
  openTap();
  const QString file = folder_.filePath(QStringLiteral("volts.csv"));
  writeHit(file, QStringLiteral("time [s],Force [V],Acc [V]"), 872.0, 1, 0.01);
  bench_.openFiles({file}, 0);
  ASSERT_TRUE(until([&] { return !bench_.reading().runs; }));
  tick(40);
  ASSERT_FALSE(bench_.reading().questions.empty());
  EXPECT_FALSE(text("tap-detail").contains(QStringLiteral("--"))) << text("tap-detail").toStdString();
  const auto answer = [&](TapQuestion question, const QString& said) {
    auto* field = find<QLineEdit>(QStringLiteral("tap-question-%1").arg(static_cast<int>(question)));
    if (field != nullptr) field->setText(said);
  };
  savePage(*window_, "tap", kPageLooks[0], "asks");
  for (int round = 0; round < 3 && !bench_.reading().problem.isEmpty(); ++round) {
    answer(TapQuestion::ForceSensitivity, QStringLiteral("10 mV/N"));
    answer(TapQuestion::ResponseSensitivity, QStringLiteral("10 mV/(m/s^2)"));
    press(QStringLiteral("tap-read"));
    ASSERT_TRUE(until([&] { return !bench_.reading().runs; }));
    tick(40);
  }
  ASSERT_TRUE(bench_.reading().problem.isEmpty()) << bench_.reading().problem.toStdString();
  EXPECT_NEAR(bench_.response(0).modes[0].frequency.value, 872.0, 10.0);
  EXPECT_FALSE(find<TouchButton>("tap-read")->isVisible());
}

TEST_F(TapPageTest, KeepAsksBeforeItOverwrites) {
  openTap();
  const QString file = folder_.filePath(QStringLiteral("hit.csv"));
  writeHit(file, QStringLiteral("time [s],Force [N],Acc [m/s^2]"), 872.0, 1);
  bench_.openFiles({file}, 0);
  ASSERT_TRUE(until([&] { return bench_.response(0).state == TapResponse::State::Done; }));
  press(QStringLiteral("tap-find-modes"));
  tick(40);
  find<QLineEdit>(QStringLiteral("tap-name"))->setText(QStringLiteral("T12"));
  press(QStringLiteral("tap-keep"));
  EXPECT_TRUE(text("tap-kept").startsWith(QStringLiteral("Kept")));
  press(QStringLiteral("tap-keep"));
  EXPECT_TRUE(text("tap-kept").contains(QStringLiteral("again"))) << text("tap-kept").toStdString();
  EXPECT_TRUE(find<TouchButton>("tap-keep")->asking());
  press(QStringLiteral("tap-keep"));
  EXPECT_TRUE(text("tap-kept").startsWith(QStringLiteral("Kept")));
}

class TapPictures : public TapPageTest, public testing::WithParamInterface<PageLook> {};

TEST_P(TapPictures, EveryStepFits) {
  openTap(GetParam().width, GetParam().height, GetParam().theme);
  savePage(*window_, "tap", GetParam(), "empty");
  ASSERT_TRUE(listen());
  press(QStringLiteral("tap-begin"));
  ASSERT_TRUE(until([&] { return bench_.run().good == 3; }));
  savePage(*window_, "tap", GetParam(), "hit");
  ASSERT_TRUE(measure(0));
  press(QStringLiteral("tap-find-modes"));
  tick(40);
  savePage(*window_, "tap", GetParam(), "modes");
  press(QStringLiteral("tap-speeds"));
  ASSERT_TRUE(until([&] { return bench_.lobes().state == TapLobes::State::Done; }));
  tick(40);
  savePage(*window_, "tap", GetParam(), "speed");
}

INSTANTIATE_TEST_SUITE_P(Looks, TapPictures, testing::ValuesIn(kPageLooks), lookName);

}  // namespace
}  // namespace stillcut::ui
