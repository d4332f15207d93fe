// Pictures for people to look at, written to the build folder: the operator page in the states that matter, and every
// page in light and dark, two sizes, three languages. What a machine can check of them is that nothing was cut off.
#include <QDir>
#include <QListView>
#include <QScrollArea>
#include <algorithm>
#include <ostream>
#include <vector>

#include "tests/ui/support/fake_active_desk.h"
#include "tests/ui/support/fake_file_desk.h"
#include "tests/ui/support/fake_session_desk.h"
#include "tests/ui/support/fake_setup_desk.h"
#include "tests/ui/support/fake_tap_desk.h"
#include "tests/ui/support/fake_tuning.h"
#include "tests/ui/support/page_picture.h"
#include "tests/ui/support/ui_fixture.h"
#include "ui/pages/active_view.h"
#include "ui/pages/intervention_list.h"
#include "ui/pages/rule_grid.h"
#include "ui/shell/header_bar.h"
#include "ui/shell/page_table.h"
#include "ui/widgets/advice_panel.h"
#include "ui/widgets/command_bar.h"
#include "ui/widgets/intervention_card.h"
#include "ui/widgets/limit_bar.h"
#include "ui/widgets/override_table.h"
#include "ui/widgets/status_strip.h"
#include "ui/widgets/verdict_sign.h"

