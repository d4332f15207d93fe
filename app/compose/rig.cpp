#include "app/compose/rig.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/compose/run_text.h"
#include "core/control/registry.h"
#include "core/detect/registry.h"
#include "core/sensing/conditioner.h"
#include "core/session/file/session_markers.h"
#include "generated/version.h"

namespace stillcut::app {
namespace {

// A strategy that weighs a detector's indicators takes that detector along.
Status completeMethods(Methods& methods) {
  const auto strategy = control::makeStrategy(methods.strategy);
  if (!strategy) return strategy.error();
  const std::string needed((*strategy)->describe().requiredDetector);
  const auto has = std::find(methods.detectors.begin(), methods.detectors.end(), needed) != methods.detectors.end();
  if (!needed.empty() && !has) methods.detectors.push_back(needed);
  return Done{};
}

// Of the methods that run, what is not locked; the gate's are not among them.
std::vector<const config::ParamDecl*> tunable(const Methods& methods) {
  std::vector<const config::ParamDecl*> decls;
  const auto take = [&decls](config::ParamTable table) {
    std::copy_if(table.begin(), table.end(), std::back_inserter(decls),
                 [](const config::ParamDecl* decl) { return !decl->lockedWhileRunning; });
  };
  take(detect::conditionerParams());
  for (const auto& row : detect::detectorTable()) {
    if (std::find(methods.detectors.begin(), methods.detectors.end(), row.id) != methods.detectors.end()) {
      take(row.params());
    }
  }
  for (const auto& entry : control::strategyTable()) {
    if (entry.id == methods.strategy) take(entry.params);
  }
  return decls;
}

Result<pipeline::ChainParts> makeParts(const Methods& methods) {
  pipeline::ChainParts parts;
  for (const std::string& id : methods.detectors) {
    auto detector = detect::makeDetector(id);
    if (!detector) return detector.error();
    if (id == methods.fallback) parts.fallback = static_cast<int>(parts.detectors.size());
    parts.detectors.push_back(std::move(detector).value());
  }
  auto strategy = control::makeStrategy(methods.strategy);
  if (!strategy) return strategy.error();
  parts.strategy = std::move(strategy).value();
  parts.tunable = tunable(methods);
  return parts;
}

class RecorderTap final : public pipeline::StepTap {
 public:
  explicit RecorderTap(record::Recorder& recorder) : recorder_(recorder) {}
  bool push(const StepInput& input, const StepOutput& output) noexcept override {
    return recorder_.push(input, output);
  }
  bool stopped() const noexcept override { return recorder_.stopped(); }

