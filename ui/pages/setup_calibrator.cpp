#include "ui/pages/setup_calibrator.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/models/setup_desk.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {

using State = CalibrationTrial::State;

SetupCalibrator::SetupCalibrator(SetupDesk& desk, SetupDraft& draft, std::function<int()> chosen, QWidget* parent)
    : SetupTab(desk, draft, parent),
      chosen_(std::move(chosen)),
      level_(makeEdit(tr("Level of the calibrator, as 94 dB, 1 g or 10"), QStringLiteral("calibrator-level"))),
      frequency_(makeEdit(tr("Frequency of the calibrator in Hz"), QStringLiteral("calibrator-frequency"))),
      begin_(makeButton(tr("CALIBRATE"), tr("Hear the calibrator on the chosen channel"),
                        QStringLiteral("calibrator-begin"))),
      said_(new TextLabel({type_size::kBody, false, false, true})) {
  auto* column = new QVBoxLayout(this);
  auto* line = new QHBoxLayout;
  line->addWidget(new TextLabel(TextLabel::Look{type_size::kBody}, tr("Calibrator")));
  line->addWidget(level_, 2);
  line->addWidget(frequency_, 2);
  line->addWidget(new TextLabel(TextLabel::Look{type_size::kBody}, QStringLiteral("Hz")));
  line->addWidget(begin_);
  column->addLayout(line);
  column->addWidget(said_);
  level_->setText(QStringLiteral("94 dB"));
  frequency_->setText(QStringLiteral("1000"));
  connect(begin_, &TouchButton::clicked, this, &SetupCalibrator::begin);
  refresh();
}

void SetupCalibrator::begin() {
  bool isNumber = false;
  const double hertz = frequency_->text().replace(u',', u'.').toDouble(&isNumber);
  if (!isNumber || !std::isfinite(hertz) || hertz <= 0.0) {
    said_->setTone(Tone::Onset);
    said_->setText(tr("The frequency is no number above 0."));
    said_->setVisible(true);
    return;
  }
  desk_.calibrate(draft_.profile(), draft_.name(), std::max(0, chosen_()), level_->text().trimmed(), Hertz(hertz));
  refresh();
}

void SetupCalibrator::take(const CalibrationTrial& trial) {
  const auto channel = static_cast<std::size_t>(std::max(0, trial.channel));
  if (channel >= draft_.profile().cut.channels.size()) return;
  draft_.edit([&](config::Profile& profile) { profile.cut.channels[channel] = trial.found; });
}

void SetupCalibrator::refresh() {
  const CalibrationTrial& trial = desk_.calibration();
  const bool news = std::exchange(seen_, trial.state) != trial.state;
  begin_->setEnabled(!draft_.profile().source.id.empty() && trial.state != State::Runs);
  said_->setTone(trial.state == State::Bad ? Tone::Onset : Tone::Normal);
  if (trial.state == State::Runs) said_->setText(tr("Listening to the calibrator"));
  if (trial.state == State::Good || trial.state == State::Bad) said_->setText(trial.said);
  said_->setVisible(!said_->text().isEmpty());
  if (news && trial.state == State::Good) take(trial);
}

void SetupCalibrator::applyTheme(const Theme& theme) {
  SetupTab::applyTheme(theme);
  layout()->setContentsMargins(0, 0, 0, 0);  // a row of another tab
}

}  // namespace stillcut::ui
