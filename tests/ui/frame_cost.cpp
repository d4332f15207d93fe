// What a display tick costs at most: prints the share of one core the operator page takes at 30 frames a second, 1920 x
// 1080. Not a test: run it by hand (ui_frame_cost).
#include <QApplication>
#include <cstdio>
#include <ctime>

#include "tests/ui/fake_session.h"
#include "ui/shell/main_window.h"

int main(int argc, char** argv) {
  using namespace stillcut;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication app(argc, argv);
  ui::FakeSession session;
  ui::MainWindow window(session, ui::ThemeKind::Dark);
  window.resize(1920, 1080);
  window.show();
  QCoreApplication::processEvents();
  session.send({OperatorAction::SetAuthority, Authority::Auto});
  constexpr int kFrames = 300;
  std::clock_t used = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    session.advance(Seconds(0.04));  // a new column with every frame, bars and numbers moving
    const std::clock_t before = std::clock();
    window.tick(frame * 33);
    window.repaint();  // all of it, although most of the page has not changed: an upper bound
    used += std::clock() - before;
  }
  const double perFrame_ms = 1e3 * static_cast<double>(used) / CLOCKS_PER_SEC / kFrames;
  std::printf("operator page 1920x1080: %.2f ms per frame, %.1f %% of one core at 30 frames/s\n", perFrame_ms,
              perFrame_ms * 3.0);
  return 0;
}
