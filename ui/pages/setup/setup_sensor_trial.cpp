#include "ui/pages/setup/setup_sensor_trial.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/facade/setup_controller.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {

using State = SensorTrial::State;

SetupSensorTrial::SetupSensorTrial(SetupController& controller, SetupDraft& draft, std::function<int()> chosen,
                                   QWidget* parent)
    : SetupTab(controller, draft, parent),
      chosen_(std::move(chosen)),
      level_(makeEdit(tr("Level of the calibrator, as 94 dB, 1 g or 10"), QStringLiteral("calibrator-level"))),
      frequency_(makeEdit(tr("Frequency of the calibrator in Hz"), QStringLiteral("calibrator-frequency"))),
      calibrate_(makeButton(tr("CALIBRATE"), tr("Hear the calibrator on the chosen channel"),
                            QStringLiteral("calibrator-begin"))),
      knock_(makeButton(tr("KNOCK"), tr("Hear knocks along the axis of the chosen channel"),
                        QStringLiteral("knock-begin"))),
      said_(new TextLabel({type_size::kBody, false, false, true})) {
  auto* column = new QVBoxLayout(this);
  auto* tone = new QHBoxLayout;
  tone->addWidget(new TextLabel(TextLabel::Look{type_size::kBody}, tr("Calibrator")));
  tone->addWidget(level_, 2);
  tone->addWidget(frequency_, 2);
  tone->addWidget(new TextLabel(TextLabel::Look{type_size::kBody}, QStringLiteral("Hz")));
  tone->addWidget(calibrate_);
  column->addLayout(tone);
  auto* axis = new QHBoxLayout;
  axis->addWidget(new TextLabel(TextLabel::Look{type_size::kBody, false, false, true},
                                tr("Is it this sensor that lies along its axis?")),
                  1);
  axis->addWidget(knock_);
  column->addLayout(axis);
  column->addWidget(said_);
  level_->setText(QStringLiteral("94 dB"));
  frequency_->setText(QStringLiteral("1000"));
  connect(calibrate_, &TouchButton::clicked, this, &SetupSensorTrial::calibrate);
  connect(knock_, &TouchButton::clicked, this, &SetupSensorTrial::knock);
  refresh();
}

int SetupSensorTrial::channel() const {
  return std::max(0, chosen_());
}

void SetupSensorTrial::calibrate() {
  bool isNumber = false;
  const double hertz = frequency_->text().replace(u',', u'.').toDouble(&isNumber);
  if (!isNumber || !std::isfinite(hertz) || hertz <= 0.0) {
    said_->setTone(Tone::Onset);
    said_->setText(tr("The frequency is no number above 0."));
    said_->setVisible(true);
    return;
  }
  meanwhile_ = tr("Listening to the calibrator");
  controller_.calibrate(draft_.profile(), draft_.name(), channel(), level_->text().trimmed(), Hertz(hertz));
  refresh();
}

void SetupSensorTrial::knock() {
  const auto& channels = draft_.profile().cut.channels;
  const auto at = static_cast<std::size_t>(channel());
  const QString axis = at < channels.size() ? QString::fromStdString(channels[at].axis) : QString();
  meanwhile_ = axis.isEmpty() ? tr("Knock along the axis now, a few times")
                              : tr("Knock along %1 now, a few times, near the sensor").arg(axis);
  controller_.knock(draft_.profile(), draft_.name(), channel());
  refresh();
}

void SetupSensorTrial::take(const SensorTrial& trial) {
  const std::size_t known = draft_.profile().cut.channels.size();
  draft_.edit([&](config::Profile& profile) {
    for (const auto& [channel, found] : trial.found) {
      const auto at = static_cast<std::size_t>(channel);
      if (at < known) profile.cut.channels[at] = found;
    }
  });
}

void SetupSensorTrial::refresh() {
  const SensorTrial& trial = controller_.sensorTrial();
  const bool news = std::exchange(seen_, trial.state) != trial.state;
  const bool free = !draft_.profile().source.id.empty() && trial.state != State::Runs;
  calibrate_->setEnabled(free);
  knock_->setEnabled(free);
  said_->setTone(trial.state == State::Bad ? Tone::Onset : Tone::Normal);
  if (trial.state == State::Runs) said_->setText(meanwhile_);
  if (trial.state == State::Good || trial.state == State::Bad) said_->setText(trial.said);
  said_->setVisible(!said_->text().isEmpty());
  if (news && trial.state == State::Good && !trial.found.empty()) take(trial);
}

void SetupSensorTrial::applyTheme(const Theme& theme) {
  SetupTab::applyTheme(theme);
  layout()->setContentsMargins(0, 0, 0, 0);  // rows of another tab
}

}  // namespace stillcut::ui
