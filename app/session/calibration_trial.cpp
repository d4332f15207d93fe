#include "app/session/calibration_trial.h"

#include "app/compose/tone_samples.h"
#include "core/daq/calibrator.h"

namespace stillcut::app {
namespace {

constexpr Seconds kLength{4.0};

ui::CalibrationTrial failed(int channel, const Error& error) {
  return {ui::CalibrationTrial::State::Bad, channel, QString::fromStdString(error.line()), {}};
}

}  // namespace

ui::CalibrationTrial calibrateChannel(const config::Profile& profile, const std::string& path, int channel,
                                      const std::string& level, Hertz frequency) {
  SetUpFault fault = SetUpFault::Input;
  const auto heard = listenToTone(profile, path, channel, kLength, fault);
  if (!heard) return failed(channel, heard.error());
  const auto rms = daq::levelFrom(level, heard->channel.quantity);
  if (!rms) return failed(channel, rms.error());
  const auto found = daq::calibrate(heard->samples, heard->rate, {frequency, *rms});
  if (!found) return failed(channel, found.error());
  ChannelInfo now = heard->channel;
  daq::applyCalibration(*found, now);
  const QString said = QStringLiteral("%1: a tone of %2 Hz, %3 % of what is heard; scale %4 ± %5 %6")
                           .arg(QString::fromStdString(now.name))
                           .arg(found->frequency.value, 0, 'f', 1)
                           .arg(100.0 * found->pure, 0, 'f', 1)
                           .arg(now.scale, 0, 'g', 5)
                           .arg(found->scaleSd, 0, 'g', 2)
                           .arg(QString::fromUtf8(siUnit(now.quantity).data()));
  return {ui::CalibrationTrial::State::Good, channel, said, now};
}

}  // namespace stillcut::app
