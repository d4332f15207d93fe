// The window: head, page, command bar, status strip, and the display tick that pulls the newest snapshot. Pages come
// from the page table; the window knows none of them. Ctrl+1 .. Ctrl+8 show a page, Esc closes what lies on top of it
// and nothing else, F1 opens the manual at the part on the page, F12 changes the theme, F11 opens the choice of theme,
// units and language. Another language makes everything inside the window anew.
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>
#include <optional>
#include <vector>

#include "ui/base/theme.h"
#include "ui/models/freshness.h"
#include "ui/models/history/run_history.h"
#include "ui/models/history/signal_history.h"
#include "ui/shell/display_panel.h"
#include "ui/shell/session_facade.h"
#include "ui/shell/window_state.h"

class QStackedWidget;

namespace stillcut::ui {

class CommandBar;
class HeaderBar;
class ManualPanel;
class Page;
class StatusStrip;

inline constexpr int kDisplayTickMs = 33;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  // The session must outlive the window. Ticks by itself once start() was called. Without a theme or a language: the
  // one kept, or the desktop's.
  explicit MainWindow(SessionFacade& session, std::optional<ThemeKind> theme = {},
                      std::optional<Language> language = {});
  ~MainWindow() override;

  // Size, place, and page as they were left.
  void restorePlace();
  void start();
  // On the first start, and only while no cut runs, the guide of the Set up page comes by itself. True: it has.
  // A cut that runs afterwards is its answer, and it does not come again.
  bool offerGuide();
  // One display tick at `nowMs` of the screen's own clock.
  void tick(qint64 nowMs);
  const DisplayChoice& look() const { return look_; }
  void showPage(const QString& id);
  QString currentPage() const;
  // Shows a recording on the page for that; empty: it asks which.
  void openFile(const QString& path);

 signals:
  // The window was closed; the session must bring the programmed values back.
  void closed();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void build();
  void addPages();
  void showPage(int index);
  void meetSession();
  void runAgain();
  void closeTop();
  void nextTheme();
  void toggleManual();
  void openManual(const QString& link);
  void placeManual();
  void toggleDisplayPanel();
  void setLook(const DisplayChoice& look);
  void retheme();
  void keepState();

  SessionFacade& session_;
  WindowState state_;
  DisplayChoice look_;
  Speaker speaker_;
  double scale_ = 0.0;
  bool stateChanged_ = false;  // something that outlives a restart is not on the disk yet
  qint64 nowMs_ = 0, keptMs_ = 0;
  std::uint32_t generation_ = 0;
  QString notRunAgain_;                  // of this generation
  Freshness freshness_, liveFreshness_;  // of what the pages show, and of the machine's own cut
  RunHistory history_;
  SignalHistory signal_;
  QTimer timer_;
  QElapsedTimer clock_;
  HeaderBar* header_ = nullptr;
  QStackedWidget* stack_ = nullptr;
  std::vector<Page*> pages_;
  CommandBar* command_ = nullptr;
  StatusStrip* strip_ = nullptr;
  DisplayPanel* display_ = nullptr;
  ManualPanel* manual_ = nullptr;
};

}  // namespace stillcut::ui
