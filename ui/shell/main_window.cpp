#include "ui/shell/main_window.h"

#include <QCloseEvent>
#include <QDialog>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QGraphicsView>
#include <QIcon>
#include <QLocale>
#include <QMimeData>
#include <QPainter>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QShortcut>
#include <QStackedWidget>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/base/say.h"
#include "ui/models/strip_view.h"
#include "ui/pages/page.h"
#include "ui/plots/touch_input.h"
#include "ui/shell/apply_theme.h"
#include "ui/shell/header_bar.h"
#include "ui/shell/manual_panel.h"
#include "ui/shell/page_table.h"
#include "ui/widgets/command_bar.h"
#include "ui/widgets/status_strip.h"
#include "ui/widgets/verdict_shape.h"

namespace stillcut::ui {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr qint64 kKeepEveryMs = 1000;  // a dragged slider is not a write each

// The sign of chatter, as the operator's page has it.
QIcon programIcon() {
  constexpr int kSide = 64;
  QPixmap sign(kSide, kSide);
  sign.fill(Qt::transparent);
  QPainter p(&sign);
  p.setRenderHint(QPainter::Antialiasing);
  const Theme theme = makeTheme(ThemeKind::Light, 1.0);
  drawVerdictShape(p, QRectF(2, 2, kSide - 4, kSide - 4), Shape::Octagon, theme, theme.colors.chatter,
                   theme.colors.onChatter);
  return sign;
}

// A scroll area gives wrapped texts all the height they would like; a page makes do with its window as long as it can.
class PageLayout : public QVBoxLayout {
 public:
  explicit PageLayout(QWidget* parent) : QVBoxLayout(parent) { setContentsMargins(0, 0, 0, 0); }
  bool hasHeightForWidth() const override { return false; }
};

// On a screen too low for a page in buttons of 12 mm the page scrolls: what commands the machine never leaves the
// screen.
QScrollArea* scrolled(QWidget* page) {
  auto* area = new QScrollArea;
  area->setObjectName(QStringLiteral("scroll"));
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidgetResizable(true);
  auto* whole = new QWidget;
  (new PageLayout(whole))->addWidget(page);
  area->setWidget(whole);
  return area;
}

}  // namespace

MainWindow::MainWindow(SessionFacade& session, std::optional<ThemeKind> theme, std::optional<Language> language)
    : session_(session),
      state_(session.stateFolder()),
      look_{theme.value_or(state_.theme().value_or(desktopTheme())), state_.textSize(), state_.units(),
            language.value_or(state_.language().value_or(desktopLanguage()))},
      speaker_(look_.language) {
  setWindowTitle(QStringLiteral("Stillcut"));
  setAcceptDrops(true);
  setWindowIcon(programIcon());
  connect(&timer_, &QTimer::timeout, this, [this] { tick(clock_.elapsed()); });
  resize(1280, 800);
  build();
}

void MainWindow::build() {
  setLocale(QLocale());  // this window was made before its language was chosen, and its fields take after it
  auto* centre = new QWidget;
  header_ = new HeaderBar;
  stack_ = new QStackedWidget;
  command_ = new CommandBar;
  strip_ = new StatusStrip;
  display_ = new DisplayPanel(centre);
  manual_ = new ManualPanel(look_.language, centre);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(header_);
  column->addWidget(stack_, 1);
  column->addWidget(command_);
  column->addWidget(strip_);
  setCentralWidget(centre);

  addPages();
  meetSession();
  connect(header_, &HeaderBar::pageAsked, this, qOverload<int>(&MainWindow::showPage));
  connect(header_, &HeaderBar::displayAsked, this, &MainWindow::toggleDisplayPanel);
  connect(display_, &DisplayPanel::chosen, this, &MainWindow::setLook, Qt::QueuedConnection);
  connect(display_, &DisplayPanel::helpAsked, this, &MainWindow::toggleManual);
  connect(new QShortcut(Qt::Key_F1, centre), &QShortcut::activated, this, &MainWindow::toggleManual);
  connect(new QShortcut(Qt::Key_F12, centre), &QShortcut::activated, this, &MainWindow::nextTheme);
  connect(new QShortcut(Qt::Key_F11, centre), &QShortcut::activated, this, &MainWindow::toggleDisplayPanel);
  connect(new QShortcut(Qt::Key_Escape, centre), &QShortcut::activated, this, &MainWindow::closeTop);
  connect(command_, &CommandBar::asked, this,
          [this](const OperatorInput& input) { session_.send(input, generation_); });
  for (QAbstractScrollArea* area : findChildren<QAbstractScrollArea*>()) {
    // Charts have fingers of their own; a plain text counts lines, not pixels, and is short.
    if (qobject_cast<QGraphicsView*>(area) != nullptr || qobject_cast<QPlainTextEdit*>(area) != nullptr) continue;
    TouchInput::scroll(*area);
  }
  retheme();
}

