#include "ui/models/sensor_view.h"

#include <algorithm>

#include "ui/base/format.h"
#include "ui/base/reason_text.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

// A rate off by more than its doubt and by more than this is worth more digits.
constexpr double kRateDigits = 1e-4;

bool aboutInput(ReasonCode code) {
  return code >= ReasonCode::InputGap && code <= ReasonCode::InputAliased;
}

QString unitOf(const ChannelInfo& channel) {
  const std::string_view unit = siUnit(channel.quantity);
  return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

QString rateText(const SensorStatus& sensors) {
  if (sensors.nominalRate.value <= 0.0) return {};
  const QString told = join(number(sensors.nominalRate.value), QStringLiteral("Hz"));
  QString text;
  if (sensors.actualRate.value <= 0.0) {
    text = say("%1 told, not measured yet").arg(told);
  } else {
    const double doubt = std::max(sensors.actualRateSd.value, sensors.nominalRate.value * kRateDigits * 0.1);
    text = say("%1 told, %2 measured").arg(told, frequency(sensors.actualRate, Hertz(doubt)));
  }
  return sensors.lostFrames == 0
             ? text
             : say("%1, %2 samples lost").arg(text, number(static_cast<double>(sensors.lostFrames)));
}

}  // namespace

SensorView makeSensorView(const Picture& picture) {
  SensorView view;
  if (picture.paused) {
    view.headline = say("The replay is paused");
    return view;
  }
  if (picture.snapshot == nullptr || picture.stale) {
    view.headline = say("No samples come");
    return view;
  }
  const SensorStatus& sensors = picture.snapshot->sensors;
  const auto& channels = picture.info->setup.channels;
  const int known = std::min(sensors.channels, static_cast<int>(channels.size()));
  for (int c = 0; c < known; ++c) {
    const ChannelInfo& channel = channels[static_cast<std::size_t>(c)];
    const ChannelStatus& status = sensors.channel[static_cast<std::size_t>(c)];
    const QString name = QString::fromStdString(channel.name), unit = unitOf(channel);
    view.channels
        << say("%1: %2, peak %3").arg(name, join(significant(status.rms), unit), join(significant(status.peak), unit));
    if (status.fault.code != ReasonCode::None) view.findings << reasonText(status.fault);
  }
  view.rate = rateText(sensors);
  const Reason& verdictSays = picture.verdict().reason;
  const Reason fault = sensors.fault.code != ReasonCode::None ? sensors.fault
                       : aboutInput(verdictSays.code)         ? verdictSays
                                                              : Reason{};
  view.sick = fault.code != ReasonCode::None || !view.findings.empty();
  view.headline =
      fault.code != ReasonCode::None ? reasonText(fault)
      : view.sick                    ? view.findings.front()
      : known > 1
          ? say("All sensors in order")
          : say("Sensor in order: %1")
                .arg(channels.empty() ? QString()
                                      : join(significant(picture.snapshot->vibrationRms), unitOf(channels.front())));
  view.findings.removeAll(view.headline);
  return view;
}

}  // namespace stillcut::ui
