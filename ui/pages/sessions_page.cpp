#include "ui/pages/sessions_page.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <algorithm>
#include <array>
#include <utility>

#include "core/model/judged_cut.h"
#include "ui/base/format.h"
#include "ui/base/say.h"
#include "ui/models/live_numbers.h"
#include "ui/models/session_text.h"
#include "ui/pages/event_panel.h"
#include "ui/pages/mark_sheet.h"
#include "ui/pages/session_list.h"
#include "ui/pages/tool_button.h"
#include "ui/plots/session_timeline.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/transport_bar.h"

namespace stillcut::ui {
namespace {

struct Format {
  const char* name;
  const char* suffix;
  bool drawn = false;  // by the report's hand, not from the samples
};
constexpr std::array<Format, 9> kFormats{{{"WAV", ".wav"},
                                          {"FLAC", ".flac"},
                                          {"CSV", ".csv"},
                                          {"MAT", ".mat"},
                                          {"UFF", ".uff"},
                                          {"UNV", ".unv"},
                                          {"HDF5", ".hdf5"},
                                          {"PNG", ".png", true},
                                          {"SVG", ".svg", true}}};

Tone toneOf(const std::string& label) {
  if (label == kLabelTrueAlarm || label == kLabelOperatorChatter) return Tone::Chatter;
  return label == kLabelFalseAlarm ? Tone::Onset : Tone::Advice;
}

}  // namespace

SessionsPage::SessionsPage(SessionController* controller, ReportWriter report, QWidget* parent)
    : Page(parent), controller_(controller), report_(std::move(report)), theme_(makeTheme(ThemeKind::Light, 1.0)) {
  auto* columns = new QHBoxLayout(this);
  auto* right = new QVBoxLayout;
  panel_ = new Panel;
  auto* top = new QVBoxLayout(panel_);
  title_ = new TextLabel({type_size::kValue, true, false, true});
  facts_ = new TextLabel({type_size::kLabel, false, true, true});
  verdict_ = new TextLabel({type_size::kValue, true});
  timeline_ = new SessionTimeline;
  timeline_->setObjectName(QStringLiteral("session-timeline"));
  transport_ = new TransportBar;
  everywhere_ = toolButton(tr("ON ALL PAGES"), tr("Show the replay on all pages"), "replay-everywhere");
  everywhere_->setCheckable(true);
  auto* head = new QHBoxLayout;
  auto* names = new QVBoxLayout;
  names->addWidget(title_);
  names->addWidget(facts_);
  head->addLayout(names, 1);
  head->addWidget(verdict_);
  whole_ = toolButton(tr("WHOLE FILE"), tr("Look at this recording as a whole, or open another file"), "session-whole");
  connect(whole_, &TouchButton::clicked, this,
          [this] { emit fileAsked(controller_ != nullptr ? controller_->openedPath() : QString()); });
  head->addWidget(everywhere_);
  head->addWidget(whole_);
  lines_.push_back(head);
  top->addLayout(head);
  top->addWidget(timeline_, 1);
  top->addWidget(transport_);
  status_ = new TextLabel({type_size::kBody, true, false, true});
  top->addWidget(status_);
  right->addWidget(panel_, 60);
  right->addWidget(makeBelow(), 40);
  list_ = new SessionList(controller_);
  columns->addWidget(list_, 24);
  columns->addLayout(right, 76);
  connectTransport();
  refresh();
}

// Two sheets of one panel: marking, and what comes of the recording.
QWidget* SessionsPage::makeBelow() {
  below_ = new Panel;
  auto* line = new QHBoxLayout(below_);
  auto* choices = new QVBoxLayout;
  auto* sheets = new QStackedWidget;
  sheets->setObjectName(QStringLiteral("sheets"));
  marks_ = new MarkSheet(controller_);
  connectMarks();
  sheets->addWidget(marks_);
  sheets->addWidget(makeResults());
  events_ = new EventPanel(QStringLiteral("session-events"));
  sheets->addWidget(events_);
  connect(events_, &EventPanel::wentTo, this, [this](Instant t) { controller_->goTo(sinceEpoch(t)); });
  std::vector<TouchButton*> buttons{toolButton(tr("MARK"), tr("Markers"), "sheet-mark"),
                                    toolButton(tr("COMPARE"), tr("Compare, score and export"), "sheet-compare"),
                                    toolButton(tr("EVENTS"), tr("What happened in this recording"), "sheet-events")};
  for (std::size_t k = 0; k < buttons.size(); ++k) {
    buttons[k]->setCheckable(true);
    choices->addWidget(buttons[k]);
    connect(buttons[k], &TouchButton::clicked, this, [sheets, buttons, k] {
      sheets->setCurrentIndex(static_cast<int>(k));
      for (std::size_t i = 0; i < buttons.size(); ++i) buttons[i]->setChecked(i == k);
    });
  }
  buttons.front()->setChecked(true);
  choices->addStretch(1);
  lines_.push_back(choices);
  line->addLayout(choices);
  line->addWidget(sheets, 1);
  return below_;
}

QWidget* SessionsPage::makeResults() {
  auto* sheet = new QWidget;
  auto* column = new QVBoxLayout(sheet);
  column->setContentsMargins(0, 0, 0, 0);
  run_ = toolButton(tr("ALL DETECTORS"), tr("Run every detector on this recording"), "session-run");
  score_ = toolButton(tr("SCORE"), tr("Score this recording against its markers"), "session-score");
  scoreAll_ = toolButton(tr("SCORE ALL"), tr("Score the whole folder"), "session-score-all");
  cut_ = toolButton(tr("EXPORT"), tr("Export the selected span, or the whole"), "session-export");
  formatButton_ =
      toolButton(tr("AS %1").arg(QLatin1String(kFormats[0].name)), tr("The next format of EXPORT"), "session-format");
  pdf_ = toolButton(tr("REPORT"), tr("Write a report"), "session-report");
  stop_ = toolButton(tr("STOP"), tr("Stop what is being worked on"), "session-stop");
  tuned_ = toolButton(tr("FROM TUNE"), tr("Take what was changed on the Tune page"), "session-tuned");
  beside_ = toolButton(tr("OVERLAY"), tr("Keep this recording beside the next one that is opened"), "session-beside");
  beside_->setCheckable(true);
  settings_ = new QLineEdit;
  settings_->setObjectName(QStringLiteral("session-settings"));
  settings_->setPlaceholderText(tr("What if") + QStringLiteral(": energy-ratio.chatter=0.3"));
  settings_->setAccessibleName(tr("What if: settings, KEY=VALUE, with spaces between them"));
  auto* first = new QHBoxLayout;
  for (TouchButton* button : {run_, score_, scoreAll_, pdf_, stop_}) first->addWidget(button);
  first->addStretch(1);
  auto* second = new QHBoxLayout;
  for (QBoxLayout* line :
       {static_cast<QBoxLayout*>(column), static_cast<QBoxLayout*>(first), static_cast<QBoxLayout*>(second)})
    lines_.push_back(line);
  second->addWidget(settings_, 1);
  for (TouchButton* button : {tuned_, beside_, cut_, formatButton_}) second->addWidget(button);
  results_ = new TextLabel({type_size::kBody, false, false, true});
  results_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(results_);
  column->addLayout(first);
  column->addLayout(second);
  column->addWidget(scroll, 1);
  connect(run_, &TouchButton::clicked, this,
          [this] { controller_->runDetectors(settings_->text().split(u' ', Qt::SkipEmptyParts)); });
  connect(settings_, &QLineEdit::returnPressed, run_, &TouchButton::click);
  connect(tuned_, &TouchButton::clicked, this, [this] { settings_->setText(controller_->tunedSettings().join(u' ')); });
  connect(score_, &TouchButton::clicked, this, [this] { controller_->score(false); });
  connect(scoreAll_, &TouchButton::clicked, this, [this] { controller_->score(true); });
  connect(cut_, &TouchButton::clicked, this, &SessionsPage::exportChosen);
  connect(formatButton_, &TouchButton::clicked, this, &SessionsPage::nextFormat);
  connect(pdf_, &TouchButton::clicked, this, [this] { writeDrawn(QStringLiteral(".pdf")); });
  connect(beside_, &TouchButton::clicked, this, [this] {
    const bool on = beside_->isChecked();
    timeline_->setBeside(on ? controller_->summary() : nullptr);
    if (on) tell(Done{}, tr("Open another recording: this one stays beside it, as the dashed line"));
  });
  connect(stop_, &TouchButton::clicked, this, [this] { controller_->cancel(); });
  return sheet;
}

void SessionsPage::connectTransport() {
  if (controller_ == nullptr) return;
  connect(transport_, &TransportBar::playAsked, this, [this] { controller_->play(); });
  connect(transport_, &TransportBar::pauseAsked, this, [this] { controller_->pause(); });
  connect(transport_, &TransportBar::toStartAsked, this, [this] { controller_->goTo(Seconds()); });
  connect(transport_, &TransportBar::stepAsked, this, [this](int blocks) { controller_->step(blocks); });
  connect(transport_, &TransportBar::paceAsked, this, [this](double times) { controller_->setPace(times); });
  connect(transport_, &TransportBar::loopAsked, this, [this](bool on) {
    if (!on) {
      controller_->endLoop();
    } else if (timeline_->hasSelection()) {
      controller_->loop(timeline_->selectedFrom(), timeline_->selectedTo());
    } else {
      status_->setText(tr("Drag over the picture or choose a marked span first: the loop repeats it"));
    }
  });
  connect(timeline_, &SessionTimeline::wentTo, this, [this](double t) { controller_->goTo(Seconds(t)); });
  connect(timeline_, &SessionTimeline::selected, this, [this] {
    if (controller_->replay().looping) controller_->loop(timeline_->selectedFrom(), timeline_->selectedTo());
  });
  connect(everywhere_, &TouchButton::clicked, this, [this] {
    const bool on = everywhere_->isChecked();
    tell(controller_->showEverywhere(on),
         on ? tr("Every page shows the replay; the touches below still go to the machine")
            : tr("Every page shows the cut again"));
  });
}

// A span becomes the selection, so that LOOP, EXPORT and the next marker take it.
void SessionsPage::connectMarks() {
  marks_->chosen = [this] {
    const Seconds here = controller_->replay().position;
    return timeline_->hasSelection() ? std::pair(timeline_->selectedFrom(), timeline_->selectedTo())
                                     : std::pair(here, here);
  };
  connect(marks_, &MarkSheet::told, this, &SessionsPage::tell);
  connect(marks_, &MarkSheet::wentTo, this, [this](Seconds begin, Seconds end) {
    controller_->goTo(begin);
    if (end > begin) timeline_->select(begin, end);
  });
}

void SessionsPage::tell(const Status& status, const QString& done) {
  status_->setTone(status ? Tone::Normal : Tone::Onset);
  status_->setText(status ? done : sayError(status.error()));
}

// Beside the recording; where nothing may be written there, among the others.
QString SessionsPage::exportName(const QString& suffix) const {
  const QFileInfo file(controller_->openedPath());
  const QDir dir(QFileInfo(file.path()).isWritable() ? file.path() : controller_->folder());
  QString name = dir.filePath(file.completeBaseName() + suffix);
  for (int k = 2; QFileInfo::exists(name); ++k) {
    name = dir.filePath(QStringLiteral("%1-%2%3").arg(file.completeBaseName()).arg(k).arg(suffix));
  }
  return name;
}

void SessionsPage::nextFormat() {
  format_ = (format_ + 1) % kFormats.size();
  formatButton_->setText(tr("AS %1").arg(QLatin1String(kFormats[format_].name)));
}

// Pictures are of the whole; samples of the selected span where there is one.
void SessionsPage::exportChosen() {
  const auto summary = controller_->summary();
  if (!summary) return;
  const Format& format = kFormats[format_];
  if (format.drawn) return writeDrawn(QLatin1String(format.suffix));
  const bool span = timeline_->hasSelection();
  controller_->exportSpan(span ? timeline_->selectedFrom() : Seconds(),
                          span ? timeline_->selectedTo() : summary->length, exportName(QLatin1String(format.suffix)));
}

void SessionsPage::writeDrawn(const QString& suffix) {
  const auto summary = controller_->summary();
  if (!summary || !report_) return;
  if (!controller_->summaryWhole())
    return tell(Error{message("export"), message("the recording is still being read"), message("a moment later")}, {});
  const QString file = exportName(suffix);
  Status written = report_(*summary, file, units_);
  QString said = breakable(file);
  // Whoever gets the report may have a browser and no reader, or the other way round.
  if (written && suffix == QLatin1String(".pdf")) {
    const QString page = exportName(QStringLiteral(".html"));
    written = report_(*summary, page, units_);
    said += QStringLiteral(", ") + breakable(page);
  }
  tell(written, tr("Written: %1").arg(said));
}

void SessionsPage::see(const Picture&) {
  if (controller_ == nullptr || !controller_->poll()) return;
  refresh();
  if (std::exchange(keptFolder_, controller_->folder()) != controller_->folder()) emit stateChanged();
}

void SessionsPage::refresh() {
  const bool any = controller_ != nullptr;
  if (any) {
    marks_->refresh();
    timeline_->setSummary(controller_->summary());
    // What is kept is read to its end first.
    if (beside_->isChecked() && !timeline_->besideShown()) timeline_->setBeside(controller_->summary());
    timeline_->setTracks(controller_->tracks());
    std::vector<SessionTimeline::Mark> marks;
    for (const Marker& m : controller_->markers()) {
      const Seconds begin = controller_->markerTime(m);
      const QString text = m.note.empty() ? markerText(m.label) : QString::fromStdString(m.note);
      marks.push_back({begin, begin + secondsBetween(m.begin, m.end), text, toneOf(m.label)});
    }
    timeline_->setMarks(std::move(marks));
  }
  list_->refresh();
  const auto summary = any ? controller_->summary() : nullptr;
  title_->setText(summary ? breakable(QFileInfo(QString::fromStdString(summary->file)).fileName())
                          : tr("No recording is open"));
  const bool whole = summary != nullptr && controller_->summaryWhole();
  if (whole && !summary->session) {
    // Nobody has alarmed while it was made: what is said is the answer of now.
    QStringList facts{sayCore(summary->kind), timeText(summary->length)};
    if (summary->answer) facts << sayCore(summary->answer->sentences.front());
    facts_->setText(facts.join(QStringLiteral(" \u00b7 ")));
  } else if (whole) {
    facts_->setText(tr("%1 · %2 · alarms: %3 · in chatter %4")
                        .arg(sayCore(summary->kind), timeText(summary->length))
                        .arg(summary->alarms)
                        .arg(duration(summary->chatterTime)));
  } else {
    facts_->setText(summary != nullptr
                        ? QStringLiteral("%1 · %2").arg(sayCore(summary->kind), timeText(summary->length))
                        : QString());
  }
  showEvents(summary.get());
  const bool open = summary != nullptr;
  for (TouchButton* button : {run_, score_, cut_, everywhere_, beside_}) button->setEnabled(open);
  pdf_->setEnabled(whole);
  scoreAll_->setEnabled(any && !controller_->entries().empty());
  if (any) showResults();
}

void SessionsPage::showEvents(const SessionSummary* summary) {
  if (summary == nullptr) return events_->display({}, {}, units_);
  // Where the time of day is not told, the time since the beginning.
  const qint64 midnight = QDateTime(QDate::currentDate(), QTime()).toMSecsSinceEpoch();
  const qint64 begin = summary->started_ns > 0 ? summary->started_ns / 1'000'000 : midnight;
  events_->display(
      eventsOf(*summary), [begin](Instant t) { return begin + toNs(t) / 1'000'000; }, units_);
}

void SessionsPage::showResults() {
  QStringList lines;
  for (const DetectorTrack& track : controller_->tracks()) lines.push_back(trackText(track));
  for (const ScoreLine& score : controller_->scores()) lines.push_back(scoreText(score));
  for (const QString& problem : controller_->notScored()) lines.push_back(tr("Not scored: %1").arg(problem));
  results_->setText(lines.join(u'\n'));
}

void SessionsPage::display(const Picture& picture) {
  units_ = picture.units;
  if (controller_ == nullptr) return;
  const ReplayState replay = controller_->replay();
  transport_->display(replay);
  timeline_->setReplay(replay);
  everywhere_->setChecked(controller_->shownEverywhere());
  tuned_->setEnabled(!controller_->tunedSettings().isEmpty());
  const TaskState task = controller_->task();
  stop_->setEnabled(task.running);
  if (task.running || taskRan_) {
    status_->setTone(!task.running && !task.problem.isEmpty() ? Tone::Onset : Tone::Normal);
    status_->setText(taskText(task));
  }
  taskRan_ = task.running;
  const Snapshot* shown = controller_->replayed();
  const bool judged = shown != nullptr && shown->detectorCount > 0;
  const Verdict* verdict = judged ? &shown->verdicts[static_cast<std::size_t>(shown->inCharge)] : nullptr;
  verdict_->setText(verdict == nullptr ? QString() : hasState(*verdict) ? stateText(verdict->state) : tr("no verdict"));
  verdict_->setTone(verdict == nullptr || !verdict->alarming() ? Tone::Normal
                    : verdict->state == CutState::Chatter      ? Tone::Chatter
                                                               : Tone::Onset);
}

void SessionsPage::keep(QSettings& settings) const {
  if (controller_ != nullptr) settings.setValue(QStringLiteral("folder"), controller_->folder());
}

void SessionsPage::restore(const QSettings& settings) {
  const QString folder = settings.value(QStringLiteral("folder")).toString();
  if (controller_ != nullptr && QFileInfo(folder).isDir()) controller_->setFolder(folder);
}

void SessionsPage::applyTheme(const Theme& theme) {
  theme_ = theme;
  const int margin = theme.px(16), gap = theme.px(10);
  layout()->setContentsMargins(margin, gap, margin, gap);
  layout()->setSpacing(gap);
  const int apart = std::max(theme.px(12), pixelsFor(kTouchGapMm, this));
  for (QBoxLayout* line : lines_) line->setSpacing(apart);
  for (Panel* panel : {panel_, below_}) {
    panel->layout()->setContentsMargins(theme.px(12), theme.px(8), theme.px(12), theme.px(8));
    panel->layout()->setSpacing(theme.px(6));
  }
  below_->layout()->setSpacing(apart);
  settings_->setFont(theme.font(type_size::kBody));
  settings_->setFixedHeight(touchHeight(theme, this, 48));
}

}  // namespace stillcut::ui
