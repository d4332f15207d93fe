// What the screens cost: for every page the share of one core at 30 frames a second, 1920 x 1080, as a window draws it
// (only what has changed) and all of it anew; and how long a start takes until the first live picture. Prints numbers,
// asserts none. Run it by hand: bench_ui [SCENARIO.toml].
#include <QApplication>
#include <QElapsedTimer>
#include <cstdio>
#include <ctime>

#include "app/session/session.h"
#include "tests/ui/support/fake_session.h"
#include "ui/shell/main_window.h"
#include "ui/shell/page_table.h"

namespace stillcut::ui {
namespace {

constexpr int kFrames = 300;

// Processor time per frame [ms].
double costOf(FakeSession& session, MainWindow& window, bool wholeWindow) {
  static int frame = 0;
  std::clock_t used = 0;
  for (int k = 0; k < kFrames; ++k, ++frame) {
    session.advance(Seconds(0.04));  // a new column with every frame, bars and numbers moving
    const std::clock_t before = std::clock();
    window.tick(frame * 33);
    if (wholeWindow) window.repaint();
    QCoreApplication::processEvents();
    used += std::clock() - before;
  }
  return 1e3 * static_cast<double>(used) / CLOCKS_PER_SEC / kFrames;
}

void startToPicture(const char* scenario) {
  QElapsedTimer clock;
  clock.start();
  auto session = app::openScenarioSession(scenario, true);
  if (!session) return;
  MainWindow window(**session, ThemeKind::Light, Language::English);
  window.show();
  (*session)->keepFlightsIn("/tmp");
  (*session)->start();
  while ((*session)->pull() == nullptr && clock.elapsed() < 10'000) QCoreApplication::processEvents();
  window.tick(0);
  QCoreApplication::processEvents();
  std::printf("start to live picture: %.2f s\n", static_cast<double>(clock.elapsed()) * 1e-3);
  (void)(*session)->stop().ok();
}

}  // namespace
}  // namespace stillcut::ui

int main(int argc, char** argv) {
  using namespace stillcut;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication app(argc, argv);
  ui::startToPicture(argc > 1 ? argv[1] : STILLCUT_RESOURCE_DIR "/scenarios/demo.toml");
  ui::FakeSession session;
  ui::MainWindow window(session, ui::ThemeKind::Dark, ui::Language::English);
  window.resize(1920, 1080);
  window.show();
  session.send({OperatorAction::SetAuthority, Authority::Auto}, session.generation());
  for (const ui::PageEntry& entry : ui::pageTable()) {
    window.showPage(QLatin1String(entry.id));
    ui::costOf(session, window, false);  // fills the history
    const double drawn = ui::costOf(session, window, false), whole = ui::costOf(session, window, true);
    std::printf("%-10s 1920x1080: %5.2f ms per frame, %4.1f %% of one core at 30 frames/s (all anew: %.1f %%)\n",
                entry.id, drawn, drawn * 3.0, whole * 3.0);
  }
  return 0;
}
