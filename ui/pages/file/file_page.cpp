#include "ui/pages/file/file_page.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QSettings>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/base/format.h"
#include "ui/base/say.h"
#include "ui/models/file/cut_level.h"
#include "ui/pages/choose_files.h"
#include "ui/pages/file/file_answer.h"
#include "ui/pages/file/file_picture.h"
#include "ui/pages/file/file_tools.h"
#include "ui/pages/file/question_fields.h"
#include "ui/pages/tool_button.h"
#include "ui/plots/file/file_spectrum.h"
#include "ui/plots/file/spectra_map.h"
#include "ui/plots/file/state_rows.h"
#include "ui/plots/file/wave_plot.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/text_label.h"

namespace stillcut::ui {
namespace {

constexpr qint64 kTypingMs = 350;  // after the last key the question is asked
constexpr auto kMain = FileController::Main;
constexpr auto kBeside = FileController::Beside;

// Where nothing may be written beside the recording.
QString elsewhere() {
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

Panel* panelOf(QWidget* inside) {
  auto* panel = new Panel;
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(1, 1, 1, 1);
  column->addWidget(inside);
  return panel;
}

}  // namespace

FilePage::FilePage(FileController* controller, ReportWriter report, QWidget* parent)
    : Page(parent), controller_(controller), writer_(std::move(report)) {
  columns_ = new QHBoxLayout(this);
  if (controller == nullptr) {
    columns_->addWidget(new TextLabel({type_size::kValue, false, true, true}, tr("No recording can be opened here.")));
    return;
  }
  chooseFile = [this](const QString& title, const std::function<void(const QString&)>& chosen) {
    chooseFiles(
        this, title, QFileDialog::ExistingFile, folder_, [chosen](const QStringList& paths) { chosen(paths.value(0)); },
        recordingFilters());
  };
  answer_ = new FileAnswerPanel;
  auto* right = new QVBoxLayout;
  tools_ = new FileTools;
  right->addWidget(tools_);
  right->addWidget(makePlots(), 1);
  right->addWidget(makeFoot());
  columns_->addWidget(answer_, 27);
  columns_->addLayout(right, 73);
  connectParts();
  refresh();
}

QWidget* FilePage::makePlots() {
  plots_ = new QWidget;
  grid_ = new QGridLayout(plots_);
  grid_->setContentsMargins(0, 0, 0, 0);
  wave_ = new WavePlot(view_);
  map_ = new SpectraMap(view_);
  states_ = new StateRows(view_);
  spectrum_ = new FileSpectrum(view_);
  wave_->setTimesShown(false);
  map_->setTimesShown(false);
  grid_->addWidget(panelOf(wave_), 0, 0);
  grid_->addWidget(panelOf(map_), 1, 0);
  grid_->addWidget(panelOf(states_), 2, 0);
  grid_->addWidget(panelOf(spectrum_), 0, 1, 3, 1);
  grid_->setColumnStretch(0, 64);
  grid_->setColumnStretch(1, 36);
  grid_->setRowStretch(0, 26);
  grid_->setRowStretch(1, 46);
  grid_->setRowStretch(2, 28);
  return plots_;
}

QWidget* FilePage::makeFoot() {
  auto* foot = new QWidget;
  foot_ = new QHBoxLayout(foot);
  foot_->setContentsMargins(0, 0, 0, 0);
  play_ = toolButton(tr("LISTEN"), tr("Play the sound of the stretch on show"), "file-play");
  beside_ = toolButton(tr("COMPARE"), tr("Compare with a second recording"), "file-beside");
  picture_ = toolButton(tr("PICTURE"), tr("Write a picture of this page beside the recording"), "file-picture");
  report_ = toolButton(tr("REPORT"), tr("Write a report of this recording beside it"), "file-report");
  play_->setKey(Qt::Key_Space);
  play_->setCheckable(true);
  beside_->setCheckable(true);
  status_ = new TextLabel({type_size::kBody, false, false, true});
  status_->setObjectName(QStringLiteral("file-status"));
  for (TouchButton* button : {play_, beside_, picture_, report_}) foot_->addWidget(button);
  foot_->addWidget(status_, 1);
  return foot;
}

void FilePage::connectParts() {
  connect(answer_, &FileAnswerPanel::openAsked, this, [this] { choose(kMain); });
  connect(answer_, &FileAnswerPanel::timingTold, this, [this](const FileTiming& timing) {
    controller_->tellTiming(kMain, timing);
    editedMs_[kMain] = kJustNow;  // what stands in the fields is asked of it as well
    refresh();
  });
  connect(answer_, &FileAnswerPanel::edited, this,
          [this](FileController::Place place) { editedMs_[place] = kJustNow; });
  connect(tools_, &FileTools::changed, this, [this] {
    viewMoved_ = true;
    showParts();
    emit stateChanged();
  });
  connect(&view_, &AnalyseView::changed, this, [this] { viewMoved_ = true; });
  connect(play_, &TouchButton::clicked, this, &FilePage::toggleSound);
  connect(beside_, &TouchButton::clicked, this, &FilePage::toggleBeside);
  connect(report_, &TouchButton::clicked, this, [this] {
    reportWanted_ = true;
    controller_->askSummary();
    tell(tr("The report is being made"));
  });
  connect(picture_, &TouchButton::clicked, this, &FilePage::writePicture);
}

void FilePage::choose(FileController::Place place, bool thenOther) {
  chooseFile(place == kMain ? tr("Open a recording") : tr("Open the recording to compare with"),
             [this, place, thenOther](const QString& path) {
               if (path.isEmpty()) return;
               folder_ = QFileInfo(path).absolutePath();
               emit stateChanged();
               place == kMain ? openFile(path) : compareWith(path);
               if (thenOther) choose(kBeside);
             });
}

void FilePage::compareWith(const QString& path) {
  if (controller_ == nullptr) return;
  controller_->open(kBeside, path);
  answer_->fields(kBeside).setQuestion({});
  editedMs_[kBeside] = kNotEdited;
  refresh();
}

void FilePage::openFile(const QString& path) {
  if (controller_ == nullptr) return;
  if (path.isEmpty()) return choose(kMain);
  controller_->open(kMain, path);
  answer_->fields(kMain).setQuestion({});
  editedMs_[kMain] = kNotEdited;
  tell({});
  refresh();
}

void FilePage::see(const Picture&) {
  if (controller_ != nullptr && controller_->poll()) refresh();
}

void FilePage::refresh() {
  const auto file = controller_->contents(kMain);
  if (file && file != shown_) {
    QStringList names;
    for (const FileChannel& channel : file->channels) names << channel.name;
    tools_->setChannels(names);
    view_.restart();
    view_.setWhole(file->length, file->rate * 0.5);
    judgedShown_ = false;
  }
  const auto other = controller_->contents(kBeside);
  if (file) view_.setLength(other ? std::max(file->length, other->length) : file->length);
  for (const auto place : {kMain, kBeside}) showTold(place);
  if (!file && shown_) view_.restart();
  shown_ = file;
  showJudged();
  showParts();
}

// What the file says itself stands in the fields, unless somebody was quicker.
void FilePage::showTold(FileController::Place place) {
  const auto file = controller_->contents(place);
  if (file == told_[place]) return;
  told_[place] = file;
  const FileQuestion none, asked = controller_->asked(place);
  QuestionFields& fields = answer_->fields(place);
  if (file && fields.question() == none) fields.setQuestion(asked == none ? file->told : asked);
}

// Up to where the detectors hear, once, and a little more: what lies above says nothing, and all of it is one touch
// away.
void FilePage::showJudged() {
  constexpr double kMore = 1.25;
  const auto answer = controller_->answer(kMain);
  if (judgedShown_ || !shown_ || !answer || !(answer->judgedTo.value > 0.0)) return;
  judgedShown_ = true;
  const AnalyseOptions& options = view_.options();
  if (options.low > Hertz() || options.high < view_.top()) return;  // somebody was quicker
  view_.showFrequencies(Hertz(), Hertz(std::min(kMore * answer->judgedTo.value, view_.top().value)));
}

FileMarks FilePage::marks() const {
  FileMarks marks;
  if (const auto answer = controller_->answer(kMain)) {
    marks.spindle = answer->spindle;
    marks.chatter = answer->chatter;
    marks.teeth = answer->teeth;
  }
  return marks;
}

void FilePage::showAnswer() {
  const auto shown = [this](FileController::Place place) {
    return FileAnswerPanel::Shown{controller_->contents(place),
                                  controller_->answer(place),
                                  controller_->path(place),
                                  controller_->reading(place),
                                  controller_->answering(place),
                                  controller_->asked(place),
                                  place == kMain ? controller_->findings() : FileFindings(),
                                  controller_->lacking(place)};
  };
  answer_->display(shown(kMain));
  answer_->displayBeside(shown(kBeside), besideLouderDb());
}

// Of the same quantity alone, and once both are judged.
std::optional<double> FilePage::besideLouderDb() const {
  const auto unit = [this](FileController::Place place) {
    const auto file = controller_->contents(place);
    const auto spectra = controller_->spectra(place);
    const bool any = file && spectra && spectra->request.channel < static_cast<int>(file->channels.size());
    return any ? file->channels[static_cast<std::size_t>(spectra->request.channel)].unit : QString();
  };
  const auto level = [this](FileController::Place place) {
    return cutLevelDb(controller_->spectra(place).get(), controller_->answer(place).get());
  };
  const auto first = level(kMain), second = level(kBeside);
  if (!first || !second || unit(kMain) != unit(kBeside)) return {};
  return *second - *first;
}

void FilePage::showParts() {
  const auto file = controller_->contents(kMain), other = controller_->contents(kBeside);
  const auto answer = controller_->answer(kMain), otherAnswer = controller_->answer(kBeside);
  const FileLook& look = tools_->look();
  const auto spectra = controller_->spectra(kMain), otherSpectra = controller_->spectra(kBeside);
  showAnswer();
  const int besideChannel = other ? std::min(look.channel, static_cast<int>(other->channels.size()) - 1) : 0;
  wave_->display({file, spectra, look.channel}, {other, otherSpectra, besideChannel});
  const bool any = file && look.channel < static_cast<int>(file->channels.size());
  const QString unit = any ? file->channels[static_cast<std::size_t>(look.channel)].unit : QString();
  map_->display(spectra, look, marks(), unit);
  spectrum_->display({spectra, otherSpectra, look, marks(), unit, nameOf(kMain), nameOf(kBeside)});
  std::vector<FileTrack> rows;
  if (file && file->recorded) rows.push_back(*file->recorded);
  const int answering = static_cast<int>(rows.size());
  if (answer) rows.insert(rows.end(), answer->tracks.begin(), answer->tracks.end());
  if (otherAnswer && !otherAnswer->tracks.empty()) {
    rows.push_back(otherAnswer->tracks.front());
    rows.back().detector = tr("compared");
  }
  states_->display(std::move(rows), answering);
  const bool wall = file && file->wallMs > 0;
  for (TimePlot* plot : std::initializer_list<TimePlot*>{wave_, map_, states_}) {
    plot->setElapsed(!wall);
    if (wall) plot->setClock([begin = file->wallMs](Instant t) { return begin + toNs(t) / 1'000'000; });
  }
  for (TouchButton* button : {play_, picture_, report_}) button->setEnabled(file != nullptr);
  beside_->setChecked(!controller_->path(kBeside).isEmpty());
  const TaskState& reading = controller_->reading(kBeside);
  if (!reading.problem.isEmpty() && beside_->isChecked()) {
    controller_->close(kBeside);
    tell(reading.problem, true);
  }
}

// The stretch on show and as much on either side, so that a small move needs nothing new. The same stretch of both.
void FilePage::askSpectra(FileController::Place place) {
  const auto file = controller_->contents(place);
  if (!file) {
    askedOf_[place] = nullptr;
    return;
  }
  const FileLook& look = tools_->look();
  SpectraRequest request;
  request.channel = std::clamp(look.channel, 0, std::max(static_cast<int>(file->channels.size()) - 1, 0));
  request.length = look.length;
  request.window = look.window;
  request.overlap = look.overlap;
  request.to = std::min(sinceEpoch(view_.to()), file->length);
  request.from = std::max(sinceEpoch(view_.from()), Seconds());
  // Where only the other one has anything, the spectrum is that of its end.
  if (request.from >= request.to) request.from = std::max(request.to - view_.options().span, Seconds());
  request.columns = std::max(map_->plotRect().width(), 200);
  if (request == asked_[place] && file.get() == askedOf_[place]) return;
  asked_[place] = request;
  askedOf_[place] = file.get();
  controller_->askSpectra(place, request);
}

void FilePage::display(const Picture& picture) {
  units_ = picture.units;
  if (controller_ == nullptr) return;
  for (const auto place : {kMain, kBeside}) askTyped(place, picture.nowMs);
  if (reportWanted_) writeReport();
  askSpectra(kMain);
  askSpectra(kBeside);
  if (std::exchange(viewMoved_, false)) {
    showParts();
  } else if (busy()) {
    showAnswer();  // how far it is
  }
  const auto heard = controller_->playing();
  wave_->setHeard(heard);
  play_->setChecked(heard.has_value());
  play_->setText(heard ? tr("STOP") : tr("LISTEN"));
  if (const QString problem = controller_->soundProblem(); problem != soundProblem_) {
    soundProblem_ = problem;
    if (!problem.isEmpty()) tell(problem, true);
  }
}

// Where nothing is open yet it asks for both, one after the other.
void FilePage::toggleBeside() {
  if (controller_->path(kBeside).isEmpty()) {
    beside_->setChecked(false);
    const bool none = controller_->path(kMain).isEmpty();
    return choose(none ? kMain : kBeside, none);
  }
  controller_->close(kBeside);
  refresh();
}

bool FilePage::busy() const {
  return controller_->reading(kMain).running || controller_->answering(kMain).running ||
         controller_->answering(kBeside).running;
}

QString FilePage::nameOf(FileController::Place place) const {
  return QFileInfo(controller_->path(place)).fileName();
}

void FilePage::askTyped(FileController::Place place, qint64 nowMs) {
  qint64& edited = editedMs_[place];
  if (edited == kJustNow) edited = nowMs;
  if (edited == kNotEdited || nowMs - edited < kTypingMs) return;
  edited = kNotEdited;
  controller_->ask(place, answer_->fields(place).question());
  refresh();
}

void FilePage::toggleSound() {
  if (controller_->playing()) return controller_->stopSound();
  soundProblem_.clear();
  const auto cursor = view_.cursor(AnalyseView::A);
  const Instant from = cursor && *cursor >= view_.from() && *cursor < view_.to() ? *cursor : view_.from();
  const Status begun = controller_->play(tools_->look().channel, sinceEpoch(from), sinceEpoch(view_.to()));
  tell(begun ? QString() : sayError(begun.error()), !begun);
}

void FilePage::writePicture() {
  const auto file = controller_->contents(kMain);
  if (!file) return;
  const auto answer = controller_->answer(kMain);
  const QString name = nameBeside(file->path, QStringLiteral(".png"), elsewhere());
  const QImage picture = filePicture(pictureTexts(*file, controller_->asked(kMain), answer.get()),
                                     plots_->grab().toImage(), wave_->shownTheme());
  const bool written = picture.save(name);
  tell(written ? tr("Written: %1").arg(name) : tr("%1 cannot be written").arg(name), !written);
}

// Drawn on this thread, once what it is made of is there.
void FilePage::writeReport() {
  if (controller_->summarizing().running) return;
  reportWanted_ = false;
  const auto summary = controller_->summary();
  if (!summary || !writer_) return tell(controller_->summarizing().problem, true);
  const QString name = nameBeside(controller_->path(kMain), QStringLiteral(".pdf"), elsewhere());
  const Status written = writer_(*summary, name, units_);
  tell(written ? tr("Written: %1").arg(name) : sayError(written.error()), !written);
}

void FilePage::tell(const QString& text, bool trouble) {
  status_->setTone(trouble ? Tone::Onset : Tone::Normal);
  status_->setText(text);
}

void FilePage::keep(QSettings& settings) const {
  if (controller_ == nullptr) return;
  const FileLook& look = tools_->look();
  settings.setValue(QStringLiteral("folder"), folder_);
  settings.setValue(QStringLiteral("length"), look.length);
  settings.setValue(QStringLiteral("window"), static_cast<int>(look.window));
  settings.setValue(QStringLiteral("overlap"), look.overlap);
  settings.setValue(QStringLiteral("log"), look.log);
  settings.setValue(QStringLiteral("order"), look.order);
}

void FilePage::restore(const QSettings& settings) {
  if (controller_ == nullptr) return;
  folder_ = settings.value(QStringLiteral("folder")).toString();
  if (!QFileInfo(folder_).isDir()) folder_.clear();
  FileLook look = tools_->look();
  look.length = settings.value(QStringLiteral("length"), look.length).toInt();
  look.window = static_cast<SpectraWindow>(std::clamp(settings.value(QStringLiteral("window"), 0).toInt(), 0, 2));
  look.overlap = settings.value(QStringLiteral("overlap"), look.overlap).toDouble();
  look.log = settings.value(QStringLiteral("log"), look.log).toBool();
  look.order = settings.value(QStringLiteral("order"), look.order).toBool();
  tools_->setLook(look);
  showParts();
}

void FilePage::applyTheme(const Theme& theme) {
  const int margin = theme.px(16), gap = theme.px(10);
  columns_->setContentsMargins(margin, gap, margin, gap);
  columns_->setSpacing(gap);
  if (grid_ == nullptr) return;
  grid_->setSpacing(theme.px(6));
  foot_->setSpacing(std::max(theme.px(10), pixelsFor(kTouchGapMm, this)));
}

}  // namespace stillcut::ui