MainWindow::~MainWindow() = default;

void MainWindow::addPages() {
  for (const PageEntry& entry : pageTable()) {
    Page* page = entry.make(session_);
    page->setObjectName(QLatin1String(entry.id));
    page->setFocusPolicy(Qt::ClickFocus);
    const QString title = pageTitle(entry);
    if (page->accessibleName().isEmpty()) page->setAccessibleName(title);
    const int index = stack_->addWidget(scrolled(page));
    pages_.push_back(page);
    const QKeySequence key(static_cast<int>(Qt::CTRL) | (static_cast<int>(Qt::Key_0) + entry.number));
    header_->addPage(title, key, QStringLiteral("page-") + QLatin1String(entry.id));
    connect(new QShortcut(key, centralWidget()), &QShortcut::activated, this, [this, index] { showPage(index); });
    connect(page, &Page::pageAsked, this, qOverload<const QString&>(&MainWindow::showPage));
    connect(page, &Page::fileAsked, this, &MainWindow::openFile);
    connect(page, &Page::manualAsked, this, &MainWindow::openManual);
    connect(page, &Page::againAsked, this, &MainWindow::runAgain);
    connect(page, &Page::stateChanged, this, [this] { stateChanged_ = true; });
    connect(page, &Page::asked, this, [this](const OperatorInput& input) {
      history_.note(input);
      session_.send(input, generation_);
    });
  }
  state_.restore(pages_);
  showPage(0);
  stateChanged_ = false;
}

void MainWindow::meetSession() {
  generation_ = session_.generation();
  notRunAgain_.clear();
  header_->setSession(session_.info());
  history_.clear();
  signal_.prepare(session_.info().setup);
  for (Page* page : pages_) page->restart();
}

void MainWindow::runAgain() {
  const Status begun = session_.runAgain();
  notRunAgain_ = begun ? QString() : sayError(begun.error());
}

void MainWindow::restorePlace() {
  const QByteArray kept = state_.geometry();
  if (kept.isEmpty()) {
    setWindowState(Qt::WindowMaximized);  // with the title bar all of it is on the screen, however small that is
  } else {
    restoreGeometry(kept);
  }
  showPage(state_.page());
}

void MainWindow::start() {
  clock_.start();
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.start(kDisplayTickMs);
}

bool MainWindow::offerGuide() {
  if (state_.guideSeen() || session_.setup() == nullptr) return false;
  const Snapshot* snapshot = session_.pull();
  if (snapshot != nullptr && snapshot->running) return false;
  showPage(QStringLiteral("setup"));
  return true;
}

void MainWindow::tick(qint64 nowMs) {
  const Snapshot* snapshot = session_.pull();
  if (session_.generation() != generation_) meetSession();
  const bool replay = session_.replayShown();
  const Snapshot* live = replay ? session_.live() : snapshot;
  freshness_.see(snapshot, nowMs, !replay);
  liveFreshness_.see(live, nowMs);
  if (snapshot != nullptr) history_.see(*snapshot);
  if (live != nullptr && live->running && !state_.guideSeen()) state_.setGuideSeen();
  session_.readSignal([this](const SampleBlock& block) { signal_.add(block); });
  ActiveController* table = session_.active();
  if (table != nullptr) table->poll();
  const bool paused = replay && session_.replayStands();
  Picture picture{&session_.info(),
                  snapshot,
                  freshness_.age(),
                  snapshot && freshness_.stale() && !paused,
                  paused,
                  nowMs,
                  session_.recorder(),
                  replay ? LinkStatus{} : session_.link(),
                  look_.units,
                  &history_,
                  &signal_,
                  table != nullptr ? table->pull() : nullptr,
                  replay ? kUnknown : session_.vibrationWithout(snapshot ? snapshot->time : Instant{}),
                  !replay && session_.mayRunAgain(),
                  notRunAgain_,
                  replay,
                  replay ? std::nullopt : session_.depthMargin()};
  for (Page* page : pages_) page->see(picture);
  pages_[static_cast<std::size_t>(stack_->currentIndex())]->display(picture);
  // What commands, and what tells how the machine fares, is of the machine whatever the pages show.
  picture.info = &session_.liveInfo();
  picture.link = session_.link();
  picture.snapshot = live;
  picture.age = liveFreshness_.age();
  picture.stale = live != nullptr && liveFreshness_.stale();
  picture.paused = false;
  // No replay covers the word on the cut that runs.
  command_->setTellsVerdict(stack_->currentIndex() != 0 || replay);
  command_->display(makeCommandView(picture), nowMs);
  strip_->display(makeStrip(picture));
  nowMs_ = nowMs;
  if (stateChanged_ && nowMs - keptMs_ >= kKeepEveryMs) keepState();
}

