#include "ui/pages/lobes_page.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QSettings>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTableView>
#include <algorithm>
#include <utility>

#include "core/base/conversions.h"
#include "ui/base/format.h"
#include "ui/base/say.h"
#include "ui/models/learned_view.h"
#include "ui/pages/lobes/cut_form.h"
#include "ui/plots/lobe_chart.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/tool_button.h"

namespace stillcut::ui {
namespace {

double unitLength(UnitSystem units) {
  return units == UnitSystem::Inch ? kInch : 1e-3;
}

}  // namespace

LobesPage::LobesPage(FindService find, LobeEntryController* entry, QWidget* parent)
    : Page(parent),
      find_(std::move(find)),
      entry_(entry),
      chart_(new LobeChart),
      learned_(new QLabel),
      places_(new QStackedWidget),
      methods_{new TouchButton(tr("ZEROTH ORDER")), new TouchButton(tr("SEMI-DISCRETE")), new TouchButton(tr("EXACT"))},
      compute_(new TouchButton(tr("COMPUTE"), TouchButton::Look::Advice)),
      progress_(new QProgressBar),
      state_(new QLabel),
      speed_(new QDoubleSpinBox),
      depth_(new QDoubleSpinBox),
      verdict_(new TextLabel({type_size::kValue, true, false, true})),
      detail_(new QLabel),
      note_(new QLabel),
      pockets_(new QTableView),
      table_(new PocketTable(this)),
      side_(new Panel),
      grid_(new QGridLayout(this)) {
  progress_->setTextVisible(false);  // on the coloured part no letter could be read
  layOut();
  connectAll();
  chooseMethod(method_);
}

void LobesPage::connectAll() {
  if (form_ != nullptr) {
    connect(runs_, &TouchButton::clicked, this, [this] { showOwn(false, false); });
    // Its second touch goes to and fro between the fields and the diagram.
    connect(entered_, &TouchButton::clicked, this, [this] {
      const bool fields = places_->currentWidget() == form_;
      showOwn(true, !own_ ? entry_->service() == nullptr : !fields || entry_->service() == nullptr);
    });
    connect(form_, &CutForm::entered, this, [this] { showOwn(true, false); });
    connect(form_, &CutForm::stateChanged, this, &Page::stateChanged);
  }
  for (std::size_t k = 0; k < methods_.size(); ++k) {
    connect(methods_[k], &TouchButton::clicked, this, [this, k] {
      chooseMethod(static_cast<LobeMethodChoice>(k));
      compute();
      emit stateChanged();
    });
  }
  connect(compute_, &TouchButton::clicked, this, [this] {
    if (service_ != nullptr && service_->progress().state == LobeProgress::State::Running) {
      service_->cancel();
    } else {
      compute();
    }
    showProgress();
  });
  connect(speed_, &QDoubleSpinBox::valueChanged, this, &LobesPage::fieldsChanged);
  connect(depth_, &QDoubleSpinBox::valueChanged, this, &LobesPage::fieldsChanged);
  connect(chart_, &LobeChart::handleMoved, this, [this] {
    const QSignalBlocker quietSpeed(speed_), quietDepth(depth_);
    speed_->setValue(chart_->handle().speed.value);
    depth_->setValue(chart_->handle().depth.value / unitLength(units_));
    whatIfAsked();
  });
  // By touch, or with the arrows and Enter.
  const auto takePocket = [this](const QModelIndex& index) {
    speed_->setValue(table_->pocket(index.row()).best.value);
  };
  connect(pockets_, &QTableView::clicked, this, takePocket);
  connect(pockets_, &QTableView::activated, this, takePocket);
}

// The first look computes by itself: a page that shows nothing until a button is found is no page.
void LobesPage::meet(LobeService* service, bool replay) {
  met_ = true;
  service_ = service;
  diagram_.reset();
  closeUp_.reset();
  learnedLobes_.reset();
  chart_->setLearned(nullptr);
  learned_->hide();
  const bool known = service_ != nullptr;
  side_->setEnabled(known);
  table_->setPockets({}, units_);
  note_->hide();
  if (places_->currentWidget() == chart_) chart_->setVisible(known);  // axes of nothing tell nothing
  showSources();
  // Nothing that was said of the tool before stands beside the numbers of this one.
  verdict_->clear();
  detail_->clear();
  chart_->setWork({}, {});
  chart_->setAdvice({});
  if (!known) return showAbsence(replay);
  const LobeFrame& frame = service_->frame();
  chart_->setDiagram(nullptr, frame);
  const QSignalBlocker quietSpeed(speed_), quietDepth(depth_);
  speed_->setDecimals(0);
  speed_->setRange(frame.lowest.value, frame.highest.value);
  speed_->setValue(frame.programmed.value > 0.0 ? frame.programmed.value : frame.lowest.value);
  const bool inch = units_ == UnitSystem::Inch;
  depth_->setDecimals(inch ? 4 : 2);
  depth_->setSingleStep(inch ? 0.002 : 0.05);
  depth_->setSuffix(inch ? QStringLiteral("\u00a0in") : QStringLiteral("\u00a0mm"));
  depth_->setRange(0.0, frame.maxAxialDepth.value / unitLength(units_));
  depth_->setValue(frame.depth.value / unitLength(units_));
  if (!frame.name.isEmpty() && asked_.tool == frame.name) {
    speed_->setValue(asked_.speed.value);
    depth_->setValue(asked_.depth.value / unitLength(units_));
  }
  chart_->setHandle({Rpm(speed_->value()), Metres(depth_->value() * unitLength(units_))});
  if (!service_->diagram() && service_->progress().state == LobeProgress::State::Idle) compute();
  service_->learn();
  askCloser();
}

void LobesPage::showAbsence(bool replay) {
  for (QDoubleSpinBox* box : {speed_, depth_}) box->clear();
  progress_->hide();
  chart_->setDiagram(nullptr, {});
  QString why;
  if (own_) {
    why = tr("Enter tool, modes, material and engagement, or open a file: no machine and no run is needed.");
  } else if (replay) {
    why =
        tr("The recording does not say which modes its tool has: there is no diagram of this cut. The machine's own "
           "comes back with its cut.");
  } else {
    why =
        tr("The modes of this tool are not known. A tap test gives the file of its modes (F1 tells how): name it "
           "under Set up, TOOLS; the diagram needs nothing else.");
    if (form_ != nullptr) why += u' ' + tr("Or touch YOUR OWN CUT and enter them here.");
  }
  state_->setText(why);
}

void LobesPage::showOwn(bool own, bool editing) {
  own_ = own;
  const bool fields = own && editing;
  // What is not on show asks for no room.
  const auto policy = fields ? QSizePolicy::Preferred : QSizePolicy::Ignored;
  form_->setSizePolicy(policy, policy);
  places_->setCurrentWidget(fields ? static_cast<QWidget*>(form_) : chart_);
  met_ = false;        // with the next picture
  service_ = nullptr;  // of a cut that may be gone
  emit stateChanged();
}

void LobesPage::showSources() {
  if (form_ == nullptr) return;
  runs_->setChecked(!own_);
  entered_->setChecked(own_);
  entered_->setText(!own_                               ? tr("YOUR OWN CUT")
                    : places_->currentWidget() == form_ ? tr("BACK TO THE LOBES")
                                                        : tr("CHANGE YOUR CUT"));
  entered_->setEnabled(!own_ || entry_->service() != nullptr);
}

// The exact method alone knows edges and depths closer than the diagram is drawn.
void LobesPage::askCloser() {
  if (service_ != nullptr && method_ == LobeMethodChoice::Exact) service_->look(chart_->handle());
}

void LobesPage::compute() {
  if (service_ == nullptr) return;
  LobeQuestion question;
  question.method = method_;
  question.from = service_->frame().lowest;
  question.to = service_->frame().highest;
  question.maxAxialDepth = service_->frame().maxAxialDepth;
  service_->ask(question);
}

void LobesPage::chooseMethod(LobeMethodChoice method) {
  method_ = method;
  for (std::size_t k = 0; k < methods_.size(); ++k) methods_[k]->setChecked(static_cast<LobeMethodChoice>(k) == method);
}

void LobesPage::display(const Picture& picture) {
  const bool otherUnits = picture.units != units_;
  units_ = picture.units;
  chart_->setUnits(units_);
  if (form_ != nullptr) form_->setUnits(units_);
  if (!met_ || otherUnits) meet(own_ ? entry_->service() : find_(), picture.replay);
  if (service_ == nullptr) return;
  absent_.clear();
  if (own_) {
    showProgress();
    return showAnswers();
  }
  if (picture.paused) absent_ = tr("The replay is paused");
  if (picture.snapshot != nullptr && picture.stale) absent_ = tr("Nothing new arrives: the working point is not shown");
  if (picture.over()) absent_ = picture.link.ended;
  if (!service_->frame().depthKnown) {
    absent_ = tr("The depth of cut is not known: tell it under Set up, MACHINE, and the working point is shown");
  }
  showProgress();
  showAnswers();
  showWork(picture);
}

void LobesPage::showAnswers() {
  const bool closer = service_->closeUp() != closeUp_;
  closeUp_ = service_->closeUp();
  if (service_->diagram() != diagram_) {
    diagram_ = service_->diagram();
    showDiagram();
  } else if (closer) {
    showWhatIf();
  }
  if (service_->learned() != learnedLobes_) {
    learnedLobes_ = service_->learned();
    chart_->setLearned(learnedLobes_);
    showLearned();
  }
}

// Of the whole, and of the place of the ring; on a judged cut, what that was.
void LobesPage::showLearned() {
  learned_->setVisible(learnedLobes_ != nullptr && places_->currentWidget() == chart_);
  if (learnedLobes_ == nullptr) return;
  QString text = learnedLine(*learnedLobes_, units_);
  const LearnedCut* cut = chart_->cutAt(chart_->place(chart_->handle()));
  const QString here = cut != nullptr ? evidenceText(*cut, units_) : learnedAt(*learnedLobes_, chart_->handle());
  if (!here.isEmpty()) text += u'\n' + here;
  learned_->setText(text);
}

// Cuts judged since it was looked at last count too.
void LobesPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  if (service_ != nullptr) service_->learn();
}

