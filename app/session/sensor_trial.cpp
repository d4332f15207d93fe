#include "app/session/sensor_trial.h"

#include "app/compose/measure_samples.h"
#include "core/daq/axis_knock.h"
#include "core/daq/calibrator.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

constexpr Seconds kTone{4.0};
constexpr Seconds kKnocks{8.0};

ui::SensorTrial failed(const Error& error) {
  return {ui::SensorTrial::State::Bad, ui::sayError(error), {}};
}

}  // namespace

ui::SensorTrial calibrateChannel(const config::Profile& profile, const std::string& path, int channel,
                                 const std::string& level, Hertz frequency, const std::atomic<bool>& ended) {
  SetUpFault fault = SetUpFault::Input;
  const auto heard = measureDevice(profile, path, channel, kTone, fault, &ended);
  if (!heard) return failed(heard.error());
  const auto at = static_cast<std::size_t>(channel);
  const auto rms = daq::levelFrom(level, heard->channels[at].quantity);
  if (!rms) return failed(rms.error());
  const auto found = daq::calibrate(heard->samples[at], heard->rate, {frequency, *rms});
  if (!found) return failed(found.error());
  ChannelInfo now = heard->channels[at];
  daq::applyCalibration(*found, now);
  const QString said =
      QCoreApplication::translate("Trial", "%1: a tone of %2 Hz, %3 % of what is heard; scale %4 ± %5 %6")
          .arg(QString::fromStdString(now.name))
          .arg(found->frequency.value, 0, 'f', 1)
          .arg(100.0 * found->pure, 0, 'f', 1)
          .arg(now.scale, 0, 'g', 5)
          .arg(found->scaleSd, 0, 'g', 2)
          .arg(QString::fromUtf8(siUnit(now.quantity).data()));
  return {ui::SensorTrial::State::Good, said, {{channel, now}}};
}

ui::SensorTrial knockAlong(const config::Profile& profile, const std::string& path, int channel,
                           const std::atomic<bool>& ended) {
  SetUpFault fault = SetUpFault::Input;
  const auto heard = measureDevice(profile, path, channel, kKnocks, fault, &ended);
  if (!heard) return failed(heard.error());
  const auto knocks =
      daq::analyseKnocks(heard->samples, heard->rate, heard->channels, static_cast<std::size_t>(channel));
  if (!knocks) return failed(knocks.error());
  ui::SensorTrial trial{ui::SensorTrial::State::Good, ui::sayCore(daq::knockSentence(*knocks, heard->channels)), {}};
  if (knocks->loudest == knocks->told) return trial;
  std::vector<ChannelInfo> now = heard->channels;
  daq::applyKnocks(*knocks, now);
  for (const std::size_t c : {knocks->told, knocks->loudest}) trial.found.emplace_back(static_cast<int>(c), now[c]);
  return trial;
}

}  // namespace stillcut::app