namespace stillcut::ui {
namespace {

struct Look {
  const char* name;
  ThemeKind theme;
  int width, height;
};

void PrintTo(const Look& look, std::ostream* out) {
  *out << look.name;
}

class Screenshots : public WindowTest, public testing::WithParamInterface<Look> {
 protected:
  void save(const char* state) {
    const QDir folder(QStringLiteral(STILLCUT_SCREENSHOT_DIR));
    ASSERT_TRUE(folder.mkpath(QStringLiteral(".")));
    const QString file =
        folder.filePath(QStringLiteral("operate-%1-%2.png").arg(QLatin1String(GetParam().name), QLatin1String(state)));
    const QImage image = picture();
    EXPECT_EQ(image.size(), QSize(GetParam().width, GetParam().height));
    EXPECT_TRUE(image.save(file));
    expectNothingCut(state);
  }
  template <class Widget>
  void expectWhole(const char* state) {
    for (const Widget* widget : window_->findChildren<Widget*>()) {
      if (!widget->isVisible()) continue;
      EXPECT_FALSE(widget->clipped()) << state << ": " << widget->metaObject()->className() << " "
                                      << widget->accessibleName().toStdString();
      const QSize least = widget->minimumSizeHint();
      EXPECT_GE(widget->width(), least.width()) << state << ": " << widget->metaObject()->className();
      EXPECT_GE(widget->height(), least.height()) << state << ": " << widget->metaObject()->className();
    }
  }
  void expectNothingCut(const char* state) {
    EXPECT_LE(window_->minimumSizeHint().width(), GetParam().width) << state;
    EXPECT_LE(window_->minimumSizeHint().height(), GetParam().height) << state;
    expectWhole<VerdictSign>(state);
    expectWhole<AdvicePanel>(state);
    expectWhole<TouchButton>(state);
    expectWhole<LimitBar>(state);
    expectWhole<OverrideTable>(state);
    expectWhole<InterventionCard>(state);
    expectWhole<InterventionList>(state);
    expectWhole<StatusStrip>(state);
    expectWhole<CommandBar>(state);
  }
};

TEST_P(Screenshots, EveryStateFits) {
  session_.mutableInfo().machineWatchdog = false;
  open(GetParam().width, GetParam().height, GetParam().theme);
  save("waiting");
  play(0.2);
  save("no-verdict");
  press("advise");
  play(4.2);
  save("stable");
  while (session_.snapshot().verdicts[0].state != CutState::Onset) play(0.04);
  save("onset");
  play(0.6);
  ASSERT_EQ(session_.snapshot().verdicts[0].state, CutState::Chatter);
  save("chatter");
  press("accept");
  play(2.4);
  press("auto");
  tick(40);
  save("quiet");
  tick(2300);
  save("stale");
  expectWhole<HeaderBar>("stale");
}

// Everything that can go wrong on one page, with long names.
TEST_P(Screenshots, TroubleFits) {
  session_.mutableInfo().setup.machine = "Bearbeitungszentrum Halle 4 Nord";
  session_.mutableInfo().setup.tool = "T12 D12 Z4 R0.5 HSK63A stick-out 48, shrink-fit holder, second regrind";
  session_.mutableInfo().linkLabel = "simulated machine";
  open(GetParam().width, GetParam().height, GetParam().theme);
  play(0.2);
  press("auto");
  play(5.4);
  Snapshot& s = session_.snapshot();
  s.machine.linkUp = false;
  s.machine.time = s.time - std::chrono::milliseconds(3400);
  s.operatorHold = true;
  s.health.droppedBlocks = 1234;
  s.health.overruns = 17;
  s.health.blockAge = Seconds(0.127);
  s.verdicts[0].valid = false;
  s.verdicts[0].reason = {ReasonCode::InputGap, {2560}};
  s.eventCount = 1;
  s.events[0] = {s.time, 0, EventLevel::Fault, {ReasonCode::LeaseExpired, {0.25}}};
  session_.mutableRecorder() = {RecorderView::State::Failed, Seconds(), "disk full"};
  s.spectrumTop = Hertz(12800);
  session_.touch();
  tick(40);
  save("trouble");
}

INSTANTIATE_TEST_SUITE_P(Looks, Screenshots,
                         testing::Values(Look{"light-1280", ThemeKind::Light, 1280, 800},
                                         Look{"dark-1280", ThemeKind::Dark, 1280, 800},
                                         Look{"light-1920", ThemeKind::Light, 1920, 1080},
                                         Look{"dark-1920", ThemeKind::Dark, 1920, 1080},
                                         Look{"contrast-1280", ThemeKind::HighContrast, 1280, 800}),
                         [](const auto& looked) {
                           std::string name = looked.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

struct Edition {
  Language language;
  ThemeKind theme;
  int width, height;
};

const char* nameOf(ThemeKind theme) {
  return theme == ThemeKind::Dark ? "dark" : theme == ThemeKind::Light ? "light" : "contrast";
}

void PrintTo(const Edition& e, std::ostream* out) {
  *out << languageCode(e.language).toStdString() << e.width << nameOf(e.theme);
}

// A text that its widget is too small for is drawn cut off, or tells it; both count.
class EveryPage : public WindowTest, public testing::WithParamInterface<Edition> {
 protected:
  QString file(const char* page) const {
    const Edition& e = GetParam();
    return QStringLiteral("%1/%2-%3-%4-%5.png")
        .arg(QStringLiteral(STILLCUT_SCREENSHOT_DIR), QLatin1String(page), languageCode(e.language),
             QLatin1String(nameOf(e.theme)))
        .arg(e.width);
  }
  // As it is now, and whole.
  void keep(const char* name) {
    play(0.2);
    QCoreApplication::processEvents();
    EXPECT_TRUE(window_->grab().save(file(name)));
    expectNothingCut(*window_, QLatin1String(name), {GetParam().width, GetParam().height});
    expectNames(*window_, QLatin1String(name));
  }
  // Every page with something on it.
  void furnish() {
    ToolEntry tool;
    tool.name = QStringLiteral("T12 D12 Z4 R0.5");
    tool.holder = QStringLiteral("HSK63, 48");
    tool.teeth = 4;
    tool.diameter_mm = 12.0;
    tool.chattered = {{8800.0, 1.5, 1713.0, QStringLiteral("slot, first pass")}};
    setup_.shop = {tool};
    setup_.kept[QStringLiteral("mill3")] = {};
    session_.setTuning(&tuning_);
    session_.setSetup(&setup_);
    session_.setSessions(&sessions_);
    session_.setTap(&tap_);
    session_.setFiles(&files_);
  }
  void chooseRow(const char* list, int row) const {
    auto* view = find<QListView>(QLatin1String(list));
    ASSERT_NE(view, nullptr) << list;
    view->setCurrentIndex(view->model()->index(row, 0));
  }

  FakeTuning tuning_{"fuzzy-learning"};
  FakeSetupDesk setup_;
  FakeSessionDesk sessions_;
  FakeTapDesk tap_;
  FakeFileDesk files_;
  FakeActiveDesk table_;
};

TEST_P(EveryPage, FitsAndIsKeptAsAPicture) {
  ASSERT_TRUE(QDir().mkpath(QStringLiteral(STILLCUT_SCREENSHOT_DIR)));
  furnish();
  open(GetParam().width, GetParam().height, GetParam().theme, GetParam().language);
  play(1.0);
  press("advise");
  while (session_.snapshot().verdicts[0].state != CutState::Chatter) play(0.04);
  play(0.8);
  for (const PageEntry& entry : pageTable()) {
    window_->showPage(QLatin1String(entry.id));
    play(0.2);
    if (session_.fakeLobes().progress().state == LobeProgress::State::Running) session_.fakeLobes().finish();
    keep(entry.id);
  }
}

// What lies behind a second touch.
TEST_P(EveryPage, EveryPartOfAPageFits) {
  furnish();
  open(GetParam().width, GetParam().height, GetParam().theme, GetParam().language);
  play(1.0);
  window_->showPage(QStringLiteral("setup"));
  press("setup-machine");
  press("link-linuxcnc");
  keep("setup-machine");
  press("setup-sensors");
  press("device-other");
  press("source-simulated");
  press("channel-add");
  keep("setup-sensors");
  press("setup-tools");
  keep("setup-tools");
  press("setup-recording");
  keep("setup-recording");
  press("setup-limits");
  keep("setup-limits");
  press("setup-profile");
  press("profile-try");
  keep("setup-profile");
  window_->showPage(QStringLiteral("tune"));
  press("tune-expert");
  for (int row = 0; !find<RuleGrid>("rules")->isVisible(); ++row) chooseRow("tune-parts", row);
  QCoreApplication::processEvents();  // the rows have their places now
  find<QScrollArea>("tune-rows")->ensureWidgetVisible(find<RuleGrid>("rules"), 0, 60);
  keep("tune-rules");
  window_->showPage(QStringLiteral("sessions"));
  sessions_.open(sessions_.entries().front().path);
  keep("sessions-open");
  press("sheet-compare");
  keep("sessions-compare");
  press("sheet-events");
  keep("sessions-events");
  window_->showPage(QStringLiteral("tap"));
  press("tap-find-modes");
  keep("tap-modes");
  press("tap-keep");
  keep("tap-kept");
  press("tap-speeds");
  keep("tap-speed");
  files_.toldByFile = {4, Rpm(9504.0)};
  files_.found.speed_rpm = {9504.0, 3.0, {4752.0, 19'008.0}};
  files_.recorded = FileTrack{QStringLiteral("Recorded"), {{Seconds(4.0), Seconds(8.0), CutState::Chatter, true}}};
  window_->openFile(QStringLiteral("/rec/Housing, second side, 12 mm end mill, slot.m4a"));
  play(0.2);
  files_.finish();
  keep("file-open");
  press("file-log");
  files_.open(FileController::Beside, QStringLiteral("/rec/before.wav"));
  keep("file-beside");
  window_->showPage(QStringLiteral("sessions"));
  QTest::keyClick(window_.get(), Qt::Key_F1);
  keep("manual");
  QTest::keyClick(window_.get(), Qt::Key_F1);
  QTest::keyClick(window_.get(), Qt::Key_F11);
  keep("display");
}

// The operator's page when something is wrong, the active table, the other pictures of Analyse, and inches.
TEST_P(EveryPage, EveryStateAndChoiceFits) {
  furnish();
  table_.snapshot = exampleActive();
  table_.fits = {exampleFit(), std::nullopt};
  session_.setActive(&table_);
  open(GetParam().width, GetParam().height, GetParam().theme, GetParam().language);
  play(0.2);
  keep("operate-no-verdict");
  while (session_.snapshot().verdicts[0].state != CutState::Onset) play(0.04);
  keep("operate-onset");
  window_->showPage(QStringLiteral("tune"));
  press("tune-expert");
  const int parts = find<QListView>("tune-parts")->model()->rowCount();
  for (int row = 0; row < parts && !find<ActiveView>()->isVisible(); ++row) chooseRow("tune-parts", row);
  EXPECT_TRUE(find<ActiveView>()->isVisible());
  keep("tune-active");
  window_->showPage(QStringLiteral("analyse"));
  press("order");
  keep("analyse-orders");
  press("events");
  keep("analyse-events");
  press("events");
  press("waterfall");
  keep("analyse-waterfall");
  press("display");
  press("units-1");
  QCoreApplication::processEvents();
  for (const char* const page : {"operate", "lobes"}) {
    window_->showPage(QLatin1String(page));
    if (session_.fakeLobes().progress().state == LobeProgress::State::Running) session_.fakeLobes().finish();
    keep((std::string("inch-") + page).c_str());
  }
  window_->showPage(QStringLiteral("setup"));
  for (const char* const tab : {"machine", "tools"}) {
    press(QStringLiteral("setup-") + QLatin1String(tab));
    keep((std::string("inch-") + tab).c_str());
  }
  window_->showPage(QStringLiteral("operate"));
  tick(2300);
  EXPECT_TRUE(window_->grab().save(file("operate-stale")));
  expectNothingCut(*window_, QStringLiteral("operate-stale"), {GetParam().width, GetParam().height});
}

INSTANTIATE_TEST_SUITE_P(
    Looks, EveryPage, testing::ValuesIn([] {
      std::vector<Edition> editions;
      for (const Language language : kLanguages) {
        for (const ThemeKind theme : {ThemeKind::Light, ThemeKind::Dark, ThemeKind::HighContrast}) {
          editions.push_back({language, theme, 1280, 800});
          editions.push_back({language, theme, 1920, 1080});
        }
      }
      return editions;
    }()),
    [](const auto& edition) { return testing::PrintToString(edition.param); });

}  // namespace
}  // namespace stillcut::ui