 private:
  record::Recorder& recorder_;
};

Status checkRoomFor(const std::string& path) {
  return record::checkRoom(path, record::RecorderOptions().reserveBytes);
}

config::MachineOverrides reach(const cnc::LinkInfo& info) {
  return {info.lowestSpeed, info.highestSpeed, info.lowestFeed, info.highestFeed};
}

}  // namespace

Rig::Rig(RigSpec spec) : spec_(std::move(spec)) {}

Rig::~Rig() {
  (void)stop().ok();
  if (linkRunner_) linkRunner_->finish();
}

Result<std::unique_ptr<Rig>> Rig::build(RigSpec spec, SetUpFault* fault) {
  std::unique_ptr<Rig> rig(new Rig(std::move(spec)));
  SetUpFault kind = SetUpFault::Input;
  try {
    if (const Status ready = rig->prepare(kind); !ready) {
      if (fault != nullptr) *fault = kind;
      return ready.error();
    }
  } catch (const std::exception& e) {
    return Error{message("set-up"), foreign(e.what())};
  }
  return rig;
}

Status Rig::open() {
  const auto opened = spec_.device->open();
  if (!opened) return opened.error();
  format_ = *opened;
  spec_.setup.rate = format_.rate;
  spec_.setup.blockFrames = format_.blockFrames;
  spec_.setup.channels = format_.channels;
  return spec_.link ? spec_.link->open() : Status(Done{});
}

Status Rig::prepare(SetUpFault& fault) {
  if (spec_.link && !spec_.device->live() && !spec_.link->describe().simulated) {
    return Error{"link '" + std::string(spec_.link->describe().id) + "'",
                 message("a simulated or recorded cut may not drive a real machine"),
                 message("use the link 'simulated'")};
  }
  fault = SetUpFault::Hardware;
  if (Status opened = open(); !opened) return opened;
  fault = SetUpFault::Input;
  if (spec_.link) {
    const Status narrowed = config::narrowToMachine(spec_.params, reach(spec_.link->describe()), "machine");
    if (!narrowed) return narrowed.error();
  }
  auto limits = safety::gateLimits(spec_.params, spec_.setup, "settings", linkInfo().period);
  if (!limits) return limits.error();
  // Without a machine there is nothing that Auto could move; a recorded one is as its recording says.
  spec_.autoAllowed = spec_.autoAllowed && (spec_.link != nullptr || spec_.feed != nullptr);
  limits->autoAllowed = spec_.autoAllowed;

  if (Status complete = completeMethods(spec_.methods); !complete) return complete;
  auto parts = makeParts(spec_.methods);
  if (!parts) return parts.error();
  chain_ = std::make_unique<pipeline::Chain>(std::move(parts).value());
  chain_->prepare(spec_.setup, spec_.params, *limits);
  publisher_.prepare(spec_.setup, spec_.link && spec_.link->describe().simulated, spec_.autoAllowed);
  if (!spec_.steps) spec_.steps = std::make_unique<pipeline::DeviceStepSource>(*spec_.device);
  if (!spec_.feed) {
    spec_.feed = std::make_unique<pipeline::LiveStateSource>(states_, inputs_);
  } else if (spec_.watched) {
    spec_.feed = std::make_unique<pipeline::TunedStateSource>(std::move(spec_.feed), inputs_);
  }
  if (spec_.link) {
    const Clock* boot = spec_.deterministic ? nullptr : &bootClock_;
    linkRunner_ = std::make_unique<pipeline::LinkRunner>(*spec_.link, commands_, states_, spec_.linkEffect, boot);
  }
  makeLoop();
  return Done{};
}

void Rig::makeLoop() {
  loop_ = std::make_unique<pipeline::StepLoop>(
      pipeline::StepLoopParts{*chain_, *spec_.feed, commands_, spec_.watched ? &publisher_ : nullptr, tap_.get(),
                              spec_.deterministic ? static_cast<const Clock&>(manualClock_) : steadyClock_});
}

cnc::LinkInfo Rig::linkInfo() const {
  return spec_.link ? spec_.link->describe() : cnc::LinkInfo{};
}

record::SessionHeader Rig::sessionHeader(const std::string& origin) const {
  record::SessionHeader header;
  header.setup = spec_.setup;
  header.configuration = runText({spec_.methods, spec_.autoAllowed, spec_.params}, origin);
  header.programVersion = STILLCUT_VERSION;
  if (!spec_.operatorName.empty()) header.operatorName = spec_.operatorName;
  header.job = spec_.job;
  header.simulated = spec_.link && spec_.link->describe().simulated;
  return header;
}

void Rig::tapInto(std::unique_ptr<record::Recorder> recorder) {
  recorder_ = std::move(recorder);
  tap_ = std::make_unique<RecorderTap>(*recorder_);
  makeLoop();
}

Status Rig::recordTo(const std::string& path, const std::string& origin, const record::RecorderOptions& options) {
  return tapIntoMade(path, record::Recorder::create(path, sessionHeader(origin), options));
}

Status Rig::recordToNew(const std::string& wanted, const std::string& origin) {
  const record::NextPath nextPath = [wanted]() -> Result<std::string> {
    const std::string path = record::freeSessionPath(wanted);
    if (Status room = checkRoomFor(path); !room) return room.error();
    return path;
  };
  return tapIntoMade(wanted, record::Recorder::create(nextPath, sessionHeader(origin)));
}

// The cut is watched all the same where nothing can be recorded.
Status Rig::tapIntoMade(const std::string& path, Result<std::unique_ptr<record::Recorder>> made) {
  if (made) {
    tapInto(std::move(made).value());
    return Done{};
  }
  tapInto(record::Recorder::stopped(path, made.error(), spec_.setup));
  return made.error();
}

Status Rig::recordInto(const std::string& folder, const std::string& origin,
                       std::function<void(const record::Deleted&)> told) {
  const record::SessionHeader header = sessionHeader(origin);
  const record::RecordPlan plan = record::recordPlan(spec_.params);
  const record::NextPath nextPath = [folder, plan, job = header.job, tool = header.setup.tool,
                                     told = std::move(told)]() -> Result<std::string> {
    for (const record::Deleted& file : record::applyRetention(folder, plan, record::nowUtc())) told(file);
    Result<std::string> path = record::newSessionPath(folder, job, tool, record::nowUtc());
    if (!path) return path;
    if (const Status room = checkRoomFor(*path); !room) return room.error();
    return path;
  };
  if (plan.mode == record::RecordMode::Continuous) {
    return tapIntoMade(folder, record::Recorder::create(nextPath, header));
  }
  // In every mode: what cannot be kept is known before the cut.
  if (const auto first = nextPath(); !first) return tapIntoMade(folder, first.error());
  std::unique_ptr<record::StepSink> sink;
  if (plan.mode == record::RecordMode::AroundEvents) {
    sink = record::aroundEvents(header, plan, nextPath, {});
  } else {
    sink = record::features(header, plan, nextPath, {});
  }
  tapInto(record::Recorder::create(std::move(sink), header.setup));
  return Done{};
}

bool Rig::send(const OperatorInput& input) {
  return inputs_.push(input);
}

// What is measured now cannot be measured again: it goes before everything else on this computer, where that is allowed
// (packaging/system/stillcut-limits.conf), and a computer that stands still for a moment loses nothing.
pipeline::EngineOptions Rig::liveOptions(pipeline::EngineOptions options) const {
  constexpr double kBehind = 2.0;  // s that the worker may fall behind before blocks are dropped
  options.worker.scheduling = rt::Scheduling::Fifo;
  options.ringBlocks =
      std::max(options.ringBlocks, static_cast<int>(kBehind * format_.rate.value / format_.blockFrames));
  return options;
}

void Rig::start(const pipeline::EngineOptions& asked) {
  const pipeline::EngineOptions options = spec_.device->live() ? liveOptions(asked) : asked;
  if (recorder_) recorder_->startThread();
  engine_ = std::make_unique<pipeline::Engine>(
      pipeline::EngineParts{*spec_.steps, format_, *loop_, linkRunner_.get(), steadyClock_}, options);
  engine_->start();
}

Status Rig::stop() {
  if (engine_) engine_->stop();
  return recorder_ ? recorder_->finish() : Status(Done{});
}

bool Rig::advance(const After& after) {
  if (!serial_) {
    serial_ = std::make_unique<pipeline::SerialRun>(
        pipeline::SerialParts{*spec_.steps, format_, *loop_, linkRunner_.get(), &manualClock_});
  }
  const pipeline::Chain::Step* done = serial_->next();
  if (done == nullptr) return false;
  if (recorder_) recorder_->drain();
  if (after) after(serial_->input(), done->output);
  return true;
}

void Rig::runToEnd(const After& after) {
  while (advance(after)) {
  }
  if (linkRunner_) linkRunner_->finish();
}

}  // namespace stillcut::app