// At a depth that somebody has told; at a guess it would stand in the wrong place.
void LobesPage::showWork(const Picture& picture) {
  std::optional<SpeedDepth> now;
  std::optional<Rpm> advice;
  const Snapshot* s = picture.snapshot;
  const bool known = service_->frame().depthKnown;
  if (known && s != nullptr && s->machine.valid && !picture.stale && !picture.over()) {
    now = SpeedDepth{s->machine.actualSpeed, service_->axialDepthAt(s->time)};
    if (s->advice.kind == SpeedAdvice::Kind::Speed) advice = s->advice.speed;
    if (s->commanding && !s->adviceOpen) advice = s->machine.programmedSpeed * s->command.speed.value;
  }
  chart_->setWork(now, known ? pointsMet(*picture.history, *service_) : std::vector<MetPoint>{});
  chart_->setAdvice(advice);
}

void LobesPage::showProgress() {
  const LobeProgress progress = service_ ? service_->progress() : LobeProgress{};
  const bool running = progress.state == LobeProgress::State::Running;
  compute_->setText(running ? tr("CANCEL") : tr("COMPUTE"));
  progress_->setValue(static_cast<int>(progress.share * 100.0));
  progress_->setVisible(running);
  QString text;
  switch (progress.state) {
    case LobeProgress::State::Idle:
      break;
    case LobeProgress::State::Running:
      text = diagram_ ? tr("Computing; the diagram becomes finer until it is done") : tr("Computing");
      break;
    case LobeProgress::State::Done:
      text = service_->frame().name;
      if (service_->frame().depthKnown) {
        text += tr(", depth of cut up to %1").arg(depthText(service_->frame().depth, units_));
      }
      if (diagram_ && !diagram_->warnings.isEmpty()) {
        QString warning = diagram_->warnings.front();
        warning[0] = warning[0].toUpper();
        text += QStringLiteral(". ") + warning;
      }
      break;
    case LobeProgress::State::Cancelled:
      text = tr("Cancelled");
      break;
    case LobeProgress::State::Failed:
      text = tr("Cannot be computed: %1").arg(progress.problem);
      break;
  }
  if (!absent_.isEmpty()) text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + absent_;
  if (text != state_->text()) state_->setText(text);
}

