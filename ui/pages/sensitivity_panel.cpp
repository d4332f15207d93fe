#include "ui/pages/sensitivity_panel.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/base/say.h"
#include "ui/models/live_numbers.h"
#include "ui/models/tune/param_scale.h"
#include "ui/plots/indicator_strip.h"
#include "ui/widgets/painting.h"
#include "ui/widgets/text_label.h"
#include "ui/widgets/touch_button.h"

namespace stillcut::ui {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double indicatorOf(const TunableComponent& detector, const Verdict& verdict, const QString& name) {
  const qsizetype place = detector.indicators.indexOf(name);
  return verdict.valid && verdict.state != CutState::AirCutting && place >= 0 && place < kMaxIndicators
             ? verdict.indicators[static_cast<std::size_t>(place)]
             : kUnknown;
}

}  // namespace

SensitivityPanel::SensitivityPanel(QWidget* parent)
    : Panel(parent),
      line_(new QHBoxLayout),
      less_(new TouchButton(tr("LESS SENSITIVE"))),
      more_(new TouchButton(tr("MORE SENSITIVE"))),
      title_(new TextLabel({type_size::kValue, true, false, true})),
      now_(new TextLabel({type_size::kValue, true, false, true})),
      trial_(new TextLabel({type_size::kBody, false, false, true})),
      strips_{new IndicatorStrip, new IndicatorStrip} {
  auto* column = new QVBoxLayout(this);
  less_->setObjectName(QStringLiteral("sensitivity-less"));
  more_->setObjectName(QStringLiteral("sensitivity-more"));
  now_->setObjectName(QStringLiteral("sensitivity-now"));
  now_->setAlignment(Qt::AlignCenter);
  trial_->setObjectName(QStringLiteral("sensitivity-trial"));
  column->addWidget(title_);
  for (IndicatorStrip* strip : strips_) column->addWidget(strip, 1);
  line_->addWidget(less_);
  line_->addWidget(now_, 1);
  line_->addWidget(more_);
  column->addLayout(line_);
  column->addWidget(trial_);
  connect(less_, &TouchButton::clicked, this, [this] { step(-1); });
  connect(more_, &TouchButton::clicked, this, [this] { step(1); });
}

void SensitivityPanel::work(Tuning* tuning, const TunableComponent* detector) {
  tuning_ = tuning;
  detector_ = detector;
  sensitivity_ = detector != nullptr ? Sensitivity(*detector) : Sensitivity();
  own_.clear();
  for (IndicatorStrip* strip : strips_) strip->clear();
  title_->setText(detector == nullptr ? QString()
                                      : tr("When it alarms: %1").arg(sayCore(detector->label.toStdString())));
  refresh();
}

void SensitivityPanel::refresh() {
  const bool any = tuning_ != nullptr && sensitivity_.known();
  const auto now =
      any ? sensitivity_.stepOf([this](const config::ParamDecl& decl) { return tuning_->controller().value(decl); })
          : std::nullopt;
  now_->setText(any ? sensitivityText(now) : QString());
  less_->setEnabled(any && now.value_or(0) > -Sensitivity::kMost);
  more_->setEnabled(any && now.value_or(0) < Sensitivity::kMost);
}

// From where somebody has set single limits by hand it begins at what is delivered.
void SensitivityPanel::step(int by) {
  if (tuning_ == nullptr || !sensitivity_.known()) return;
  TuningController& controller = tuning_->controller();
  const auto now = sensitivity_.stepOf([&](const config::ParamDecl& decl) { return controller.value(decl); });
  const int next = std::clamp(now.value_or(0) + by, -Sensitivity::kMost, Sensitivity::kMost);
  const Sensitivity::Values values = sensitivity_.at(next);
  controller.setTogether(values, sensitivityText(next));
  QStringList settings;
  for (const auto& [decl, value] : values) {
    settings << QStringLiteral("%1=%2").arg(
        QString::fromUtf8(decl->key.data(), static_cast<qsizetype>(decl->key.size())), valueText(*decl, value));
  }
  tuning_->tryOnRecordings(detector_->id, settings);
}

// What the detector has made of the limit goes before what was set: a channel may be loud in the calm cut.
double SensitivityPanel::limitOf(const char* own, const char* parameter) const {
  const std::string id = detector_->id.toStdString();
  const auto found = own_.find(id + own);
  if (found != own_.end() && std::isfinite(found->second)) return found->second;
  for (const config::ParamDecl* decl : detector_->params) {
    if (decl->key == id + parameter) return tuning_->controller().value(*decl);
  }
  return kUnknown;
}

void SensitivityPanel::see(const Picture& picture) {
  if (detector_ == nullptr || tuning_ == nullptr || picture.snapshot == nullptr) return;
  const Snapshot& s = *picture.snapshot;
  const int index = detector_->detector >= 0 ? detector_->detector : s.inCharge;
  if (index >= s.detectorCount) return;
  const Verdict& verdict = s.verdicts[static_cast<std::size_t>(index)];
  for (const AutoReading& reading : tuning_->ownNow(*detector_)) own_[std::string(reading.key)] = reading.value;
  const bool judged = verdict.valid && verdict.state != CutState::AirCutting;
  const double full = judged ? verdict.severity.value : kUnknown;
  strips_[0]->add({s.time, full, limitOf(".full", ".chatter"), verdict.state});
  const bool grows = detector_->indicators.contains(QStringLiteral("evidence"));
  strips_[1]->setVisible(grows);
  if (!grows) return;
  strips_[1]->add(
      {s.time, indicatorOf(*detector_, verdict, QStringLiteral("evidence")), limitOf("", ".evidence"), verdict.state});
}

void SensitivityPanel::display(const Picture& picture) {
  const qint64 wall = picture.info->wallMsAtStreamZero;
  strips_[0]->display(tr("ENERGY RATIO: full chatter from the limit on"), wall);
  strips_[1]->display(tr("EVIDENCE OF GROWTH: an onset from the limit on"), wall);
  if (tuning_ != nullptr) trial_->setText(trialText(tuning_->trial()));
}

void SensitivityPanel::applyTheme(const Theme& theme) {
  Panel::applyTheme(theme);
  layout()->setContentsMargins(theme.px(14), theme.px(10), theme.px(14), theme.px(10));
  layout()->setSpacing(theme.px(8));
  line_->setSpacing(std::max(theme.px(12), pixelsFor(kTouchGapMm, this)));
}

}  // namespace stillcut::ui
