#include "ui/pages/setup/setup_page.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QSettings>
#include <QStackedWidget>
#include <algorithm>

#include "ui/pages/setup/setup_limits.h"
#include "ui/pages/setup/setup_parts.h"
#include "ui/pages/setup/setup_profile.h"
#include "ui/pages/setup/setup_recording.h"
#include "ui/pages/setup/setup_tools.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

constexpr int kProfileTab = 5;
constexpr int kLimitsTab = 6, kLimitsPlace = 2;

}  // namespace

SetupPage::SetupPage(SetupController* controller, QWidget* parent)
    : Page(parent), controller_(controller), stack_(new QStackedWidget) {
  auto* line = new QHBoxLayout(this);
  if (controller == nullptr) {
    line->addWidget(new TextLabel({type_size::kValue, false, true, true}, tr("There is nothing to set up here.")));
    return;
  }
  if (const auto begun = controller->keptDraft()) {
    draft_.open(*begun, {});
    waits_ = true;
  } else {
    // What the demonstration cuts is nothing that anybody has said of this machine.
    config::Profile running = controller->draft();
    if (controller->profileInForce().isEmpty()) running.cut = {};
    draft_.open(running, controller->profileInForce());
  }
  auto* profile = new SetupProfile(*controller, draft_);
  auto* limits = new SetupLimits(*controller, draft_);
  tabs_ = {new SetupGuide(*controller, draft_),
           new SetupMachine(*controller, draft_),
           new SetupSensors(*controller, draft_),
           new SetupTools(*controller, draft_),
           new SetupRecording(*controller, draft_),
           profile,
           limits};
  const struct {
    QString caption;
    const char* name;
  } names[] = {{tr("GUIDE"), "setup-guide"},  {tr("MACHINE"), "setup-machine"},     {tr("SENSORS"), "setup-sensors"},
               {tr("TOOLS"), "setup-tools"},  {tr("RECORDING"), "setup-recording"}, {tr("PROFILE"), "setup-profile"},
               {tr("LIMITS"), "setup-limits"}};
  choices_ = new QVBoxLayout;
  for (std::size_t k = 0; k < tabs_.size(); ++k) {
    SetupTab* tab = tabs_[k];
    stack_->addWidget(tab);
    auto* button = new TouchButton(names[k].caption);
    button->setObjectName(QLatin1String(names[k].name));
    button->setCheckable(true);
    button->setBaseHeight(62);
    // Beside the machine that they are of; every other tab keeps its number in the settings.
    tab == tabs_.back() ? choices_->insertWidget(kLimitsPlace, button) : choices_->addWidget(button);
    buttons_.push_back(button);
    connect(button, &TouchButton::clicked, this, [this, k] { showTab(static_cast<int>(k)); });
    connect(tab, &SetupTab::tabAsked, this, &SetupPage::showTab);
    connect(tab, &SetupTab::manualAsked, this, &Page::manualAsked);
    connect(tab, &SetupTab::fileAsked, this, [this] { emit fileAsked({}); });
    connect(tab, &SetupTab::started, this, [this] {
      setWaits(false);
      emit pageAsked(QStringLiteral("operate"));
    });
  }
  start_ = new TouchButton(tr("START"), TouchButton::Look::Advice);
  start_->setObjectName(QStringLiteral("setup-start"));
  start_->setAccessibleName(tr("Save what was changed and begin with it"));
  start_->setBaseHeight(62);
  choices_->addWidget(start_);
  connect(start_, &TouchButton::clicked, this, [this, profile, limits] {
    start_->setFocus(Qt::MouseFocusReason);  // what is being typed counts
    if (limits->refused()) return showTab(kLimitsTab);
    if (!profile->startUnderAnyName()) showTab(kProfileTab);  // which says why
  });
  choices_->addStretch(1);
  line->addLayout(choices_);
  line->addWidget(stack_, 1);
  connect(&draft_, &SetupDraft::changed, this, [this] {
    for (SetupTab* tab : tabs_) tab->refresh();
    controller_->keepDraft(draft_.profile());
    setWaits(true);
    emit stateChanged();
  });
  for (const QLineEdit* edit : tabs_.back()->findChildren<QLineEdit*>())
    connect(edit, &QLineEdit::textEdited, this, [this] { setWaits(true); });
  showTab(firstTab(0));
}

// Whoever has a machine running looks at it, not at ways to begin.
int SetupPage::firstTab(int kept) const {
  const bool runs = controller_ != nullptr && !controller_->profileInForce().isEmpty();
  return kept == 0 && runs ? kProfileTab : kept;
}

void SetupPage::setWaits(bool waits) {
  waits_ = waits;
  showStart();
}

// From every tab but the one that has it.
void SetupPage::showStart() {
  if (start_ != nullptr) start_->setVisible(waits_ && stack_->currentIndex() != kProfileTab);
}

void SetupPage::showTab(int tab) {
  stack_->setCurrentIndex(tab);
  showStart();
  for (std::size_t k = 0; k < buttons_.size(); ++k) {
    const bool shown = static_cast<int>(k) == tab;
    buttons_[k]->setChecked(shown);
    // A tab that has not been on show yet does not know how narrow it can be.
    QSizePolicy policy = tabs_[k]->sizePolicy();
    policy.setHorizontalPolicy(shown ? QSizePolicy::Preferred : QSizePolicy::Ignored);
    tabs_[k]->setSizePolicy(policy);
  }
  emit stateChanged();
}

void SetupPage::see(const Picture&) {
  if (controller_ == nullptr || !controller_->poll()) return;
  for (SetupTab* tab : tabs_) tab->refresh();
}

void SetupPage::display(const Picture& picture) {
  if (controller_ == nullptr) return;
  const bool waited = waits_;
  draft_.setUnits(picture.units);  // the same in other words
  if (waits_ != waited) setWaits(waited);
  tabs_[static_cast<std::size_t>(stack_->currentIndex())]->display(picture);
}

void SetupPage::keep(QSettings& settings) const {
  settings.setValue(QStringLiteral("tab"), stack_->currentIndex());
  settings.setValue(QStringLiteral("draft"), draft_.name());
}

void SetupPage::restore(const QSettings& settings) {
  const int tab = settings.value(QStringLiteral("tab"), 0).toInt();
  if (tab >= 0 && tab < static_cast<int>(tabs_.size())) showTab(firstTab(tab));
  if (controller_ != nullptr && controller_->keptDraft())
    draft_.setName(settings.value(QStringLiteral("draft")).toString());
}

void SetupPage::applyTheme(const Theme& theme) {
  const int margin = theme.px(16), gap = theme.px(10);
  layout()->setContentsMargins(margin, gap, margin, gap);
  layout()->setSpacing(std::max(theme.px(12), pixelsFor(kTouchGapMm, this)));
  if (choices_ != nullptr) choices_->setSpacing(std::max(theme.px(12), pixelsFor(kTouchGapMm, this)));
}

}  // namespace stillcut::ui