void LobesPage::showDiagram() {
  chart_->setDiagram(diagram_.get(), service_->frame());
  showWhatIf();
}

void LobesPage::fieldsChanged() {
  chart_->setHandle({Rpm(speed_->value()), Metres(depth_->value() * unitLength(units_))});
  whatIfAsked();
}

// Somebody moved it: it stays so, for this tool.
void LobesPage::whatIfAsked() {
  asked_ = {service_ != nullptr ? service_->frame().name : QString(), chart_->handle().speed, chart_->handle().depth};
  emit stateChanged();
  askCloser();
  showWhatIf();
}

void LobesPage::showWhatIf() {
  if (service_ == nullptr) return;
  const SpeedDepth at = chart_->handle();
  const LobeCloseUp* closeUp = method_ == LobeMethodChoice::Exact ? closeUp_.get() : nullptr;
  const WhatIf answer = whatIf(diagram_.get(), service_->frame(), at, units_, closeUp);
  verdict_->setText(answer.verdict);
  detail_->setText(answer.detail);
  verdict_->setTone(answer.tone);
  verdict_->setAccessibleDescription(answer.detail);
  std::vector<Pocket> pockets = pocketsAt(diagram_.get(), service_->frame(), at.depth, closeUp);
  showNote(at, pockets);
  showLearned();
  table_->setPockets(std::move(pockets), units_);
}

