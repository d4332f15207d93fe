#include "ui/pages/file/question_fields.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/typed_number.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"

namespace stillcut::ui {
namespace {

constexpr int kMostTeeth = 64;
constexpr double kHighestSpeed = 1e6;  // rev/min

QLineEdit* makeField(const QString& name, const QString& spoken) {
  auto* field = new QLineEdit;
  field->setObjectName(name);
  field->setAccessibleName(spoken);
  field->setPlaceholderText(spoken);
  field->setInputMethodHints(Qt::ImhFormattedNumbersOnly);
  return field;
}

}  // namespace

QuestionFields::QuestionFields(const QString& name, QWidget* parent)
    : QWidget(parent),
      teeth_(makeField(name + QStringLiteral("-teeth"), tr("Teeth"))),
      speed_(makeField(name + QStringLiteral("-speed"), tr("Speed, rpm"))),
      fields_(new QHBoxLayout(this)) {
  fields_->setContentsMargins(0, 0, 0, 0);
  // Their labels stay when they are filled.
  for (const auto& [field, share] : {std::pair(teeth_, 2), std::pair(speed_, 3)}) {
    auto* labelled = new QVBoxLayout;
    labelled->setSpacing(2);
    labelled->addWidget(new TextLabel({type_size::kLabel, false, true}, field->accessibleName()));
    labelled->addWidget(field);
    fields_->addLayout(labelled, share);
    connect(field, &QLineEdit::textEdited, this, &QuestionFields::edited);
  }
}

FileQuestion QuestionFields::question() const {
  FileQuestion question;
  const double teeth = typedSpeed(teeth_->text()), speed = typedSpeed(speed_->text());
  if (teeth >= 1.0 && teeth <= kMostTeeth) question.teeth = static_cast<int>(std::lround(teeth));
  if (speed > 0.0 && speed <= kHighestSpeed) question.speed = Rpm(speed);
  return question;
}

void QuestionFields::setQuestion(const FileQuestion& question) {
  teeth_->setText(question.teeth > 0 ? QString::number(question.teeth) : QString());
  speed_->setText(question.speed.value > 0.0 ? QString::number(question.speed.value, 'f', 0) : QString());
}

void QuestionFields::applyTheme(const Theme& theme) {
  fields_->setSpacing(std::max(theme.px(8), pixelsFor(kTouchGapMm, this)));
  for (QLineEdit* field : {teeth_, speed_}) {
    field->setFont(theme.font(type_size::kBody));
    field->setFixedHeight(touchHeight(theme, this));
  }
}

}  // namespace stillcut::ui
