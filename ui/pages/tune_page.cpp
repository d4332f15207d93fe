#include "ui/pages/tune_page.h"

#include <QHBoxLayout>
#include <QListView>
#include <QScrollArea>
#include <QSettings>
#include <QShortcut>
#include <algorithm>
#include <utility>

#include "core/model/judged_cut.h"
#include "ui/base/format.h"
#include "ui/base/reason_text.h"
#include "ui/base/say.h"
#include "ui/models/live_numbers.h"
#include "ui/pages/active_view.h"
#include "ui/pages/rule_editor.h"
#include "ui/pages/sensitivity_panel.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/param_row.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"
#include "ui/widgets/wrapped_list.h"

namespace stillcut::ui {
namespace {

TouchButton* tool(const QString& caption, const char* name, QWidget* parent) {
  auto* button = new TouchButton(caption, TouchButton::Look::Plain, parent);
  button->setObjectName(QLatin1String(name));
  button->setBaseHeight(50);
  return button;
}

}  // namespace

TunePage::TunePage(Tuning* tuning, std::function<ActiveController*()> active, QWidget* parent)
    : Page(parent),
      tuning_(tuning),
      theme_(makeTheme(ThemeKind::Light, 1.0)),
      active_(new ActiveView(std::move(active))) {
  build();
  work(none_);
  openRun();
}

void TunePage::build() {
  auto* columns = new QHBoxLayout(this);
  list_ = new QListView;
  list_->setObjectName(QStringLiteral("tune-parts"));
  list_->setAccessibleName(tr("Methods"));
  list_->setModel(&parts_);
  showWrapped(*list_);
  list_->setResizeMode(QListView::Adjust);
  list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // names are broken to the width that stays
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& index) {
    showPart(parts_.part(index.row()));
    emit stateChanged();
  });

  auto* middle = new QVBoxLayout;
  middle->addWidget(makeToolbar());
  rowsPanel_ = new Panel;
  auto* rowsColumn = new QVBoxLayout(rowsPanel_);
  title_ = new TextLabel({type_size::kValue, true});
  source_ = new TextLabel({type_size::kLabel, false, true, true});
  scroll_ = new QScrollArea;
  scroll_->setObjectName(QStringLiteral("tune-rows"));
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  rowsBox_ = new QWidget;
  rowsLayout_ = new QVBoxLayout(rowsBox_);
  rowsLayout_->setContentsMargins(0, 0, 0, 0);
  rowsLayout_->setSpacing(0);
  rules_ = new RuleEditor(none_);
  own_ = new TextLabel({type_size::kLabel, false, true, true});
  own_->setObjectName(QStringLiteral("tune-own"));
  rowsLayout_->addWidget(own_);
  rowsLayout_->addWidget(active_);
  rowsLayout_->addWidget(rules_);
  rowsBefore_ = rowsLayout_->count();
  rowsLayout_->addStretch(1);
  scroll_->setWidget(rowsBox_);
  rowsColumn->addWidget(title_);
  rowsColumn->addWidget(source_);
  rowsColumn->addWidget(scroll_, 1);
  middle->addWidget(rowsPanel_, 1);
  sensitivity_ = new SensitivityPanel;
  middle->addWidget(sensitivity_, 1);

  columns->addWidget(list_, 24);
  columns->addLayout(middle, 50);
  columns->addWidget(makeSide(), 26);
}

QWidget* TunePage::makeToolbar() {
  auto* bar = new QWidget;
  tools_ = new QHBoxLayout(bar);
  tools_->setContentsMargins(0, 0, 0, 0);
  undo_ = tool(tr("UNDO"), "tune-undo", bar);
  redo_ = tool(tr("REDO"), "tune-redo", bar);
  start_ = tool(tr("REVERT"), "tune-start", bar);
  reset_ = tool(tr("DEFAULTS"), "tune-reset", bar);
  save_ = tool(tr("SAVE"), "tune-save", bar);
  undo_->setKey(QKeySequence::Undo);
  redo_->setKey(QKeySequence(Qt::CTRL | Qt::Key_Y));
  save_->setKey(QKeySequence::Save);
  connect(undo_, &TouchButton::clicked, this, [this] { controller_->undoStack().undo(); });
  connect(redo_, &TouchButton::clicked, this, [this] { controller_->undoStack().redo(); });
  connect(start_, &TouchButton::clicked, this, [this] {
    if (params_.part() != nullptr) controller_->resetToStart(openParams());
  });
  connect(reset_, &TouchButton::clicked, this, [this] {
    if (params_.part() != nullptr) controller_->resetToDefaults(openParams());
  });
  connect(save_, &TouchButton::clicked, this, &TunePage::save);
  for (TouchButton* button : {undo_, redo_, start_, reset_, save_}) tools_->addWidget(button);
  tools_->addStretch(1);
  return bar;
}

