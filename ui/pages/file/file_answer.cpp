#include "ui/pages/file/file_answer.h"

#include <QDateTime>
#include <QFileInfo>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/format.h"
#include "ui/pages/file/question_fields.h"
#include "ui/pages/file/timing_fields.h"
#include "ui/pages/tool_button.h"
#include "ui/widgets/text_label.h"

namespace stillcut::ui {
namespace {

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

struct Words {
  Tone tone = Tone::Normal;
  QString headline, advice;
  QStringList details;
};

Words wordsOf(const FileAnswerPanel::Shown& shown) {
  const QString& problem = !shown.reading.problem.isEmpty() ? shown.reading.problem : shown.judging.problem;
  const bool current = shown.answer && shown.answer->question == shown.asked;
  Words words;
  if (shown.path.isEmpty()) return words;
  if (!problem.isEmpty() && !shown.judging.running) {
    words.tone = Tone::Onset;
    words.headline = shown.file ? FileAnswerPanel::tr("Cannot be judged") : FileAnswerPanel::tr("Cannot be read");
    words.details << problem;
  } else if (!current) {
    if (shown.judging.running) words.headline = FileAnswerPanel::tr("Judging, %1").arg(percent(shown.judging.part));
  } else {
    words.tone = toneOf(shown.answer->finding);
    words.headline = shown.answer->headline;
    words.advice = shown.answer->advice;
    words.details = shown.answer->details;
  }
  if (shown.file && problem.isEmpty()) words.details << shown.file->notes;
  return words;
}

}  // namespace

FileAnswerPanel::FileAnswerPanel(QWidget* parent)
    : Panel(parent),
      title_(new TextLabel({type_size::kValue, true, false, true})),
      facts_(new TextLabel({type_size::kLabel, false, true, true})),
      headline_(new TextLabel({type_size::kValue + 4, true, false, true})),
      advice_(new TextLabel({type_size::kButton, true, false, true})),
      details_(new TextLabel({type_size::kBody, false, false, true})),
      found_(new TextLabel({type_size::kLabel, false, true, true})),
      fields_(new QuestionFields(QStringLiteral("file"))),
      besideFields_(new QuestionFields(QStringLiteral("file-beside"))),
      timing_(new TimingFields),
      beside_(new QWidget),
      besideTitle_(new TextLabel({type_size::kBody, true, false, true})),
      besideHeadline_(new TextLabel({type_size::kButton, true, false, true})),
      besideLevel_(new TextLabel({type_size::kLabel, false, true, true})),
      scroll_(new QScrollArea),
      open_(toolButton(tr("OPEN A RECORDING"), tr("Choose a recording to look at"), "file-open")) {
  auto* column = new QVBoxLayout(this);
  headline_->setObjectName(QStringLiteral("file-headline"));
  advice_->setObjectName(QStringLiteral("file-advice"));
  details_->setObjectName(QStringLiteral("file-details"));
  found_->setObjectName(QStringLiteral("file-found"));
  title_->setObjectName(QStringLiteral("file-title"));
  advice_->setTone(Tone::Advice);
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
  column->addWidget(timing_);
  column->addWidget(fields_);
  column->addWidget(found_);
  makeBeside();
  column->addWidget(beside_);
  column->addWidget(open_);
  connect(fields_, &QuestionFields::edited, this, [this] { emit edited(FileController::Main); });
  connect(besideFields_, &QuestionFields::edited, this, [this] { emit edited(FileController::Beside); });
  connect(timing_, &TimingFields::told, this, &FileAnswerPanel::timingTold);
  connect(open_, &TouchButton::clicked, this, &FileAnswerPanel::openAsked);
}

void FileAnswerPanel::makeBeside() {
  besideTitle_->setObjectName(QStringLiteral("file-beside-title"));
  besideHeadline_->setObjectName(QStringLiteral("file-beside-headline"));
  besideLevel_->setObjectName(QStringLiteral("file-beside-level"));
  auto* lines = new QVBoxLayout(beside_);
  lines->setContentsMargins(0, 0, 0, 0);
  for (QWidget* line : std::initializer_list<QWidget*>{besideTitle_, besideHeadline_, besideLevel_, besideFields_})
    lines->addWidget(line);
  beside_->hide();
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
  fields_->setEnabled(any);
  fields_->setVisible(shown.lack == FileLack::None);
  timing_->display(shown.lack);
  const Words words = wordsOf(shown);
  headline_->setTone(words.tone);
  headline_->setText(words.headline);
  advice_->setText(words.advice);
  details_->setText(words.details.join(u'\n'));
  showFindings(shown);
}

void FileAnswerPanel::displayBeside(const Shown& shown, std::optional<double> louder_dB) {
  beside_->setVisible(!shown.path.isEmpty());
  if (shown.path.isEmpty()) return;
  const Words words = wordsOf(shown);
  besideTitle_->setText(tr("Compared with %1").arg(breakable(QFileInfo(shown.path).fileName())));
  besideHeadline_->setTone(words.tone);
  besideHeadline_->setText(words.headline);
  QString level;
  if (louder_dB) {
    const QString by = join(number(std::abs(*louder_dB), 0), QStringLiteral("dB"));
    level = std::abs(*louder_dB) < 0.5 ? tr("As loud in the cut as the first, if both were recorded alike")
            : *louder_dB > 0.0         ? tr("%1 louder in the cut than the first, if both were recorded alike").arg(by)
                               : tr("%1 quieter in the cut than the first, if both were recorded alike").arg(by);
  }
  besideLevel_->setText(level);
  besideLevel_->setVisible(!level.isEmpty());
}

void FileAnswerPanel::showFindings(const Shown& shown) {
  QStringList lines;
  const FileFinding& speed = shown.findings.speed_rpm;
  if (speed.value > 0.0) {
    const QString value = QStringLiteral("%1 \u00b1%2").arg(number(speed.value), number(std::max(speed.doubt, 1.0)));
    lines << (speed.rivals.empty() ? tr("In the signal: %1 rpm").arg(value)
                                   : tr("In the signal: %1 rpm, or %2").arg(value, listed(speed.rivals)));
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
  scroll_->widget()->layout()->setSpacing(theme.px(8));
  beside_->layout()->setSpacing(theme.px(4));
}

}  // namespace stillcut::ui
