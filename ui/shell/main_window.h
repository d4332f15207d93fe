// The window: head, page, command bar, status strip, and the display tick that pulls the newest snapshot.
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>

#include "ui/models/freshness.h"
#include "ui/models/theme.h"
#include "ui/shell/session_facade.h"

class QStackedWidget;

namespace stillcut::ui {

class CommandBar;
class HeaderBar;
class OperatePage;
class StatusStrip;

inline constexpr int kDisplayTickMs = 33;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  // The session must outlive the window. Ticks by itself once start() was called.
  MainWindow(SessionFacade& session, ThemeKind theme, QWidget* parent = nullptr);

  void start();
  // One display tick at `nowMs` of the screen's own clock.
  void tick(qint64 nowMs);
  ThemeKind theme() const { return kind_; }

 signals:
  void themeChanged(stillcut::ui::ThemeKind kind);
  // The window was closed; the session must bring the programmed values back.
  void closed();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void nextTheme();
  void retheme();

  SessionFacade& session_;
  ThemeKind kind_;
  double scale_ = 0.0;
  Freshness freshness_;
  QTimer timer_;
  QElapsedTimer clock_;
  HeaderBar* header_;
  QStackedWidget* pages_;
  OperatePage* operate_;
  CommandBar* command_;
  StatusStrip* strip_;
};

}  // namespace stillcut::ui