QWidget* TunePage::makeSide() {
  sidePanel_ = new Panel;
  auto* column = new QVBoxLayout(sidePanel_);
  auto* liveTitle = new TextLabel({type_size::kLabel, true, true}, tr("WHAT IT SEES NOW"));
  live_ = new TextLabel({type_size::kValue, true, false, true});
  numbers_ = new TextLabel({type_size::kBody, false, false, true});
  auto* compareTitle = new TextLabel({type_size::kLabel, true, true}, tr("COMPARE"));
  useA_ = tool(QStringLiteral("A"), "tune-a", sidePanel_);
  useB_ = tool(QStringLiteral("B"), "tune-b", sidePanel_);
  copy_ = tool(tr("A = B"), "tune-copy", sidePanel_);
  useA_->setCheckable(true);
  useB_->setCheckable(true);
  useA_->setAccessibleName(tr("Use the values of side A"));
  useB_->setAccessibleName(tr("Use the values of side B"));
  copy_->setAccessibleName(tr("Make the other side like this one"));
  useA_->setKey(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A));
  useB_->setKey(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_B));
  connect(useA_, &TouchButton::clicked, this, [this] {
    controller_->use(TuningController::A);
    refreshTools();
  });
  connect(useB_, &TouchButton::clicked, this, [this] {
    controller_->use(TuningController::B);
    refreshTools();
  });
  connect(copy_, &TouchButton::clicked, this, [this] { controller_->copyToOther(); });
  sides_ = new QHBoxLayout;
  for (TouchButton* button : {useA_, useB_, copy_}) sides_->addWidget(button);
  differs_ = new TextLabel({type_size::kLabel, false, true, true});
  tallyA_ = new TextLabel({type_size::kBody, false, false, true});
  tallyB_ = new TextLabel({type_size::kBody, false, false, true});
  note_ = new TextLabel({type_size::kBody, false, false, true});
  expertButton_ = tool(tr("EXPERT"), "tune-expert", sidePanel_);
  expertButton_->setCheckable(true);
  expertButton_->setAccessibleName(tr("Expert: every method and each of its parameters"));
  connect(expertButton_, &TouchButton::clicked, this, [this] {
    setExpert(!expert_);
    emit stateChanged();
  });
  column->addWidget(liveTitle);
  column->addWidget(live_);
  column->addWidget(numbers_);
  column->addSpacing(10);
  column->addWidget(compareTitle);
  column->addLayout(sides_);
  column->addWidget(differs_);
  column->addWidget(tallyA_);
  column->addWidget(tallyB_);
  column->addStretch(1);
  column->addWidget(note_);
  column->addWidget(expertButton_);
  return sidePanel_;
}

// Where no limits of the detector in charge are known there is nothing simpler than single parameters.
void TunePage::setExpert(bool expert) {
  expert_ = expert;
  const bool simple = !expert && sensitivity_->known();
  list_->setVisible(!simple);
  rowsPanel_->setVisible(!simple);
  sensitivity_->setVisible(simple);
  expertButton_->setChecked(!simple);
  expertButton_->setEnabled(sensitivity_->known());
  // Back to the defaults, and as it began, are of what is on the screen.
  const auto& parts = tuning_ != nullptr ? tuning_->tunableParts() : std::vector<TunableComponent>();
  const auto inCharge = std::ranges::find_if(parts, [](const TunableComponent& part) {
    return part.inCharge && part.role == TunableComponent::Role::Detector;
  });
  if (simple && inCharge != parts.end()) list_->setCurrentIndex(parts_.index(parts_.rowOf(inCharge->id)));
}

