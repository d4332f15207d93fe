#include "ui/pages/file/timing_fields.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "ui/base/typed_number.h"
#include "ui/pages/tool_button.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"

namespace stillcut::ui {
namespace {

constexpr double kHighestRate = 1e7;  // [Hz]

struct Unit {
  const char* symbol;
  double seconds;
  const char* name;  // that tests find its button by
};
constexpr auto kUnits = std::to_array<Unit>({{"s", 1.0, "file-time-s"},
                                             {"ms", 1e-3, "file-time-ms"},
                                             {"\u00b5s", 1e-6, "file-time-us"},
                                             {"ns", 1e-9, "file-time-ns"}});

}  // namespace

TimingFields::TimingFields(QWidget* parent)
    : QWidget(parent),
      question_(new TextLabel({type_size::kLabel, false, true, true})),
      rate_(new QLineEdit),
      read_(toolButton(tr("READ"), tr("Read the recording with so many samples a second"), "file-rate-read")),
      row_(new QHBoxLayout) {
  auto* lines = new QVBoxLayout(this);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->addWidget(question_);
  lines->addLayout(row_);
  question_->setObjectName(QStringLiteral("file-timing-question"));
  rate_->setObjectName(QStringLiteral("file-rate"));
  rate_->setAccessibleName(tr("Samples a second"));
  rate_->setInputMethodHints(Qt::ImhFormattedNumbersOnly);
  for (const Unit& unit : kUnits) {
    const QString symbol = QString::fromUtf8(unit.symbol);
    TouchButton* button = toolButton(symbol, tr("Its times are in %1").arg(symbol), unit.name);
    connect(button, &TouchButton::clicked, this, [this, &unit] { emit told({Hertz(), unit.seconds}); });
    units_.push_back(button);
    row_->addWidget(button);
  }
  row_->addWidget(rate_, 1);
  row_->addWidget(read_);
  connect(rate_, &QLineEdit::returnPressed, this, &TimingFields::tellRate);
  connect(read_, &TouchButton::clicked, this, &TimingFields::tellRate);
  display(FileLack::None);
}

void TimingFields::tellRate() {
  const double rate = typedSpeed(rate_->text());
  if (rate > 0.0 && rate <= kHighestRate) emit told({Hertz(rate), 0.0});
}

void TimingFields::display(FileLack lack) {
  setVisible(lack != FileLack::None);
  const bool unit = lack == FileLack::TimeUnit;
  question_->setText(unit ? tr("In what are its times?") : tr("Samples a second, Hz"));
  for (TouchButton* button : units_) button->setVisible(unit);
  rate_->setVisible(!unit);
  read_->setVisible(!unit);
}

void TimingFields::applyTheme(const Theme& theme) {
  row_->setSpacing(std::max(theme.px(8), pixelsFor(kTouchGapMm, this)));
  rate_->setFont(theme.font(type_size::kBody));
  rate_->setFixedHeight(touchHeight(theme, this));
}

}  // namespace stillcut::ui
