#include "ui/pages/lobes_page.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QSettings>
#include <QSignalBlocker>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/base/conversions.h"
#include "ui/base/format.h"
#include "ui/base/say.h"
#include "ui/plots/lobe_chart.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

double unitLength(UnitSystem units) {
  return units == UnitSystem::Inch ? kInch : 1e-3;
}

}  // namespace

LobesPage::LobesPage(FindService find, QWidget* parent)
    : Page(parent),
      find_(std::move(find)),
      chart_(new LobeChart),
      methods_{new TouchButton(tr("ZEROTH ORDER")), new TouchButton(tr("SEMI-DISCRETE")), new TouchButton(tr("EXACT"))},
      compute_(new TouchButton(tr("COMPUTE"), TouchButton::Look::Advice)),
      progress_(new QProgressBar),
      state_(new QLabel),
      speed_(new QDoubleSpinBox),
      depth_(new QDoubleSpinBox),
      verdict_(new TextLabel({type_size::kValue, true, false, true})),
      detail_(new QLabel),
      reach_(new QLabel(tr("In brackets: beyond the override's reach"))),
      pockets_(new QTableView),
      table_(new PocketTable(this)),
      side_(new Panel),
      grid_(new QGridLayout(this)) {
  layOut();
  connectAll();
  chooseMethod(method_);
}

// Longer than a screen: what stands where on the page, from top to bottom
void LobesPage::layOut() {
  auto* around = new Panel;
  auto* chartLayout = new QVBoxLayout(around);
  chartLayout->setContentsMargins(4, 4, 4, 4);
  chartLayout->addWidget(chart_);
  auto* column = new QVBoxLayout(side_);
  auto* methods = new QHBoxLayout;
  const std::array<QString, 3> names{QStringLiteral("method-zoa"), QStringLiteral("method-sdm"),
                                     QStringLiteral("method-exact")};
  for (std::size_t k = 0; k < methods_.size(); ++k) {
    methods_[k]->setObjectName(names[k]);
    methods_[k]->setCheckable(true);
    methods_[k]->setBaseHeight(50);
    methods->addWidget(methods_[k]);
  }
  column->addLayout(methods);
  auto* work = new QHBoxLayout;
  compute_->setObjectName(QStringLiteral("compute"));
  compute_->setBaseHeight(50);
  compute_->setKey(Qt::Key_F8);
  progress_->setRange(0, 100);
  progress_->setTextVisible(true);
  progress_->setAccessibleName(tr("Progress of the diagram"));
  work->addWidget(compute_);
  work->addWidget(progress_, 1);
  column->addLayout(work);
  state_->setWordWrap(true);
  column->addWidget(state_);

  auto* form = new QGridLayout;
  auto* speedLabel = new QLabel(tr("What if the speed were"));
  auto* depthLabel = new QLabel(tr("and the depth"));
  speed_->setObjectName(QStringLiteral("what-if-speed"));
  depth_->setObjectName(QStringLiteral("what-if-depth"));
  speed_->setAccessibleName(tr("Speed, what if"));
  depth_->setAccessibleName(tr("Depth, what if"));
  speedLabel->setBuddy(speed_);
  depthLabel->setBuddy(depth_);
  speed_->setSuffix(QStringLiteral("\u00a0rpm"));
  speed_->setSingleStep(50);
  // Arrows are too small for a glove: the ring is dragged, or the arrow keys pressed.
  for (QDoubleSpinBox* box : {speed_, depth_}) box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  form->addWidget(speedLabel, 0, 0);
  form->addWidget(speed_, 0, 1);
  form->addWidget(depthLabel, 1, 0);
  form->addWidget(depth_, 1, 1);
  form->setColumnStretch(1, 1);
  column->addLayout(form);
  detail_->setWordWrap(true);
  verdict_->setObjectName(QStringLiteral("what-if"));
  column->addWidget(verdict_);
  column->addWidget(detail_);

  pockets_->setModel(table_);
  pockets_->setAccessibleName(tr("Stable speeds at this depth"));
  pockets_->setToolTip(tr("Choose a pocket to try its best speed"));
  pockets_->setSelectionBehavior(QAbstractItemView::SelectRows);
  pockets_->setSelectionMode(QAbstractItemView::SingleSelection);
  pockets_->verticalHeader()->hide();
  pockets_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  pockets_->horizontalHeader()->setSectionResizeMode(PocketTable::Speeds, QHeaderView::ResizeToContents);
  pockets_->setTabKeyNavigation(false);
  column->addWidget(pockets_, 1);
  reach_->setWordWrap(true);
  column->addWidget(reach_);
  grid_->addWidget(around, 0, 0);
  grid_->addWidget(side_, 0, 1);
  grid_->setColumnStretch(0, 62);
  grid_->setColumnStretch(1, 38);
}

