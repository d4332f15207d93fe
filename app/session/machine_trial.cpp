#include "app/session/machine_trial.h"

#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

#include "app/compose/catalog.h"
#include "app/compose/profile_rig.h"
#include "core/base/time.h"
#include "core/model/sample_block.h"

namespace stillcut::app {
namespace {

using State = ui::TrialStep::State;
using What = ui::TrialStep::What;

constexpr int kBlocks = 20;                          // of samples, to see a level
constexpr auto kPatience = std::chrono::seconds(3);  // for the machine's first answer

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
    if (!device.read(block)) return Error{"samples", "the device has stopped", device.fault()};
    for (std::size_t c = 0; c < sums.size(); ++c) {
      for (const double x : block.channel(static_cast<int>(c))) sums[c] += x * x;
    }
    frames += block.frames;
  }
  QStringList levels;
  for (std::size_t c = 0; c < sums.size(); ++c) {
    const ChannelInfo& info = format.channels[c];
    const double rms = std::sqrt(sums[c] / std::max(frames, 1.0)) * std::abs(info.scale);
    if (!(rms > 0.0)) return Error{"channel '" + info.name + "'", "never moves", "is the sensor connected?"};
    levels.push_back(QStringLiteral("%1 %2 %3")
                         .arg(text(info.name))
                         .arg(rms, 0, 'g', 3)
                         .arg(text(std::string(siUnit(info.quantity)))));
  }
  return levels.join(QStringLiteral(", "));
}

// The first valid state.
Result<QString> ask(cnc::CncLink& link) {
  const SteadyClock clock;
  const auto until = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < until) {
    const MachineState state = link.read(clock.now());
    if (state.valid) {
      return QStringLiteral("%1 rpm programmed, %2 rpm now, watchdog: %3")
          .arg(state.programmedSpeed.value, 0, 'f', 0)
          .arg(state.actualSpeed.value, 0, 'f', 0)
          .arg(link.describe().machineWatchdog ? QStringLiteral("yes") : QStringLiteral("no"));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return Error{"machine", "does not answer", "is its control running, and the address right?"};
}

class Steps {
 public:
  Steps() {
    for (const What what : {What::Settings, What::Device, What::Samples, What::Link, What::Machine}) {
      steps_.push_back({what, State::Waits, {}});
    }
  }
  void good(What what, const QString& detail) { set(what, State::Good, detail); }
  void bad(What what, const Error& error) { set(what, State::Bad, text(error.line())); }
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

}  // namespace

std::vector<ui::TrialStep> tryProfile(const config::Profile& profile, const std::string& path) {
  Steps steps;
  if (profile.link.id.empty()) {
    steps.leaveOut(What::Link);
    steps.leaveOut(What::Machine);
  }
  const config::ParamCatalog catalog = fullCatalog();
  const auto sound = config::parseProfile(config::profileText(profile, catalog), path, catalog, knownIds());
  auto parts = sound ? makeProfileParts(*sound, path) : Result<ProfileParts>(sound.error());
  if (!parts) {
    steps.bad(What::Settings, parts.error());
    return steps.take();
  }
  steps.good(What::Settings, {});
  const auto format = parts->device->open();
  if (!format) {
    steps.bad(What::Device, format.error());
    return steps.take();
  }
  steps.good(What::Device,
             QStringLiteral("%1 Hz, %2 channel(s)").arg(format->rate.value, 0, 'f', 0).arg(format->channels.size()));
  if (const auto heard = listen(*parts->device, *format); heard) {
    steps.good(What::Samples, *heard);
  } else {
    steps.bad(What::Samples, heard.error());
    return steps.take();
  }
  if (!parts->link) return steps.take();
  if (const Status opened = parts->link->open(); !opened) {
    steps.bad(What::Link, opened.error());
    return steps.take();
  }
  const auto label = parts->link->describe().label;
  steps.good(What::Link, text(std::string(label)));
  if (const auto answer = ask(*parts->link); answer) {
    steps.good(What::Machine, *answer);
  } else {
    steps.bad(What::Machine, answer.error());
  }
  return steps.take();
}

}  // namespace stillcut::app
