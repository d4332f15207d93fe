// stillcut: the desktop program.
//   stillcut [--scenario FILE | --profile FILE] [--record FILE.h5|FOLDER] [--theme light|dark|contrast] [--size WxH]
//            [--language en|de|zh] [--page ID] [--log-level info|warning|error|off]
//   stillcut RECORDING                                                   beside the run, on the page for a file
//   stillcut --scenario FILE --screenshot FILE.png [--after SECONDS]     a picture without waiting or a display
//   stillcut --report RECORDING OUT.pdf|.html|.png|.svg [--size WxH]     a report or the plots, without a display
//   stillcut --sheet OUT.pdf [--language en|de|zh]                       the machinist's sheet, one page to print
// Without a scenario or a profile the machine of the last run comes up again, with authority Off. Where nobody
// has a profile it is the demonstration, the first time by the guide's question; a profile that was never started, or
// that cannot be, is offered on the page Set up, and nothing runs.

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTimer>
#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

#include "app/compose/build_info.h"
#include "app/compose/ending/interruption.h"
#include "app/compose/ending/orderly_end.h"
#include "app/compose/resource_folder.h"
#include "app/desktop/report_mode.h"
#include "app/log/program_log.h"
#include "app/session/session.h"
#include "generated/version.h"
#include "ui/base/say.h"
#include "ui/shell/main_window.h"
#include "ui/shell/sheet_pdf.h"
#include "ui/shell/window_state.h"

namespace stillcut::app {
namespace {

constexpr int kInputError = 2;
constexpr int kInterruptionTickMs = 50;
constexpr const char* kDemonstration = "scenarios/demonstration.toml";
constexpr double kPictureAfter = 12.0;  // [s]: the demo has met chatter and answered it by then

struct Options {
  QString scenario, profile, record;
  QString screenshot, sheet;
  bool report = false;
  bool version = false;
  bool nothingNamed = false;  // neither a scenario nor a profile: the demonstration
  QStringList files;          // a recording to look at, or those of a report
  double after_s = kPictureAfter;
  QSize size{1280, 800};
  bool sizeGiven = false;
  std::optional<ui::ThemeKind> theme;
  std::optional<ui::Language> language;
  QString page;
  LogLevel logLevel = LogLevel::Info;
};

int fail(const std::string& line) {
  std::fprintf(stderr, "stillcut: %s\n", line.c_str());
  return kInputError;
}

std::optional<QSize> sizeFrom(const QString& text) {
  const QStringList parts = text.split(u'x');
  const QSize size = parts.size() == 2 ? QSize(parts[0].toInt(), parts[1].toInt()) : QSize();
  return size.width() >= 640 && size.height() >= 480 ? std::optional(size) : std::nullopt;
}

QString found(const QString& path) {
  return path.isEmpty() ? path : QString::fromStdString(foundFile(path.toStdString()));
}

// Longer than a screen: one row an option, and what excludes what
Result<Options> parse(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral("Detects chatter in milling, and says what to do about it."));
  const QCommandLineOption scenario(QStringLiteral("scenario"), QStringLiteral("Simulated cut to run."),
                                    QStringLiteral("FILE"));
  const QCommandLineOption profile(QStringLiteral("profile"), QStringLiteral("Machine to monitor."),
                                   QStringLiteral("FILE"));
  const QCommandLineOption record(QStringLiteral("record"),
                                  QStringLiteral("Record to FILE.h5, or into a FOLDER as the parameters record.* say."),
                                  QStringLiteral("FILE.h5|FOLDER"));
  const QCommandLineOption screenshot(QStringLiteral("screenshot"),
                                      QStringLiteral("Write a picture of a page and end."), QStringLiteral("FILE.png"));
  const QCommandLineOption page(QStringLiteral("page"),
                                QStringLiteral("The page to begin with (operate, analyse, lobes ...)."),
                                QStringLiteral("ID"));
  const QCommandLineOption language(QStringLiteral("language"), QStringLiteral("en, de or zh."),
                                    QStringLiteral("CODE"));
  const QCommandLineOption after(QStringLiteral("after"), QStringLiteral("Seconds of the cut before the picture."),
                                 QStringLiteral("SECONDS"));
  const QCommandLineOption size(QStringLiteral("size"), QStringLiteral("Window size."), QStringLiteral("WxH"));
  const QCommandLineOption theme(QStringLiteral("theme"), QStringLiteral("light, dark or contrast."),
                                 QStringLiteral("NAME"));
  const QCommandLineOption report(
      QStringLiteral("report"),
      QStringLiteral("Write a report (.pdf, .html) or the plots (.png, .svg) of a recording."));
  const QCommandLineOption sheet(QStringLiteral("sheet"),
                                 QStringLiteral("Write the machinist's sheet, one page to print, and end."),
                                 QStringLiteral("FILE.pdf"));
  const QCommandLineOption logLevel(QStringLiteral("log-level"),
                                    QStringLiteral("What the log keeps: info, warning, error or off."),
                                    QStringLiteral("LEVEL"));
  parser.addOptions(
      {scenario, profile, record, screenshot, report, sheet, after, size, theme, page, language, logLevel});
  parser.addPositionalArgument(QStringLiteral("files"),
                               QStringLiteral("A recording to look at; with --report, and the file to write."),
                               QStringLiteral("[RECORDING [OUT]]"));
  const QCommandLineOption version({QStringLiteral("v"), QStringLiteral("version")},
                                   QStringLiteral("Show version, commit and libraries."));
  parser.addOption(version);
  parser.addHelpOption();
  parser.process(arguments);

