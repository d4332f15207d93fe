#include "ui/pages/setup/setup_tab.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>

#include "ui/base/say.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/tool_button.h"

namespace stillcut::ui {

SetupTab::SetupTab(SetupController& controller, SetupDraft& draft, QWidget* parent)
    : Panel(parent), controller_(controller), draft_(draft), theme_(makeTheme(ThemeKind::Light, 1.0)) {}

TouchButton* SetupTab::makeButton(const QString& caption, const QString& spoken, const QString& name) {
  return makeToolButton(caption, spoken, name);
}

QLineEdit* SetupTab::makeEdit(const QString& spoken, const QString& name) {
  auto* edit = new QLineEdit;
  edit->setObjectName(name);
  edit->setAccessibleName(spoken);
  edits_.push_back(edit);
  return edit;
}

void SetupTab::applyTheme(const Theme& theme) {
  Panel::applyTheme(theme);
  theme_ = theme;
  for (QLineEdit* edit : edits_) {
    edit->setFont(theme.font(type_size::kBody));
    edit->setFixedHeight(touchHeight(theme, this));
  }
  if (layout() == nullptr) return;
  layout()->setContentsMargins(theme.px(20), theme.px(14), theme.px(20), theme.px(14));
  layout()->setSpacing(std::max(theme.px(12), pixelsFor(kTouchGapMm, this)));
}

SetupGuide::SetupGuide(SetupController& controller, SetupDraft& draft, QWidget* parent)
    : SetupTab(controller, draft, parent), note_(new TextLabel({type_size::kBody, false, false, true})) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(new TextLabel({type_size::kFault, true}, tr("Three ways to begin")));
  column->addWidget(new TextLabel({type_size::kBody, false, true, true},
                                  tr("Look at a simulated cut first: it chatters as it gets deeper, and the program "
                                     "finds the stable speed. Nothing has to be connected.")));
  column->addWidget(new TextLabel({type_size::kBody, false, true, true},
                                  tr("Or open a recording of a cut, of a phone or a logger: whether it chatters, why, "
                                     "and which speed helps.")));
  auto* show = new TouchButton(tr("SHOW ME A SIMULATED CUT"), TouchButton::Look::Advice);
  show->setObjectName(QStringLiteral("guide-simulated"));
  show->setBaseHeight(72);
  auto* file = new TouchButton(tr("LOOK AT MY RECORDING"), TouchButton::Look::Advice);
  file->setObjectName(QStringLiteral("guide-file"));
  file->setBaseHeight(72);
  connect(file, &TouchButton::clicked, this, &SetupTab::fileAsked);
  auto* doors = new QHBoxLayout;
  doors->addWidget(show);
  doors->addWidget(file);
  doors->addStretch(1);
  column->addLayout(doors);
  column->addSpacing(16);
  column->addWidget(new TextLabel({type_size::kBody, false, true, true},
                                  tr("Or connect this machine, step by step. Each step says what is still missing; "
                                     "nothing is commanded while authority is Off.")));
  const struct {
    QString caption, name;
    int tab;
  } steps[] = {{tr("1  MACHINE"), QStringLiteral("guide-machine"), 1},
               {tr("2  SENSORS"), QStringLiteral("guide-sensors"), 2},
               {tr("3  TOOL"), QStringLiteral("guide-tool"), 3},
               {tr("4  TRY OUT, SAVE, START"), QStringLiteral("guide-profile"), 5}};
  auto* line = new QHBoxLayout;
  for (const auto& step : steps) {
    TouchButton* button = makeButton(step.caption, step.caption, step.name);
    button->setBaseHeight(72);
    steps_.push_back(button);
    line->addWidget(button);
    connect(button, &TouchButton::clicked, this, [this, tab = step.tab] { emit tabAsked(tab); });
  }
  begin_ = show;
  column->addLayout(line);
  column->addWidget(note_);
  column->addStretch(1);
  connect(show, &TouchButton::clicked, this, [this] {
    const Status begun = controller_.startDemonstration();
    note_->setTone(begun ? Tone::Normal : Tone::Onset);
    note_->setText(begun ? QString() : sayError(begun.error()));
    if (begun) emit started();
  });
  refresh();
}

void SetupGuide::refresh() {
  const SetupDraft::Part parts[] = {SetupDraft::Part::Machine, SetupDraft::Part::Sensors, SetupDraft::Part::Tool};
  for (std::size_t k = 0; k < 3; ++k) {
    const QString missing = draft_.missing(parts[k]);
    steps_[k]->setHint(missing.isEmpty() ? tr("ready") : tr("still open"));
    steps_[k]->setToolTip(missing);
    steps_[k]->setAccessibleDescription(missing.isEmpty() ? tr("ready") : missing);
  }
  steps_[3]->setHint(controller_.profileInForce().isEmpty() ? tr("still open") : tr("active"));
}

}  // namespace stillcut::ui