void TunePage::work(TuningController& controller) {
  controller_->disconnect(this);
  controller_->undoStack().disconnect(this);
  controller_ = &controller;
  params_.work(controller);
  rules_->work(controller);
  connect(&controller, &TuningController::changed, this, [this] {
    for (ParamRow* row : rows_) row->refresh();
    rules_->refresh(nullptr);
    sensitivity_->refresh();
    refreshTools();
  });
  connect(&controller.undoStack(), &QUndoStack::indexChanged, this, &TunePage::refreshTools);
}

void TunePage::openRun() {
  const QString before = params_.part() != nullptr ? params_.part()->id : QString();
  showPart(nullptr);
  if (tuning_ == nullptr) {
    title_->setText(tr("Nothing to tune: this session has no methods of its own"));
    sensitivity_->work(nullptr, nullptr);
    setExpert(expert_);
    refreshTools();
    return;
  }
  run_ = tuning_->tuningRun();
  const std::vector<TunableComponent>& parts = tuning_->tunableParts();
  parts_.show(parts);
  work(tuning_->controller());
  const auto inCharge = std::ranges::find_if(parts, [](const TunableComponent& part) {
    return part.inCharge && part.role == TunableComponent::Role::Detector;
  });
  sensitivity_->work(tuning_, inCharge != parts.end() ? &*inCharge : nullptr);
  list_->setCurrentIndex(parts_.index(std::max(parts_.rowOf(before), 0)));
  setExpert(expert_);
  refreshTools();
}

std::vector<const config::ParamDecl*> TunePage::openParams() const {
  std::vector<const config::ParamDecl*> open;
  for (int row = 0; row < params_.rowCount(); ++row) {
    if (params_.view(row).locked.isEmpty()) open.push_back(&params_.decl(row));
  }
  for (const auto* rules : {&params_.part()->speedRules, &params_.part()->feedRules}) {
    open.insert(open.end(), rules->begin(), rules->end());
  }
  return open;
}

void TunePage::showPart(const TunableComponent* part) {
  for (ParamRow* row : rows_) delete row;
  rows_.clear();
  params_.show(part);
  title_->setText(part != nullptr ? sayCore(part->label.toStdString()) : QString());
  source_->setText(part != nullptr ? part->source : QString());
  source_->setVisible(!source_->text().isEmpty());
  for (int k = 0; k < params_.rowCount(); ++k) {
    auto* row = new ParamRow(params_, *controller_, k);
    row->applyTheme(theme_);
    for (QWidget* child : row->findChildren<QWidget*>()) {
      if (auto* themed = dynamic_cast<Themed*>(child)) themed->applyTheme(theme_);
    }
    rowsLayout_->insertWidget(rowsBefore_ + k, row);
    rows_.push_back(row);
  }
  rules_->show(part);
  own_->clear();
  own_->hide();
  active_->setVisible(part != nullptr && part->role == TunableComponent::Role::Active);
  scroll_->ensureVisible(0, 0);
}

void TunePage::refreshTools() {
  const bool any = tuning_ != nullptr;
  undo_->setEnabled(controller_->undoStack().canUndo());
  redo_->setEnabled(controller_->undoStack().canRedo());
  for (TouchButton* button : {reset_, start_, save_, useA_, useB_}) button->setEnabled(any);
  useA_->setChecked(controller_->side() == TuningController::A);
  useB_->setChecked(controller_->side() == TuningController::B);
  const auto differences = controller_->differences();
  copy_->setEnabled(any && !differences.empty());
  copy_->setText(controller_->side() == TuningController::A ? tr("B = A") : tr("A = B"));
  differs_->setText(differences.empty() ? tr("Both sides are alike. Take B, change something, and go to and fro.")
                                        : tr("Values that differ: %1").arg(differences.size()));
}

void TunePage::see(const Picture& picture) {
  if (tuning_ == nullptr) return;
  if (tuning_->tuningRun() != run_) openRun();
  if (picture.snapshot == nullptr) return;
  sensitivity_->see(picture);
  controller_->tally().see(*picture.snapshot, static_cast<std::size_t>(controller_->side()));
}

void TunePage::display(const Picture& picture) {
  const bool running = picture.snapshot != nullptr && picture.snapshot->running && !picture.stale && !picture.over();
  if (params_.setRunning(running)) {
    for (ParamRow* row : rows_) row->refresh();
  }
  const TunableComponent* part = params_.part();
  if (running && part != nullptr && part->running && rules_->isVisible()) rules_->refresh(tuning_->rulesNow());
  if (active_->isVisible()) active_->display();
  if (running) showOwn();
  if (sensitivity_->isVisible()) sensitivity_->display(picture);
  showLive(picture);
  tallyA_->setText(QStringLiteral("A: ") + tallyText(controller_->tally().side(0)));
  tallyB_->setText(QStringLiteral("B: ") + tallyText(controller_->tally().side(1)));
}