  Options options;
  options.scenario = found(parser.value(scenario));
  options.profile = found(parser.value(profile));
  options.record = parser.value(record);
  options.screenshot = parser.value(screenshot);
  options.report = parser.isSet(report);
  options.sheet = parser.value(sheet);
  options.version = parser.isSet(version);
  options.files = parser.positionalArguments();
  if (!options.report && options.files.size() > 1) {
    return Error{message("command line"), message("'%1' is not understood", options.files[1].toStdString()),
                 message("one recording can be looked at")};
  }
  if (!options.report && !options.files.isEmpty()) options.after_s = 0.0;  // the file is what is looked at
  if (parser.isSet(after)) {
    bool number = false;
    options.after_s = parser.value(after).toDouble(&number);
    if (!number || !std::isfinite(options.after_s) || options.after_s < 0.0) {
      return Error{"--after", message("'%1' is no time", parser.value(after).toStdString()),
                   message("seconds from 0 up")};
    }
  }
  if (parser.isSet(size)) {
    const auto wanted = sizeFrom(parser.value(size));
    if (!wanted)
      return Error{"--size", message("'%1' is no size", parser.value(size).toStdString()), message("as 1280x800")};
    options.size = *wanted;
    options.sizeGiven = true;
  }
  if (parser.isSet(theme)) {
    const QStringList names{QStringLiteral("light"), QStringLiteral("dark"), QStringLiteral("contrast")};
    const qsizetype index = names.indexOf(parser.value(theme));
    if (index < 0)
      return Error{"--theme", message("'%1' is no theme", parser.value(theme).toStdString()),
                   message("light, dark or contrast")};
    options.theme = static_cast<ui::ThemeKind>(index);
  }
  options.page = parser.value(page);
  if (parser.isSet(logLevel)) {
    const auto level = logLevelFrom(parser.value(logLevel).toStdString());
    if (!level) {
      return Error{"--log-level", message("'%1' is no level", parser.value(logLevel).toStdString()),
                   message("info, warning, error or off")};
    }
    options.logLevel = *level;
  }
  if (parser.isSet(language)) {
    options.language = ui::languageFrom(parser.value(language));
    if (!options.language) {
      return Error{"--language", message("'%1' is no language", parser.value(language).toStdString()),
                   message("en, de or zh")};
    }
  }
  if (!options.scenario.isEmpty() && !options.profile.isEmpty()) {
    return Error{message("command line"), message("--scenario and --profile exclude each other")};
  }
  if (!options.screenshot.isEmpty() && !options.profile.isEmpty()) {
    return Error{message("command line"), message("--profile and --screenshot exclude each other"),
                 message("pictures are made of scenarios")};
  }
  options.nothingNamed = options.scenario.isEmpty() && options.profile.isEmpty();
  if (options.nothingNamed) {
    options.scenario = QString::fromStdString((resourceFolder() / kDemonstration).string());
  }
  return options;
}

QString wholePath(const QString& file) {
  return QFileInfo(file).absoluteFilePath();
}

// Shows a recording, and waits until all of it is there.
void lookAt(Session& session, ui::MainWindow& window, const QString& file, qint64& shown_ms) {
  constexpr auto kMain = ui::FileController::Main;
  window.openFile(wholePath(file));
  const auto busy = [&files = *session.files()] {
    const bool read = files.contents(kMain) != nullptr;
    return files.reading(kMain).running || files.answering(kMain).running || files.comparing() ||
           (read && files.spectra(kMain) == nullptr);
  };
  do {
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    shown_ms += ui::kDisplayTickMs;
    window.tick(shown_ms);
  } while (busy());
}

// Runs the session without waiting, ticking the window as the display would, and saves what it shows then.
int takePicture(Session& session, ui::MainWindow& window, const Options& options) {
  window.show();
  qint64 shown_ms = -1;
  double t = 0.0;
  while (t < options.after_s && session.advance()) {
    const Snapshot* snapshot = session.pull();
    if (snapshot == nullptr) continue;
    t = sinceEpoch(snapshot->time).value;
    const auto now_ms = static_cast<qint64>(t * 1e3);
    if (now_ms - shown_ms < ui::kDisplayTickMs) continue;
    shown_ms = now_ms;
    window.tick(now_ms);
  }
  if (!options.files.isEmpty()) lookAt(session, window, options.files.front(), shown_ms);
  // What a page computes in the background is waited for.
  while (session.lobes() != nullptr && session.lobes()->progress().state == ui::LobeProgress::State::Running) {
    QApplication::processEvents(QEventLoop::AllEvents, 20);
  }
  window.tick(shown_ms + ui::kDisplayTickMs);
  QApplication::processEvents();
  if (window.grab().save(options.screenshot)) return 0;
  return fail(Error{options.screenshot.toStdString(), message("cannot be written")}.line());
}

// Where recordings are kept and looked for.
QString recordingsOf(const Options& options) {
  // A file of one's own choice may lie anywhere: the folder around it is no folder of recordings.
  const QFileInfo given(options.record);
  if (!options.record.isEmpty() && given.isDir()) return given.absoluteFilePath();
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/recordings");
}

bool needsNoDisplay(int argc, char** argv) {
  static constexpr std::array<std::string_view, 7> kQuiet{"--report", "--sheet", "--version", "-v",
                                                          "--help",   "-h",      "--help-all"};
  return std::any_of(argv + 1, argv + argc, [](const char* word) { return std::ranges::count(kQuiet, word) > 0; });
}

// Where the log cannot be written, the program says so and goes on without.
ProgramLog openLog(const Options& options) {
  auto log = ProgramLog::open(defaultLogFile(), options.logLevel);
  if (!log) fail(log.error().line());
  ProgramLog opened = log ? std::move(log).value() : ProgramLog();
  opened.write(LogLevel::Info, "stillcut " STILLCUT_VERSION " starts");
  return opened;
}

struct Opened {
  Result<std::unique_ptr<Session>> session;
  bool lastProfile = false;      // the machine of the last run
  std::optional<Error> problem;  // why it is not
};

// What was named, or the machine of the last run. Where that one cannot be opened, its error, and the demonstration
// stands by without running.
Opened open(const Options& options, const QString& lastProfile, bool live) {
  const Recorded recorded = options.record.isEmpty() ? Recorded::AsProfileSays : Recorded::Otherwise;
  std::optional<Error> problem;
  if (!lastProfile.isEmpty()) {
    auto again = openProfileSession(lastProfile.toStdString(), recorded);
    if (again) return {std::move(again), true, {}};
    problem = again.error();
  }
  if (!options.profile.isEmpty()) return {openProfileSession(options.profile.toStdString(), recorded), false, {}};
  const std::string scenario = options.scenario.toStdString();
  std::error_code unlike;
  const bool chosen = std::filesystem::equivalent(scenario, resourceFolder() / kDemonstration, unlike);
  const bool demonstration = live && (options.nothingNamed || chosen);
  return {demonstration ? openDemonstrationSession(scenario, live) : openScenarioSession(scenario, live), false,
          problem};
}

// Longer than a screen: the order in which the program comes up and goes down
int run(int argc, char** argv) {
  if (needsNoDisplay(argc, argv)) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication app(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("Stillcut"));
  QApplication::setApplicationName(QStringLiteral("Stillcut"));
  QApplication::setApplicationVersion(QStringLiteral(STILLCUT_VERSION));
  const auto options = parse(QApplication::arguments());
  if (!options) return fail(options.error().line());
  if (options->version) {
    std::puts(versionText("stillcut").c_str());
    return 0;
  }
  if (options->report) {
    // In the units that the screen was last set to.
    const ui::WindowState kept(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation));
    const Status made = makeReport(options->files, options->sizeGiven ? options->size : QSize(1400, 900), kept.units());
    return made ? 0 : fail(made.error().line());
  }
  if (!options->sheet.isEmpty()) {
    const Status made =
        ui::writeSheet(QStringLiteral("machinist"), options->language.value_or(ui::desktopLanguage()), options->sheet);
    return made ? 0 : fail(made.error().line());
  }
  const bool live = options->screenshot.isEmpty();
  if (live) mindInterruption();
  const ProgramLog log = live ? openLog(*options) : ProgramLog();
  const QString state = QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation);
  const LastRun last(live ? state : QString());
  Opened opened = open(*options, live && options->nothingNamed ? last.before().profile : QString(), live);
  auto& session = opened.session;
  const auto refuse = [&log](const Error& error) {
    log.write(LogLevel::Error, "not started: " + error.line());
    return fail(error.line());
  };
  if (!session) return refuse(session.error());
  (*session)->logTo(log);
  if (!options->record.isEmpty()) {
    const Status recording = (*session)->recordAsAsked(options->record.toStdString());
    if (!recording) fail(recording.error().line() + "; monitoring goes on");
  }

  // Pictures are made of what the command line says alone.
  if (live) (*session)->keepStateIn(state);
  (*session)->demonstrateWith((resourceFolder() / kDemonstration).string());
  (*session)->keepRecordingsIn(recordingsOf(*options));
  ui::MainWindow window(**session, options->theme, options->language);
  if (live) window.restorePlace();
  window.showPage(options->page);
  if (!live || options->sizeGiven) {
    window.setWindowState(Qt::WindowNoState);
    window.resize(options->size);
  }
  if (!live) return takePicture(**session, window, *options);
  OrderlyEnd end(
      [&session] {
        if (const Status kept = (*session)->stop(); !kept) fail(kept.error().line());
      },
      interrupted);
  QObject::connect(&window, &ui::MainWindow::closed, [&end] { end.endNow(); });
  (*session)->keepFlightsIn(defaultFlightsFolder());
  // In the window's language.
  const QString notice = opened.problem ? ui::sayError(*opened.problem) : last.sentence();
  (*session)->tell(notice);
  const bool looking = !options->files.isEmpty();
  if (looking) window.openFile(wholePath(options->files.front()));
  if (!options->nothingNamed || opened.lastProfile) {
    (*session)->start();
    // A machine that runs is what is seen first, and so is how its last run ended; pages of work stay where they were.
    const bool setUpBefore = window.currentPage() == QStringLiteral("setup");
    if (!looking && options->page.isEmpty() && (setUpBefore || !notice.isEmpty()))
      window.showPage(QStringLiteral("operate"));
  } else if (!looking && !window.offerGuide()) {
    // Whoever has a machine is not shown another one that nobody chose.
    const bool noMachine = !opened.problem && (*session)->setup()->profiles().isEmpty();
    noMachine ? (*session)->start() : window.showPage(QStringLiteral("setup"));
  }
  window.start();
  window.show();
  QTimer interruption;
  QObject::connect(&interruption, &QTimer::timeout, [&window] {
    if (!interrupted()) return;
    window.close();
    QApplication::exit();  // whatever dialogue is open
  });
  interruption.start(kInterruptionTickMs);
  return QApplication::exec();
}

}  // namespace
}  // namespace stillcut::app

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow any more is an error of that file, not the program's end
  try {
    return stillcut::app::run(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "stillcut: %s\n", e.what());
    return EXIT_FAILURE;
  }
}
