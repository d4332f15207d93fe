#include "ui/pages/setup/setup_profile.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>

#include "ui/base/say.h"
#include "ui/models/plain_words.h"
#include "ui/widgets/step_list.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

StepLine lineOf(const TrialStep& step) {
  const QString names[] = {say("settings"), say("device"), say("samples"), say("link"), say("machine")};
  const QString name = names[static_cast<std::size_t>(step.what)];
  switch (step.state) {
    case TrialStep::State::Waits:
      return {QStringLiteral("○  ") + name, Tone::Faint};
    case TrialStep::State::Runs:
      return {QStringLiteral("…  ") + name};
    case TrialStep::State::Good:
      return {QStringLiteral("✓  ") + name +
              (step.detail.isEmpty() ? QString() : QStringLiteral(": ") + plainWords(step.detail))};
    case TrialStep::State::Bad:
      return {QStringLiteral("✗  ") + name + QStringLiteral(": ") + plainWords(step.detail), Tone::Onset};
  }
  return {};
}

}  // namespace

SetupProfile::SetupProfile(SetupController& controller, SetupDraft& draft, QWidget* parent)
    : SetupTab(controller, draft, parent),
      name_(makeEdit(tr("Name of the profile"), QStringLiteral("profile-name"))),
      known_(new QListWidget),
      trial_(new StepList),
      note_(new TextLabel({type_size::kBody, true, false, true})),
      force_(new TextLabel({type_size::kBody, false, true, true})),
      try_(makeButton(tr("TRY OUT"), tr("Try out step by step; nothing is commanded"), QStringLiteral("profile-try"))),
      save_(makeButton(tr("SAVE"), tr("Save the profile"), QStringLiteral("profile-save"))),
      start_(new TouchButton(tr("START"), TouchButton::Look::Advice)),
      load_(makeButton(tr("LOAD"), tr("Load the chosen profile"), QStringLiteral("profile-load"))) {
  auto* columns = new QHBoxLayout(this);
  auto* left = new QVBoxLayout;
  left->addWidget(new TextLabel({type_size::kLabel, true, true}, tr("PROFILES")));
  known_->setObjectName(QStringLiteral("profiles"));
  known_->setAccessibleName(tr("Profiles"));
  left->addWidget(known_, 1);
  left->addWidget(load_);
  auto* right = new QVBoxLayout;
  addChoices(right, tr("DETECTOR IN CHARGE"), controller.detectors(), detectors_, QStringLiteral("detector-"),
             &config::Profile::detector);
  addChoices(right, tr("STRATEGY"), controller.strategies(), strategies_, QStringLiteral("strategy-"),
             &config::Profile::strategy);
  auto* line = new QHBoxLayout;
  start_->setObjectName(QStringLiteral("profile-start"));
  start_->setAccessibleName(tr("Save the profile and begin with it"));
  start_->setBaseHeight(50);
  line->addWidget(new TextLabel(TextLabel::Look{type_size::kBody}, tr("Name")));
  line->addWidget(name_, 1);
  for (TouchButton* button : {try_, save_, start_}) line->addWidget(button);
  right->addLayout(line);
  right->addWidget(trial_);
  right->addWidget(note_);
  right->addStretch(1);
  right->addWidget(force_);
  columns->addLayout(left, 26);
  columns->addLayout(right, 74);
  connect(name_, &QLineEdit::editingFinished, this, [this] { draft_.setName(name_->text().trimmed()); });
  connect(try_, &TouchButton::clicked, this, [this] {
    if (lacksDevice()) return;
    controller_.tryOut(draft_.profile(), draft_.name());
    showTrial();
  });
  connect(save_, &TouchButton::clicked, this, [this] {
    draft_.setName(name_->text().trimmed());
    const auto saved = controller_.save(draft_.profile(), draft_.name());
    tell(saved ? Status(Done{}) : Status(saved.error()), saved ? tr("Saved: %1").arg(saved.value()) : QString());
    refresh();
  });
  connect(start_, &TouchButton::clicked, this, &SetupProfile::start);
  connect(load_, &TouchButton::clicked, this, [this] {
    if (known_->currentItem() == nullptr) return;
    const QString shipped = known_->currentItem()->data(Qt::UserRole).toString();
    const QString name = shipped.isEmpty() ? known_->currentItem()->text() : shipped;
    auto profile = shipped.isEmpty() ? controller_.load(name) : controller_.loadShipped(name);
    if (profile) draft_.open(*profile, name);
    tell(profile ? Status(Done{}) : Status(profile.error()), tr("Loaded: %1").arg(name));
  });
  SetupProfile::refresh();
}

