#include "ui/shell/main_window.h"

#include <QCloseEvent>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <cmath>

#include "ui/models/strip_view.h"
#include "ui/pages/operate_page.h"
#include "ui/shell/apply_theme.h"
#include "ui/shell/header_bar.h"
#include "ui/widgets/command_bar.h"
#include "ui/widgets/status_strip.h"

namespace stillcut::ui {

MainWindow::MainWindow(SessionFacade& session, ThemeKind theme, QWidget* parent)
    : QMainWindow(parent),
      session_(session),
      kind_(theme),
      header_(new HeaderBar),
      pages_(new QStackedWidget),
      operate_(new OperatePage),
      command_(new CommandBar),
      strip_(new StatusStrip) {
  setWindowTitle(tr("Stillcut"));
  auto* centre = new QWidget;
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(header_);
  column->addWidget(pages_, 1);
  column->addWidget(command_);
  column->addWidget(strip_);
  setCentralWidget(centre);

  header_->setSession(session.info());
  pages_->addWidget(operate_);
  header_->addPage(tr("Operate"));
  header_->setCurrentPage(0);
  connect(header_, &HeaderBar::pageAsked, this, [this](int index) {
    pages_->setCurrentIndex(index);
    header_->setCurrentPage(index);
  });
  connect(header_, &HeaderBar::themeAsked, this, &MainWindow::nextTheme);
  connect(new QShortcut(Qt::Key_F12, this), &QShortcut::activated, this, &MainWindow::nextTheme);
  connect(operate_, &OperatePage::asked, this, [this](const OperatorInput& input) { session_.send(input); });
  connect(command_, &CommandBar::asked, this, [this](const OperatorInput& input) { session_.send(input); });
  connect(&timer_, &QTimer::timeout, this, [this] { tick(clock_.elapsed()); });
  operate_->setFocusPolicy(Qt::ClickFocus);
  operate_->setFocus();
  resize(1280, 800);
  retheme();
}

void MainWindow::start() {
  clock_.start();
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.start(kDisplayTickMs);
}

void MainWindow::tick(qint64 nowMs) {
  const Snapshot* snapshot = session_.pull();
  freshness_.see(snapshot, nowMs);
  const Picture picture{&session_.info(),    snapshot,       freshness_.age(), snapshot && freshness_.stale(), nowMs,
                        session_.recorder(), session_.link()};
  operate_->display(picture);
  command_->display(makeCommandView(picture), nowMs);
  strip_->display(makeStrip(picture));
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  if (std::abs(scaleForSize(width(), height()) - scale_) > 1e-9) retheme();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  timer_.stop();
  emit closed();
  event->accept();
}

void MainWindow::nextTheme() {
  kind_ = kind_ == ThemeKind::Light  ? ThemeKind::Dark
          : kind_ == ThemeKind::Dark ? ThemeKind::HighContrast
                                     : ThemeKind::Light;
  retheme();
  emit themeChanged(kind_);
}

void MainWindow::retheme() {
  scale_ = scaleForSize(width(), height());
  applyTheme(*this, makeTheme(kind_, scale_));
}

}  // namespace stillcut::ui
