#include "ui/pages/setup/setup_limits.h"

#include <QGridLayout>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>
#include <string>
#include <string_view>

#include "core/config/override_limits.h"
#include "ui/base/say.h"
#include "ui/base/typed_number.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"

namespace stillcut::ui {
namespace {

QString fromUtf8(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString shown(std::string_view text) {
  return sayCore(std::string(text));
}

// What a file calls a limit is told by the words beside its field.
QString byLabels(QString text) {
  for (const config::ParamDecl* decl : config::kOverrideLimitParams) {
    text.replace(fromUtf8(decl->key), QStringLiteral("\u201c%1\u201d").arg(shown(decl->label)));
  }
  return text;
}

}  // namespace

SetupLimits::SetupLimits(SetupController& controller, SetupDraft& draft, QWidget* parent)
    : SetupTab(controller, draft, parent),
      grid_(new QGridLayout),
      about_(new TextLabel({type_size::kBody, false, true, true})),
      problem_(new TextLabel({type_size::kBody, true, false, true})) {
  catalog_.add(config::kOverrideLimitParams);
  auto* column = new QVBoxLayout(this);
  column->addWidget(new TextLabel({type_size::kLabel, true, true}, tr("STILLCUT NEVER DRIVES THE MACHINE BEYOND")));
  for (const config::ParamDecl* decl : config::kOverrideLimitParams) addField(*decl);
  grid_->setColumnStretch(0, 3);
  grid_->setColumnStretch(1, 2);
  grid_->setColumnStretch(2, 3);
  grid_->setColumnStretch(3, 2);
  column->addLayout(grid_);
  problem_->setTone(Tone::Onset);
  problem_->setObjectName(QStringLiteral("limits-problem"));
  column->addWidget(problem_);
  column->addStretch(1);
  about_->setText(
      tr("What the program says and the operator's own overrides are left alone. The limits are saved with the profile "
         "and hold from its START on, for the whole run."));
  column->addWidget(about_);
  SetupLimits::refresh();
}

// Lowest and highest stand beside each other, as they are declared.
void SetupLimits::addField(const config::ParamDecl& decl) {
  const auto place = static_cast<int>(fields_.size());
  Field field{&decl, makeEdit(shown(decl.label), fromUtf8(decl.key))};
  field.edit->setToolTip(shown(decl.meaning));
  field.edit->setPlaceholderText(tr("no limit"));
  grid_->addWidget(new TextLabel(TextLabel::Look{type_size::kBody, false, false, true},
                                 QStringLiteral("%1, %2").arg(shown(decl.label), shown(decl.unit))),
                   place / 2, 2 * (place % 2));
  grid_->addWidget(field.edit, place / 2, 2 * (place % 2) + 1);
  connect(field.edit, &QLineEdit::editingFinished, this, [this, field] {
    if (field.edit->isModified()) setLimit(*field.decl, field.edit->text());
  });
  fields_.push_back(field);
}

void SetupLimits::setLimit(const config::ParamDecl& decl, const QString& text) {
  const QString number = plainSpeed(text);
  Status set = Done{};
  draft_.edit([&](config::Profile& p) {
    if (number.isEmpty()) {
      p.params.unset(decl);
    } else {
      set = p.params.set(catalog_, decl.key, number.toStdString(), shown(decl.label).toStdString());
    }
  });
  refused_ = !set;
  if (refused_) {
    problem_->setText(byLabels(sayError(set.error())));
  } else {
    for (const Field& field : fields_) {
      if (field.decl == &decl) field.edit->setModified(false);
    }
    refresh();
  }
}

// Limits that cross each other leave the machine no room, and a profile with them does not start.
void SetupLimits::check() {
  if (refused_) return;
  const config::Profile& profile = draft_.profile();
  const auto checked = config::checkOverrideLimits(profile.params, profile.cut, "");
  problem_->setText(checked ? QString() : byLabels(sayCore(checked.error().what)));
}

void SetupLimits::refresh() {
  const config::ParamSet& params = draft_.profile().params;
  for (const Field& field : fields_) {
    if (field.edit->hasFocus() && field.edit->isModified()) continue;
    field.edit->setText(params.isAutomatic(*field.decl) ? QString() : QString::fromStdString(params.text(*field.decl)));
  }
  check();
}

void SetupLimits::applyTheme(const Theme& theme) {
  SetupTab::applyTheme(theme);
  grid_->setHorizontalSpacing(theme.px(12));
  grid_->setVerticalSpacing(std::max(theme.px(8), pixelsFor(kTouchGapMm, this)));
}

}  // namespace stillcut::ui