// Said in the words of the screen, before anything is saved or tried.
bool SetupProfile::lacksDevice() {
  const bool lacks = draft_.profile().source.id.empty();
  if (lacks) {
    note_->setTone(Tone::Onset);
    note_->setText(tr("No device is chosen to measure with: choose one under SENSORS."));
  }
  return lacks;
}

bool SetupProfile::start() {
  draft_.setName(name_->text().trimmed());
  if (lacksDevice()) return false;
  const Status begun = controller_.start(draft_.profile(), draft_.name());
  tell(begun, tr("It runs. Authority is Off."));
  refresh();
  if (begun) emit started();
  return begun.ok();
}

// Nobody's own profile is written over.
bool SetupProfile::startUnderAnyName() {
  const QString base = QStringLiteral("machine");
  QString name = base;
  const QStringList taken = controller_.profiles();
  for (int k = 2; taken.contains(name); ++k) name = QStringLiteral("%1-%2").arg(base).arg(k);
  if (name_->text().trimmed().isEmpty()) name_->setText(name);
  return start();
}

void SetupProfile::addChoices(QBoxLayout* column, const QString& title, const std::vector<ComponentOption>& options,
                              std::vector<TouchButton*>& buttons, const QString& prefix,
                              std::string config::Profile::*field) {
  column->addWidget(new TextLabel({type_size::kLabel, true, true}, title));
  auto* grid = new QGridLayout;
  constexpr int kColumns = 3;
  for (const ComponentOption& option : options) {
    TouchButton* button = makeButton(sayCore(option.description.toStdString()),
                                     sayCore(option.description.toStdString()), prefix + option.id);
    button->setCheckable(true);
    button->setTwoLines(true);
    const int place = static_cast<int>(buttons.size());
    grid->addWidget(button, place / kColumns, place % kColumns);
    buttons.push_back(button);
    connect(button, &TouchButton::clicked, this,
            [this, field, id = option.id.toStdString()] { draft_.edit([&](config::Profile& p) { p.*field = id; }); });
  }
  column->addLayout(grid);
}

// The shop's own first; below them what comes with the program, to be saved under a name of the shop.
void SetupProfile::showKnown() {
  const QStringList own = controller_.profiles(), shipped = controller_.shippedProfiles();
  if (known_->count() != own.size() + shipped.size()) {
    known_->clear();
    known_->addItems(own);
    for (const QString& name : shipped) {
      auto* item = new QListWidgetItem(tr("Example: %1").arg(name), known_);
      item->setData(Qt::UserRole, name);
    }
  }
  load_->setEnabled(known_->count() > 0);
}

void SetupProfile::tell(const Status& status, const QString& done) {
  note_->setTone(status ? Tone::Normal : Tone::Onset);
  note_->setText(status ? done : plainWords(sayError(status.error())));
}

void SetupProfile::refresh() {
  const config::Profile& profile = draft_.profile();
  const auto check = [](const std::vector<TouchButton*>& buttons, const QString& name) {
    for (TouchButton* button : buttons) button->setChecked(button->objectName() == name);
  };
  check(detectors_, QStringLiteral("detector-") + QString::fromStdString(profile.detector));
  check(strategies_, QStringLiteral("strategy-") + QString::fromStdString(profile.strategy));
  if (!name_->hasFocus()) name_->setText(draft_.name());
  showKnown();
  const QString force = controller_.profileInForce();
  force_->setText(force.isEmpty() ? tr("A demonstration runs, no profile.") : tr("In force: %1").arg(force));
  showTrial();
}

void SetupProfile::showTrial() {
  std::vector<StepLine> lines;
  for (const TrialStep& step : controller_.trial()) lines.push_back(lineOf(step));
  if (lines.empty()) lines.push_back({tr("Try it out first: each step says what was found. Nothing is commanded.")});
  trial_->display(lines);
}

void SetupProfile::applyTheme(const Theme& theme) {
  SetupTab::applyTheme(theme);
  known_->setFont(theme.font(type_size::kBody));
}

}  // namespace stillcut::ui