void MainWindow::showPage(int index) {
  manual_->hide();
  stack_->setCurrentIndex(index);
  pages_[static_cast<std::size_t>(index)]->setFocus();
  header_->setCurrentPage(index);
  stateChanged_ = true;
}

// A dialog of files, the manual, the choice of theme, what the page has laid over itself, or a question that waits:
// what is on top, and one touch closes one. Never the machine.
void MainWindow::closeTop() {
  for (QDialog* dialog : findChildren<QDialog*>()) {
    if (dialog->isVisible()) return dialog->reject();
  }
  if (manual_->isVisible()) {
    manual_->hide();
  } else if (display_->isVisible()) {
    display_->hide();
  } else if (!pages_[static_cast<std::size_t>(stack_->currentIndex())]->closeTop()) {
    command_->withdrawAsked();
  }
}

void MainWindow::showPage(const QString& id) {
  const auto found = std::find_if(pages_.begin(), pages_.end(), [&](const Page* p) { return p->objectName() == id; });
  if (found != pages_.end()) showPage(static_cast<int>(found - pages_.begin()));
}

void MainWindow::openFile(const QString& path) {
  showPage(QStringLiteral("file"));
  pages_[static_cast<std::size_t>(stack_->currentIndex())]->openFile(path);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (session_.files() != nullptr && !urls.isEmpty() && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.isEmpty() || !urls.front().isLocalFile()) return;
  event->acceptProposedAction();
  openFile(urls.front().toLocalFile());
}

QString MainWindow::currentPage() const {
  return pages_[static_cast<std::size_t>(stack_->currentIndex())]->objectName();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  display_->hide();
  manual_->hide();
  if (std::abs(scaleForSize(width(), height()) - scale_) > 1e-9) retheme();
}

// Once a second at most while it runs: nobody closes the window of a machine whose main switch is turned.
void MainWindow::keepState() {
  stateChanged_ = false;
  keptMs_ = nowMs_;
  state_.setGeometry(saveGeometry());
  state_.setPage(currentPage());
  state_.keep(pages_);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  timer_.stop();
  keepState();
  emit closed();
  event->accept();
}

void MainWindow::nextTheme() {
  DisplayChoice next = look_;
  next.theme = look_.theme == ThemeKind::Light  ? ThemeKind::Dark
               : look_.theme == ThemeKind::Dark ? ThemeKind::HighContrast
                                                : ThemeKind::Light;
  setLook(next);
}

void MainWindow::toggleDisplayPanel() {
  if (display_->isVisible()) {
    display_->hide();
    return;
  }
  display_->resize(display_->sizeHint());
  display_->move(width() - display_->width() - 8, header_->height() + 4);
  display_->show(look_);
}

// Over the right of the page: what stands on the left, the verdict first, stays in sight.
void MainWindow::placeManual() {
  QRect place = stack_->geometry();
  place.setLeft(place.left() + place.width() * 2 / 5);
  manual_->setGeometry(place);
}

void MainWindow::openManual(const QString& link) {
  placeManual();
  manual_->openLink(link);
}

void MainWindow::toggleManual() {
  if (manual_->isVisible()) {
    manual_->hide();
    return;
  }
  placeManual();
  manual_->openAt(pageTable()[static_cast<std::size_t>(stack_->currentIndex())].number);
}

void MainWindow::setLook(const DisplayChoice& look) {
  const bool otherLanguage = look.language != look_.language;
  look_ = look;
  state_.setTheme(look.theme);
  state_.setTextSize(look.text);
  state_.setUnits(look.units);
  state_.setLanguage(look.language);
  if (!otherLanguage) {
    retheme();
    return;
  }
  speaker_.speak(look.language);
  const QString page = currentPage();
  keepState();
  pages_.clear();
  build();
  showPage(page);
}

void MainWindow::retheme() {
  scale_ = scaleForSize(width(), height());
  applyTheme(*this, makeTheme(look_.theme, scale_, look_.text));
}

}  // namespace stillcut::ui
