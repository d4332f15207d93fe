#include "ui/pages/file/file_answer.h"

#include <QDateTime>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/format.h"
#include "ui/base/typed_number.h"
#include "ui/pages/tool_button.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"

namespace stillcut::ui {
namespace {

constexpr int kMostTeeth = 64;
constexpr double kHighestSpeed = 1e6;  // rev/min

QLineEdit* makeField(const char* name, const QString& spoken) {
  auto* field = new QLineEdit;
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(spoken);
  field->setPlaceholderText(spoken);
  field->setInputMethodHints(Qt::ImhFormattedNumbersOnly);
  return field;
}

QString factsOf(const FileContents& file) {
  QStringList facts{file.kind, join(number(file.rate.value), QStringLiteral("Hz")),
                    join(number(file.length.value, file.length.value < 100.0 ? 2 : 0), QStringLiteral("s"))};
  if (file.wallMs > 0)
    facts << QDateTime::fromMSecsSinceEpoch(file.wallMs).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
  if (!file.tool.isEmpty()) facts << file.tool;
  return facts.join(QStringLiteral(" \u00b7 "));
}

QString listed(const std::vector<double>& values) {
  QStringList texts;
  for (const double value : values) texts << number(value);
  return texts.join(QStringLiteral(", "));
}

Tone toneOf(Finding finding) {
  return finding == Finding::Chatter ? Tone::Chatter : finding == Finding::NotJudged ? Tone::Onset : Tone::Normal;
}

}  // namespace

FileAnswerPanel::FileAnswerPanel(QWidget* parent)
    : Panel(parent),
      fields_(new QHBoxLayout),
      title_(new TextLabel({type_size::kValue, true, false, true})),
      facts_(new TextLabel({type_size::kLabel, false, true, true})),
      headline_(new TextLabel({type_size::kValue + 4, true, false, true})),
      advice_(new TextLabel({type_size::kButton, true, false, true})),
      details_(new TextLabel({type_size::kBody, false, false, true})),
      found_(new TextLabel({type_size::kLabel, false, true, true})),
      teeth_(makeField("file-teeth", tr("Teeth"))),
      speed_(makeField("file-speed", tr("Speed, rev/min"))),
      scroll_(new QScrollArea),
      open_(toolButton(tr("OPEN A RECORDING"), tr("Choose a recording to look at"), "file-open")) {
  auto* column = new QVBoxLayout(this);
  headline_->setObjectName(QStringLiteral("file-headline"));
  advice_->setObjectName(QStringLiteral("file-advice"));
  details_->setObjectName(QStringLiteral("file-details"));
  found_->setObjectName(QStringLiteral("file-found"));
  title_->setObjectName(QStringLiteral("file-title"));
  advice_->setTone(Tone::Advice);
  // Their labels stay when they are filled.
  for (const auto& [field, share] : {std::pair(teeth_, 2), std::pair(speed_, 3)}) {
    auto* labelled = new QVBoxLayout;
    labelled->setSpacing(2);
    labelled->addWidget(new TextLabel({type_size::kLabel, false, true}, field->accessibleName()));
    labelled->addWidget(field);
    fields_->addLayout(labelled, share);
  }
  auto* words = new QWidget;
  auto* lines = new QVBoxLayout(words);
  lines->setContentsMargins(0, 0, 0, 0);
  for (QWidget* line : std::initializer_list<QWidget*>{title_, facts_, headline_, advice_, details_})
    lines->addWidget(line);
  lines->addStretch(1);
  scroll_->setWidget(words);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  column->addWidget(scroll_, 1);
  column->addLayout(fields_);
  column->addWidget(found_);
  column->addWidget(open_);
  for (QLineEdit* field : {teeth_, speed_}) connect(field, &QLineEdit::textEdited, this, &FileAnswerPanel::edited);
  connect(open_, &TouchButton::clicked, this, &FileAnswerPanel::openAsked);
}

FileQuestion FileAnswerPanel::question() const {
  FileQuestion question;
  const double teeth = typedSpeed(teeth_->text()), speed = typedSpeed(speed_->text());
  if (teeth >= 1.0 && teeth <= kMostTeeth) question.teeth = static_cast<int>(std::lround(teeth));
  if (speed > 0.0 && speed <= kHighestSpeed) question.speed = Rpm(speed);
  return question;
}

void FileAnswerPanel::setQuestion(const FileQuestion& question) {
  teeth_->setText(question.teeth > 0 ? QString::number(question.teeth) : QString());
  speed_->setText(question.speed.value > 0.0 ? QString::number(question.speed.value, 'f', 0) : QString());
}

void FileAnswerPanel::display(const Shown& shown) {
  const bool any = !shown.path.isEmpty();
  title_->setText(any ? breakable(QFileInfo(shown.path).fileName()) : tr("Your recording"));
  if (shown.file) {
    facts_->setText(factsOf(*shown.file));
  } else if (any) {
    facts_->setText(shown.reading.running ? tr("Reading, %1").arg(percent(shown.reading.part)) : QString());
  } else {
    facts_->setText(
        tr("Chatter or not, the reason, and the speed that helps. Drop a file on this window, or open one: "
           "sound of a phone, a table, a logger's file, a session."));
  }
  for (QLineEdit* field : {teeth_, speed_}) field->setEnabled(any);
  showAnswer(shown);
  showFindings(shown);
}

void FileAnswerPanel::showAnswer(const Shown& shown) {
  const QString& problem = !shown.reading.problem.isEmpty() ? shown.reading.problem : shown.judging.problem;
  const bool current = shown.answer && shown.answer->question == shown.asked;
  headline_->setTone(Tone::Normal);
  QString advice;
  QStringList details;
  if (shown.path.isEmpty()) {
    headline_->setText({});
  } else if (!problem.isEmpty() && !shown.judging.running) {
    headline_->setTone(Tone::Onset);
    headline_->setText(shown.file ? tr("Cannot be judged") : tr("Cannot be read"));
    details << problem;
  } else if (!current) {
    headline_->setText(shown.judging.running ? tr("Judging, %1").arg(percent(shown.judging.part)) : QString());
  } else {
    headline_->setTone(toneOf(shown.answer->finding));
    headline_->setText(shown.answer->headline);
    advice = shown.answer->advice;
    details = shown.answer->details;
  }
  if (shown.file && problem.isEmpty()) details << shown.file->notes;
  advice_->setText(advice);
  details_->setText(details.join(u'\n'));
}

void FileAnswerPanel::showFindings(const Shown& shown) {
  QStringList lines;
  const FileFinding& speed = shown.findings.speed_rpm;
  if (speed.value > 0.0) {
    const QString value = QStringLiteral("%1 \u00b1%2").arg(number(speed.value), number(std::max(speed.doubt, 1.0)));
    lines << (speed.rivals.empty() ? tr("In the signal: %1 rev/min").arg(value)
                                   : tr("In the signal: %1 rev/min, or %2").arg(value, listed(speed.rivals)));
  }
  const FileFinding& teeth = shown.findings.teeth;
  if (teeth.value > 0.0) {
    lines << (teeth.rivals.empty()
                  ? tr("Teeth by the signal: %1").arg(number(teeth.value))
                  : tr("Teeth by the signal: %1, or %2").arg(number(teeth.value), listed(teeth.rivals)));
  }
  found_->setText(lines.join(u'\n'));
  found_->setVisible(!lines.isEmpty());
}

void FileAnswerPanel::applyTheme(const Theme& theme) {
  Panel::applyTheme(theme);
  layout()->setContentsMargins(theme.px(14), theme.px(10), theme.px(14), theme.px(10));
  layout()->setSpacing(theme.px(8));
  fields_->setSpacing(std::max(theme.px(8), pixelsFor(kTouchGapMm, this)));
  scroll_->widget()->layout()->setSpacing(theme.px(8));
  for (QLineEdit* field : {teeth_, speed_}) {
    field->setFont(theme.font(type_size::kBody));
    field->setFixedHeight(touchHeight(theme, this));
  }
}

}  // namespace stillcut::ui