void LobesPage::connectAll() {
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
  const bool known = service_ != nullptr;
  side_->setEnabled(known);
  table_->setPockets({}, units_);
  reach_->hide();
  chart_->setVisible(known);  // axes of nothing tell nothing
  if (!known) {
    for (QDoubleSpinBox* box : {speed_, depth_}) box->clear();
    progress_->hide();
    chart_->setDiagram(nullptr, {});
    chart_->setWork({}, {});
    chart_->setAdvice({});
    verdict_->clear();
    detail_->clear();
    state_->setText(
        replay ? tr("The recording does not say which modes its tool has: there is no diagram of this cut. The "
                    "machine's own comes back with its cut.")
               : tr("The modes of this tool are not known. A tap test gives the file of its modes (F1 tells "
                    "how): name it under Set up, TOOLS; the diagram needs nothing else."));
    return;
  }
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
  if (!met_ || otherUnits) meet(find_(), picture.replay);
  if (service_ == nullptr) return;
  absent_.clear();
  if (picture.paused) absent_ = tr("The replay is paused");
  if (picture.snapshot != nullptr && picture.stale) absent_ = tr("Nothing new arrives: the working point is not shown");
  if (picture.over()) absent_ = picture.link.ended;
  if (!service_->frame().depthKnown) {
    absent_ = tr("The depth of cut is not known: tell it under Set up, MACHINE, and the working point is shown");
  }
  showProgress();
  if (service_->diagram() != diagram_) {
    diagram_ = service_->diagram();
    showDiagram();
  }
  showWork(picture);
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
      text = tr("Computing; the diagram before stays until it is done");
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
  showWhatIf();
}

void LobesPage::showWhatIf() {
  if (service_ == nullptr) return;
  const SpeedDepth at = chart_->handle();
  const WhatIf answer = whatIf(diagram_.get(), service_->frame(), at.speed, at.depth, units_);
  verdict_->setText(answer.verdict);
  detail_->setText(answer.detail);
  verdict_->setTone(answer.tone);
  verdict_->setAccessibleDescription(answer.detail);
  std::vector<Pocket> pockets = diagram_ ? pocketsAt(*diagram_, service_->frame(), at.depth) : std::vector<Pocket>{};
  reach_->setVisible(std::ranges::any_of(pockets, [](const Pocket& pocket) { return !pocket.reachable; }));
  table_->setPockets(std::move(pockets), units_);
}

void LobesPage::restart() {
  met_ = false;
  service_ = nullptr;
  diagram_.reset();
}

void LobesPage::keep(QSettings& settings) const {
  settings.setValue(QStringLiteral("method"), static_cast<int>(method_));
  settings.setValue(QStringLiteral("what-if-tool"), asked_.tool);
  settings.setValue(QStringLiteral("what-if-speed"), asked_.speed.value);
  settings.setValue(QStringLiteral("what-if-depth"), asked_.depth.value);
}

void LobesPage::restore(const QSettings& settings) {
  const int kept = settings.value(QStringLiteral("method"), static_cast<int>(LobeMethodChoice::Exact)).toInt();
  if (kept >= 0 && kept < static_cast<int>(methods_.size())) chooseMethod(static_cast<LobeMethodChoice>(kept));
  asked_ = {settings.value(QStringLiteral("what-if-tool")).toString(),
            Rpm(settings.value(QStringLiteral("what-if-speed")).toDouble()),
            Metres(settings.value(QStringLiteral("what-if-depth")).toDouble())};
}

void LobesPage::applyTheme(const Theme& theme) {
  const int margin = theme.px(16), gap = theme.px(10);
  const int touchGap = std::max(theme.px(12), pixelsFor(kTouchGapMm, this)),
            high = std::max(theme.px(50), pixelsFor(kTouchMm, this));
  grid_->setContentsMargins(margin, gap, margin, gap);
  grid_->setSpacing(gap);
  side_->layout()->setContentsMargins(margin, margin, margin, margin);
  side_->layout()->setSpacing(touchGap);
  for (QLabel* label : side_->findChildren<QLabel*>()) {
    if (label != verdict_) label->setFont(theme.font(type_size::kBody));
  }
  for (QDoubleSpinBox* box : {speed_, depth_}) {
    box->setFont(theme.font(type_size::kValue));
    box->setMinimumHeight(high);
  }
  progress_->setFont(theme.font(type_size::kBody));
  progress_->setMinimumHeight(high);
  pockets_->setFont(theme.font(type_size::kBody));
  pockets_->horizontalHeader()->setFont(theme.font(type_size::kLabel));
  pockets_->verticalHeader()->setDefaultSectionSize(high);
  showWhatIf();
}

}  // namespace stillcut::ui
