#include "ui/widgets/transport_bar.h"

#include <QHBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/models/session_models.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/tool_button.h"
#include "ui/widgets/value_slider.h"

namespace stillcut::ui {
namespace {

constexpr double kSlowest = 0.1, kFastest = 1000.0;  // as daq::ReplayControl has them
constexpr double kUnpaced = 0.985;                   // of the slider: from here on as fast as possible
constexpr double kPaceStep = 0.04;

TouchButton* makeButton(const QString& caption, const QString& spoken, const char* name, const QKeySequence& key) {
  TouchButton* button = makeToolButton(caption, spoken, name);
  button->setKey(key);
  button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  return button;
}

}  // namespace

TransportBar::TransportBar(QWidget* parent)
    : QWidget(parent),
      start_(makeButton(QStringLiteral("|◀"), tr("To the beginning"), "replay-start", Qt::CTRL | Qt::Key_Home)),
      back_(makeButton(QStringLiteral("◀"), tr("A block back"), "replay-back", Qt::CTRL | Qt::Key_Left)),
      play_(makeButton(tr("PLAY"), tr("Play or pause"), "replay-play", Qt::CTRL | Qt::Key_Space)),
      step_(makeButton(QStringLiteral("▶"), tr("A block on"), "replay-step", Qt::CTRL | Qt::Key_Right)),
      loop_(makeButton(tr("LOOP"), tr("Repeat the selected span"), "replay-loop", Qt::CTRL | Qt::Key_L)),
      pace_(new ValueSlider),
      time_(new TextLabel({type_size::kValue, true})),
      times_(new TextLabel({type_size::kBody})) {
  // Their signs are narrow; the room belongs to the pace.
  for (TouchButton* button : {start_, back_, step_}) {
    button->setToolTip(button->hint());
    button->setHint({});
  }
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  loop_->setCheckable(true);
  pace_->setObjectName(QStringLiteral("replay-pace"));
  pace_->setAccessibleName(tr("Pace of the replay"));
  line->addWidget(start_);
  line->addWidget(back_);
  line->addWidget(play_);
  line->addWidget(step_);
  line->addWidget(time_);
  line->addWidget(pace_, 1);
  line->addWidget(times_);
  line->addWidget(loop_);
  connect(start_, &TouchButton::clicked, this, &TransportBar::toStartAsked);
  connect(back_, &TouchButton::clicked, this, [this] { emit stepAsked(-1); });
  connect(step_, &TouchButton::clicked, this, [this] { emit stepAsked(1); });
  connect(play_, &TouchButton::clicked, this, [this] {
    if (playing_) {
      emit pauseAsked();
    } else {
      emit playAsked();
    }
  });
  connect(loop_, &TouchButton::clicked, this, [this] { emit loopAsked(loop_->isChecked()); });
  connect(pace_, &ValueSlider::moved, this, &TransportBar::movePace);
  connect(pace_, &ValueSlider::stepped, this,
          [this](int direction) { movePace(std::clamp(fractionOfPace(asked_) + direction * kPaceStep, 0.0, 1.0)); });
  display({});
}

double TransportBar::paceAt(double fraction) {
  if (fraction >= kUnpaced) return 0.0;
  const double pace = kSlowest * std::pow(kFastest / kSlowest, std::clamp(fraction / kUnpaced, 0.0, 1.0));
  if (std::abs(std::log10(pace)) < 0.06) return 1.0;  // real time is easy to hit
  const double unit = std::pow(10.0, std::floor(std::log10(pace)) - 1.0);
  return std::clamp(std::round(pace / unit) * unit, kSlowest, kFastest);
}

double TransportBar::fractionOfPace(double pace) {
  if (!(pace > 0.0)) return 1.0;
  return kUnpaced * std::log(std::clamp(pace, kSlowest, kFastest) / kSlowest) / std::log(kFastest / kSlowest);
}

void TransportBar::movePace(double fraction) {
  asked_ = paceAt(fraction);
  emit paceAsked(asked_);
}

void TransportBar::display(const ReplayState& state) {
  playing_ = state.playing;
  play_->setText(state.playing ? tr("PAUSE") : tr("PLAY"));
  for (TouchButton* button : {start_, back_, play_, step_, loop_}) button->setEnabled(state.open);
  pace_->setEnabled(state.open);
  loop_->setChecked(state.looping);
  asked_ = state.pace;
  pace_->display(fractionOfPace(state.pace), fractionOfPace(1.0), false);
  times_->setText(state.pace > 0.0 ? tr("%1 x").arg(significant(state.pace)) : tr("fastest"));
  time_->setText(state.open ? tr("%1 of %2").arg(timeText(state.position), timeText(state.length)) : QString());
}

void TransportBar::applyTheme(const Theme& theme) {
  layout()->setSpacing(theme.px(12));
  times_->setFixedWidth(theme.px(84));
}

}  // namespace stillcut::ui
