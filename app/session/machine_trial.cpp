#include "app/session/machine_trial.h"

#include <cmath>

#include "app/compose/profile_rig.h"
#include "app/io/kept_link.h"
#include "core/base/time.h"
#include "core/cnc/link_trial.h"
#include "core/cnc/registry.h"
#include "core/model/sample_block.h"
#include "core/pipeline/catalog.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

using State = ui::TrialStep::State;
using What = ui::TrialStep::What;

constexpr int kBlocks = 20;  // of samples, to see a level

QString text(const std::string& s) {
  return QString::fromStdString(s);
}

// rms of each channel over a few blocks; an error where none come or one is dead.
Result<QString> listen(daq::DaqSource& device, const daq::SourceFormat& format) {
  SampleBlock block;
  block.allocate(static_cast<int>(format.channels.size()), format.blockFrames);
  std::vector<double> sums(format.channels.size(), 0.0);
  double frames = 0.0;
  for (int k = 0; k < kBlocks; ++k) {
    if (!device.read(block)) return Error{message("samples"), message("the device has stopped"), device.fault()};
    for (std::size_t c = 0; c < sums.size(); ++c) {
      for (const double x : block.channel(static_cast<int>(c))) sums[c] += x * x;
    }
    frames += block.frames;
  }
  QStringList levels;
  for (std::size_t c = 0; c < sums.size(); ++c) {
    const ChannelInfo& info = format.channels[c];
    const double rms = std::sqrt(sums[c] / std::max(frames, 1.0)) * std::abs(info.scale);
    if (!(rms > 0.0)) {
      return Error{info.name, message("this channel never moves"), message("is the sensor connected?")};
    }
    levels.push_back(QStringLiteral("%1 %2 %3")
                         .arg(text(info.name))
                         .arg(rms, 0, 'g', 3)
                         .arg(text(std::string(siUnit(info.quantity)))));
  }
  return levels.join(QStringLiteral(", "));
}

class Steps {
 public:
  Steps() {
    for (const What what : {What::Settings, What::Device, What::Samples, What::Link, What::Machine}) {
      steps_.push_back({what, State::Waits, {}});
    }
  }
  void good(What what, const QString& detail) { set(what, State::Good, detail); }
  void bad(What what, const Error& error) { bad(what, ui::sayError(error)); }
  void bad(What what, const QString& detail) { set(what, State::Bad, detail); }
  void leaveOut(What what) {
    std::erase_if(steps_, [what](const ui::TrialStep& step) { return step.what == what; });
  }
  std::vector<ui::TrialStep> take() { return std::move(steps_); }

 private:
  void set(What what, State state, const QString& detail) {
    for (ui::TrialStep& step : steps_) {
      if (step.what != what) continue;
      step.state = state;
      step.detail = detail;
    }
  }
  std::vector<ui::TrialStep> steps_;
};

// The first is the link's, what follows the machine's.
void showSteps(const std::vector<cnc::LinkTrialStep>& taken, Steps& steps) {
  QStringList said;
  for (const cnc::LinkTrialStep& step : taken) {
    const What what = &step == &taken.front() ? What::Link : What::Machine;
    if (!step.good) return steps.bad(what, ui::sayCore(step.said));
    if (what == What::Machine) said << ui::sayCore(step.said);
    steps.good(what, what == What::Link ? ui::sayCore(step.said) : said.join(QStringLiteral("\n")));
  }
}

// The same steps and sentences as on the command line.
// `effect`: how long an order took to act in the last run; 0: none was seen.
Seconds tryLink(cnc::CncLink& link, const Clock& clock, Seconds effect, Steps& steps) {
  cnc::LinkTrial trial(link, clock);
  trial.proved(effect);
  while (trial.next()) {
  }
  showSteps(trial.steps(), steps);
  if (!trial.passed()) return {};
  return trial.look();
}

}  // namespace

std::vector<cnc::LinkTrialStep> RunsLink::steps() const {
  cnc::LinkInfo named = info;
  named.label = label;
  return cnc::LinkTrial::ofRun(named, state, age, effect);
}

std::vector<ui::LinkTest::Step> linkAsRunTells(const RunsLink& run) {
  std::vector<ui::LinkTest::Step> told;
  for (const cnc::LinkTrialStep& step : run.steps()) {
    told.push_back({text(step.what), ui::sayCore(step.said), step.good});
  }
  return told;
}

Seconds tryLinkOf(const config::Profile& profile, const std::string& path, LinkStepBox& steps,
                  const std::atomic<bool>& toEnd) {
  const SteadyClock clock;
  auto link = makeKeptLink(profile.link.id, linkRequest(profile, path, clock, AnalogOutputs::LeftAlone),
                           AnalogOutputs::LeftAlone);
  if (!link) {
    steps.put({QStringLiteral("Settings"), ui::sayError(link.error()), false});
    return {};
  }
  cnc::LinkTrial trial(**link, clock);
  trial.proved(cnc::savedDelay(profile.link.settings, cnc::kSavedEffect));
  while (!toEnd && trial.next()) {
    const cnc::LinkTrialStep& step = trial.steps().back();
    steps.put({text(step.what), ui::sayCore(step.said), step.good});
  }
  return trial.passed() ? trial.look() : Seconds();
}

ProfileTrial tryProfile(const config::Profile& profile, const std::string& path, const RunsLink* run) {
  Steps steps;
  if (profile.link.id.empty()) {
    steps.leaveOut(What::Link);
    steps.leaveOut(What::Machine);
  }
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  const auto sound = config::parseProfile(config::profileText(profile, catalog), path, catalog, knownIds());
  auto parts =
      sound ? makeProfileParts(*sound, path, nullptr, AnalogOutputs::LeftAlone) : Result<ProfileParts>(sound.error());
  if (!parts) {
    steps.bad(What::Settings, parts.error());
    return {steps.take(), {}};
  }
  steps.good(What::Settings, {});
  const auto format = parts->device->open();
  if (!format) {
    steps.bad(What::Device, format.error());
    return {steps.take(), {}};
  }
  const QString delivers = QCoreApplication::translate("Trial", "%1 Hz, channels: %2")
                               .arg(format->rate.value, 0, 'f', 0)
                               .arg(format->channels.size());
  steps.good(What::Device,
             format->doubt.empty() ? delivers : QStringLiteral("%1; %2").arg(delivers, ui::sayCore(format->doubt)));
  if (const auto heard = listen(*parts->device, *format); heard) {
    steps.good(What::Samples, *heard);
  } else {
    steps.bad(What::Samples, heard.error());
    return {steps.take(), {}};
  }
  if (!parts->link) return {steps.take(), {}};
  if (run != nullptr) {
    showSteps(run->steps(), steps);
    return {steps.take(), run->state.valid ? run->state.link.roundTrip : Seconds()};
  }
  const Seconds effect = cnc::savedDelay(profile.link.settings, cnc::kSavedEffect);
  const Seconds look = tryLink(*parts->link, *parts->clock, effect, steps);
  return {steps.take(), look};
}

}  // namespace stillcut::app