void LobesPage::showNote(const SpeedDepth& at, const std::vector<Pocket>& pockets) {
  QString text;
  const bool exact =
      method_ == LobeMethodChoice::Exact && closeUp_ && closeUp_->pocketsKnown && closeUp_->at.depth == at.depth;
  if (pockets.empty() && exact && closeUp_->deepest) {
    text = tr("No speed is stable at %1. The deepest stable cut: %2 at %3")
               .arg(depthText(at.depth, units_), depthText(closeUp_->deepest->depth, units_),
                    join(number(closeUp_->deepest->speed.value), rpmUnit()));
  } else if (std::ranges::any_of(pockets, [](const Pocket& pocket) { return !pocket.reachable; })) {
    text = tr("In brackets: beyond the override's reach");
  }
  note_->setText(text);
  note_->setVisible(!text.isEmpty());
}

void LobesPage::restart() {
  met_ = false;
  service_ = nullptr;
  diagram_.reset();
  closeUp_.reset();
}

void LobesPage::keep(QSettings& settings) const {
  settings.setValue(QStringLiteral("method"), static_cast<int>(method_));
  settings.setValue(QStringLiteral("what-if-tool"), asked_.tool);
  settings.setValue(QStringLiteral("what-if-speed"), asked_.speed.value);
  settings.setValue(QStringLiteral("what-if-depth"), asked_.depth.value);
  settings.setValue(QStringLiteral("own"), own_);
  if (form_ != nullptr) form_->keep(settings);
}

void LobesPage::restore(const QSettings& settings) {
  const int kept = settings.value(QStringLiteral("method"), static_cast<int>(LobeMethodChoice::Exact)).toInt();
  if (kept >= 0 && kept < static_cast<int>(methods_.size())) chooseMethod(static_cast<LobeMethodChoice>(kept));
  asked_ = {settings.value(QStringLiteral("what-if-tool")).toString(),
            Rpm(settings.value(QStringLiteral("what-if-speed")).toDouble()),
            Metres(settings.value(QStringLiteral("what-if-depth")).toDouble())};
  if (form_ == nullptr) return;
  form_->restore(settings);
  if (settings.value(QStringLiteral("own")).toBool()) showOwn(true, entry_->service() == nullptr);
}

}  // namespace stillcut::ui
