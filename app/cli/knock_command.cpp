// stillcut-cli knock [RECORDING]: knocks along the axis of a channel tell which sensor lies along it, from a profile's
// device or from a recording of them.

#include <cstdio>

#include "app/cli/command.h"
#include "app/cli/measurement_options.h"
#include "app/cli/reading_options.h"
#include "app/compose/measure_samples.h"
#include "core/daq/axis_knock.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {
namespace {

struct KnockOptions : MeasurementOptions {
  int along = 0;
  ReadingOptions reading;
};

int save(config::Profile profile, const config::ParamCatalog& catalog, const KnockOptions& o,
         const std::vector<ChannelInfo>& now) {
  if (profile.cut.channels.size() != now.size()) return failWithoutChannels(o);
  for (std::size_t c = 0; c < now.size(); ++c) profile.cut.channels[c].axis = now[c].axis;
  return saveProfileOf(o, profile, catalog);
}

int run(const KnockOptions& o) {
  if (const Status usable = checkMeasurementOptions(o, "knock", "knocks", "whose axes are checked"); !usable)
    return fail(usable.error());
  const auto reading = o.reading.understand();
  if (!reading) return fail(reading.error());
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  auto profile = profileOf(o, catalog);
  if (!profile) return fail(profile.error());
  if (!o.profile.empty()) {
    std::printf("knock along the axis of channel %d now, some times within %.0f s\n", o.along, o.seconds);
    std::fflush(stdout);
  }
  SetUpFault fault = SetUpFault::Input;
  const auto heard = measure(o, *profile, *reading, o.along, fault);
  if (!heard) return fail(heard.error(), fault == SetUpFault::Hardware ? kExitDevice : kExitInput);
  if (const Status there = checkChannel(heard->channels.size(), o.recording, o.along); !there)
    return fail(there.error());
  std::vector<ChannelInfo> now = heard->channels;
  for (ChannelInfo& channel : now) {  // most recordings name a channel by its axis and say no more
    const bool isAxis = channel.name == "x" || channel.name == "y" || channel.name == "z";
    if (channel.axis.empty() && isAxis) channel.axis = channel.name;
  }
  const auto knocks = daq::analyseKnocks(heard->samples, heard->rate, now, static_cast<std::size_t>(o.along));
  if (!knocks) return fail(knocks.error());
  std::printf("%s\n", text(daq::knockSentence(*knocks, now)).c_str());
  daq::applyKnocks(*knocks, now);
  return o.save ? save(std::move(profile).value(), catalog, o, now) : kExitDone;
}

}  // namespace

void addKnock(CLI::App& app, int& exitCode) {
  auto o = std::make_shared<KnockOptions>();
  o->seconds = 8.0;  // time to walk up and knock
  CLI::App* command = app.add_subcommand("knock", "Find exchanged axes by knocking along one");
  addMeasurementOptions(*command, *o, "the knocks");
  command->add_option("--along", o->along, "The channel along whose axis you knock, from 0")->capture_default_str();
  command->add_flag("--save", o->save, "Exchange the axes in the profile where they are found exchanged");
  o->reading.add(*command);
  command->callback([o, &exitCode] { exitCode = run(*o); });
}

}  // namespace stillcut::app
