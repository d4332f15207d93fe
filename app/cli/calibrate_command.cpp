// stillcut-cli calibrate [RECORDING] --level LEVEL: a calibrator's tone gives the sensitivity of a channel, from a
// recording of it or straight from a profile's device, whose channel is then set right.

#include <cmath>
#include <cstdio>

#include "app/cli/command.h"
#include "app/cli/measurement_options.h"
#include "app/cli/reading_options.h"
#include "core/daq/calibrator.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {
namespace {

struct CalibrateOptions : MeasurementOptions {
  std::string level;
  double frequency = 1000.0;
  ReadingOptions reading;
};

void print(const daq::Calibration& found, const ChannelInfo& before, const ChannelInfo& now) {
  std::printf("%s: a tone of %.2f Hz, %.6g rms of the input, %.1f %% of the signal\n", before.name.c_str(),
              found.frequency.value, found.rms, 100.0 * found.pure);
  std::printf("scale %.6g +- %.2g %s per unit of the input", now.scale, found.scaleSd,
              std::string(siUnit(now.quantity)).c_str());
  if (now.sensitivity > 0.0) std::printf("; %.6g mV per unit of the data sheet", now.sensitivity);
  std::printf(" (was %.6g: %+.2f %%)\n", before.scale, 100.0 * (now.scale / before.scale - 1.0));
}

int save(config::Profile profile, const config::ParamCatalog& catalog, const CalibrateOptions& o, int which,
         const ChannelInfo& now) {
  const auto channel = static_cast<std::size_t>(which);
  if (channel >= profile.cut.channels.size()) return failWithoutChannels(o);
  profile.cut.channels[channel] = now;
  return saveProfileOf(o, profile, catalog);
}

int run(const CalibrateOptions& o) {
  if (const Status usable = checkMeasurementOptions(o, "calibrate", "tone", "whose sensor is on the calibrator");
      !usable)
    return fail(usable.error());
  const auto reading = o.reading.understand();
  if (!reading) return fail(reading.error());
  if (reading->channels.size() > 1)
    return fail(Error{"--channel", message("one at a time"), message("the calibrator is on one sensor")});
  const int channel = reading->channels.empty() ? 0 : reading->channels.front();
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  auto profile = profileOf(o, catalog);
  if (!profile) return fail(profile.error());
  SetUpFault fault = SetUpFault::Input;
  const auto heard = measure(o, *profile, *reading, channel, fault);
  if (!heard) return fail(heard.error(), fault == SetUpFault::Hardware ? kExitDevice : kExitInput);
  const auto at =
      static_cast<std::size_t>(o.profile.empty() ? 0 : channel);  // a recording: the chosen one alone is read
  const ChannelInfo& before = heard->channels[at];
  const auto level = daq::levelFrom(o.level, before.quantity);
  if (!level) return fail(level.error());
  const auto found = daq::calibrate(heard->samples[at], heard->rate, {Hertz(o.frequency), *level});
  if (!found) return fail(found.error());
  ChannelInfo now = before;
  daq::applyCalibration(*found, now);
  print(*found, before, now);
  return o.save ? save(std::move(profile).value(), catalog, o, channel, now) : kExitDone;
}

}  // namespace

void addCalibrate(CLI::App& app, int& exitCode) {
  auto o = std::make_shared<CalibrateOptions>();
  CLI::App* command = app.add_subcommand("calibrate", "Find a sensor's sensitivity with a calibrator's tone");
  addMeasurementOptions(*command, *o, "the tone");
  command->add_option("--level", o->level, "Level of the calibrator, rms: \"94 dB\", \"1 g\", 10")->required();
  command->add_option("--frequency", o->frequency, "Its frequency [Hz]")->capture_default_str();
  command->add_flag("--save", o->save, "Set the channel of the profile right");
  o->reading.add(*command);
  command->callback([o, &exitCode] { exitCode = run(*o); });
}

}  // namespace stillcut::app