void TunePage::showOwn() {
  const TunableComponent* part = params_.part();
  if (part == nullptr || !part->running) return;
  params_.tell(tuning_->ownNow(*part));
  for (ParamRow* row : rows_) row->seeAutomatic();
  const QString others = params_.otherOwnText();
  own_->setText(others.isEmpty() ? QString() : tr("Learned by itself") + u'\n' + others);
  own_->setVisible(!others.isEmpty());
}

void TunePage::showLive(const Picture& picture) {
  const TunableComponent* part = params_.part();
  live_->setTone(Tone::Normal);
  if (part == nullptr || picture.snapshot == nullptr) {
    live_->setText(tr("Nothing yet"));
    numbers_->clear();
    return;
  }
  if (picture.over()) {
    live_->setText(picture.link.ended);
    numbers_->clear();
    return;
  }
  if (picture.stale) {
    live_->setTone(Tone::Onset);
    live_->setText(tr("The picture is stale: nothing new for %1").arg(duration(picture.age)));
    numbers_->clear();
    return;
  }
  QStringList lines;
  if (picture.paused) lines << tr("The replay is paused");
  numbers_->setText(lines.join(u'\n'));
  if (part->role == TunableComponent::Role::Strategy) {
    live_->setText(part->running ? reasonText(picture.snapshot->request.reason) : tr("It does not run"));
    return;
  }
  const int index = part->detector >= 0                              ? part->detector
                    : part->role == TunableComponent::Role::Detector ? -1
                                                                     : picture.snapshot->inCharge;
  if (index < 0 || index >= picture.snapshot->detectorCount) {
    live_->setText(tr("It does not run"));
    return;
  }
  const Verdict& verdict = picture.snapshot->verdicts[static_cast<std::size_t>(index)];
  live_->setText(hasState(verdict) ? stateText(verdict.state) : reasonText(whyNotJudged(verdict)));
  if (verdict.alarming()) live_->setTone(verdict.state == CutState::Chatter ? Tone::Chatter : Tone::Onset);
  for (int k = 0; k < part->indicators.size() && k < kMaxIndicators; ++k) {
    const double value = verdict.indicators[static_cast<std::size_t>(k)];
    lines.push_back(QStringLiteral("%1  %2").arg(indicatorText(part->indicators[k]), significant(value, 3)));
  }
  numbers_->setText(lines.join(u'\n'));
}

void TunePage::save() {
  const Result<QString> kept = tuning_->saveValues(controller_->values());
  note_->setTone(kept ? Tone::Normal : Tone::Onset);
  note_->setText(kept ? tr("Kept in %1").arg(kept.value()) : tr("Not kept: %1").arg(sayError(kept.error())));
}

void TunePage::keep(QSettings& settings) const {
  settings.setValue(QStringLiteral("expert"), expert_);
  if (params_.part() != nullptr) settings.setValue(QStringLiteral("part"), params_.part()->id);
}

void TunePage::restore(const QSettings& settings) {
  const int row = parts_.rowOf(settings.value(QStringLiteral("part")).toString());
  if (row >= 0) list_->setCurrentIndex(parts_.index(row));
  setExpert(settings.value(QStringLiteral("expert")).toBool());
}

void TunePage::applyTheme(const Theme& theme) {
  theme_ = theme;
  const int margin = theme.px(16), gap = theme.px(10);
  layout()->setContentsMargins(margin, gap, margin, gap);
  layout()->setSpacing(gap);
  list_->setFont(theme.font(type_size::kBody));
  const int apart = std::max(theme.px(12), pixelsFor(kTouchGapMm, this));
  for (QHBoxLayout* line : {tools_, sides_}) line->setSpacing(apart);
  for (Panel* panel : {sidePanel_, rowsPanel_}) {
    panel->layout()->setContentsMargins(theme.px(14), theme.px(10), theme.px(14), theme.px(10));
    panel->layout()->setSpacing(theme.px(6));
  }
}

}  // namespace stillcut::ui
