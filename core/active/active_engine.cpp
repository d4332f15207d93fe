#include "core/active/active_engine.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <utility>

namespace stillcut::active {

namespace {

constexpr double kTellEvery = 1.0 / 30.0;  // [s]
constexpr auto kRampOutTakes = std::chrono::milliseconds(500);
constexpr Seconds kLease{1.0};  // the longest that a gate takes
constexpr int kQueued = 4;  // blocks that a device may hold back, and one: the ramp has been played before it is closed
constexpr auto kRenewEvery = std::chrono::milliseconds(100);
constexpr auto kNap = std::chrono::milliseconds(1);
constexpr std::array<const char*, kActiveAxes> kAxes{"x", "y"};

Error refused(Message what, Message why) {
  return {"active work-holder", std::move(what), std::move(why)};
}

}  // namespace

std::array<AxisOptions, kActiveAxes> axisOptions(const ActiveEngineOptions& options, const PathPairFound& paths) {
  std::array<AxisOptions, kActiveAxes> axes;
  for (std::size_t a = 0; a < kActiveAxes; ++a) {
    axes[a] = {options.controller, paths[a].model, options.limits[a], options.lines, {}};
    axes[a].controller.emphasis.lines = options.lines;
    axes[a].online.rms = options.auxiliary * options.limits[a].amplitude;
    axes[a].online.seed += a;  // two axes that reach each other need uncorrelated noises
  }
  return axes;
}

ActiveEngine::ActiveEngine(std::unique_ptr<DuplexDevice> device, ActiveEngineOptions options, const Clock& clock)
    : device_(std::move(device)),
      options_(std::move(options)),
      clock_(clock),
      step_(options_.controller.filter.step),
      leak_(options_.controller.filter.leak) {}

ActiveEngine::~ActiveEngine() {
  close();
}

Status ActiveEngine::open() {
  close();
  auto opened = device_->open();
  if (!opened) return opened.error();
  format_ = *opened;
  const Seconds block(format_.frames / format_.rate.value);
  if (2.0 * block.value > kLease.value) {
    device_->close();
    return refused(message("blocks of %1 frames are too long", std::to_string(format_.frames)),
                   message("half a second at most"));
  }
  for (safety::ActuatorLimits& limits : options_.limits) limits.lease = kLease;
  const auto values = static_cast<std::size_t>(kActiveAxes * format_.frames);
  in_.assign(values, 0.0);
  out_.assign(values, {});
  telling_ = {};
  telling_.rate = format_.rate;
  telling_.blockFrames = format_.frames;
  untold_ = 0;
  open_.store(true, std::memory_order_release);
  thread_ = std::make_unique<rt::RealtimeThread>(
      rt::ThreadRequest{.name = "active-loop", .scheduling = rt::Scheduling::Fifo, .priority = 70},
      [this](const std::stop_token& stop) { run(stop); });
  return Done{};
}

Instant ActiveEngine::identifiedAt(std::size_t axis, const ActivePath& path) const {
  return std::max(path.identified, instantFromNs(renewedAt_[axis].load(std::memory_order_relaxed)));
}

void ActiveEngine::close() {
  renewer_ = {};  // asked to stop, and waited for
  if (thread_ != nullptr) {
    stop();
    thread_->requestStop();
    // The thread ramps out, then ends; a device that delivers nothing has nothing to ramp.
    const auto queue = toDuration(Seconds(2 * kQueued * format_.frames / format_.rate.value));
    const auto latest = std::chrono::steady_clock::now() + kRampOutTakes + queue;
    while (isOpen() && std::chrono::steady_clock::now() < latest) std::this_thread::sleep_for(kNap);
    device_->stop();
    thread_.reset();
    device_->close();
  }
  open_.store(false, std::memory_order_release);
  recording_.store(nullptr);
  loop_.store(nullptr);
  recorded_.store(false);
  recorder_.reset();
  loops_.clear();
  paths_ = {};
}

bool ActiveEngine::busy() const {
  const ActiveLoop* loop = loop_.load();
  return recording_.load() != nullptr || (loop != nullptr && !loop->off());
}

Status ActiveEngine::identify() {
  if (!isOpen()) return refused(message("the device does not run"), message("open it first"));
  if (busy()) return refused(message("cannot identify while the table moves"), message("stop it first"));
  if (ActiveLoop* loop = loop_.load(); loop != nullptr) loop->release();  // also of a start not yet taken
  auto recorder = std::make_unique<PathRecorder>();
  if (Status ok = recorder->prepare(options_.record, options_.limits, format_.rate); !ok) return ok;
  // What is identified anew is no longer trusted as it was.
  loop_.store(nullptr);
  paths_ = {};
  margins_.back() = paths_;
  margins_.publish();
  delayLost_.store(false);
  recorded_.store(false);
  recorder_ = std::move(recorder);
  recording_.store(recorder_.get());
  return Done{};
}

Result<PathPairFound> ActiveEngine::fit() const {
  if (!recorded() || recorder_ == nullptr) return refused(message("nothing was recorded"), message("identify first"));
  if (Status whole = recorder_->complete(); !whole) return whole.error();
  PathPairFound found;
  PathRequest request = options_.path;
  request.sweep = options_.record.excitation == Excitation::Sweep;
  for (std::size_t a = 0; a < kActiveAxes; ++a) {
    auto one = identifyPath(recorder_->output(a), recorder_->reading(a), format_.rate, request,
                            device_->name() + ": path along " + kAxes[a]);
    if (!one) return one.error();
    found[a] = std::move(one).value();
  }
  return found;
}

Status ActiveEngine::install(const PathPairFound& paths) {
  if (!isOpen()) return refused(message("the device does not run"), message("open it first"));
  if (busy()) return refused(message("a path cannot be taken over while the table moves"), message("stop it first"));
  if (delayLost_.load())
    return refused(message("blocks were lost since the record was made"), message("identify it again"));
  auto loop = std::make_unique<ActiveLoop>();
  if (Status ok = loop->prepare(axisOptions(options_, paths), format_.rate); !ok) return ok;
  for (std::size_t a = 0; a < kActiveAxes; ++a) {
    paths_[a] = stabilityMarginOf(paths[a], options_.lines, format_.rate);
    paths_[a].identified = clock_.now();
  }
  for (auto& at : renewedAt_) at.store(0);
  margins_.back() = paths_;
  margins_.publish();
  loops_.push_back(std::move(loop));
  loop_.store(loops_.back().get());
  if (options_.auxiliary > 0.0 && !renewer_.joinable()) {
    renewer_ = std::jthread([this](const std::stop_token& stop) { renew(stop); });
  }
  return Done{};
}

void ActiveEngine::renew(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::this_thread::sleep_for(kRenewEvery);
    ActiveLoop* loop = loop_.load();
    if (loop == nullptr) continue;
    std::array<int, kActiveAxes> before{};
    for (std::size_t a = 0; a < kActiveAxes; ++a) before[a] = loop->renewals(a);
    loop->renewModels();
    for (std::size_t a = 0; a < kActiveAxes; ++a) {
      if (loop->renewals(a) != before[a]) renewedAt_[a].store(toNs(clock_.now()), std::memory_order_relaxed);
    }
  }
}

Status ActiveEngine::start() {
  if (!isOpen()) return refused(message("the device does not run"), message("open it first"));
  if (recording_.load() != nullptr)
    return refused(message("the paths are being identified"), message("wait for the end"));
  ActiveLoop* loop = loop_.load();
  if (loop == nullptr)
    return refused(message("no model of the path from actuator to sensor"), message("identify it first"));
  for (std::size_t a = 0; a < kActiveAxes; ++a) {
    const std::string axis = kAxes[a];
    const double age = secondsBetween(identifiedAt(a, paths_[a]), clock_.now()).value;
    if (age > options_.oldestModel.value) {
      return refused(message("the model along %1 is %2 minutes old", axis, std::to_string(std::lround(age / 60.0))),
                     message("identify it again"));
    }
    if (Status promised = checkStabilityMargin(paths_[a], axis); !promised) return promised;
  }
  if (delayLost_.load()) {
    return refused(message("blocks were lost, and input and output of this device do not start together"),
                   message("the path may be later than its model says; identify it again"));
  }
  loop->engage();
  return Done{};
}

void ActiveEngine::stop() {
  if (PathRecorder* recorder = recording_.load(); recorder != nullptr) recorder->release();
  if (ActiveLoop* loop = loop_.load(); loop != nullptr) loop->release();
}

Status ActiveEngine::setStep(double step) {
  if (!(step >= 0.0 && step <= 1.0)) return refused(message("the step must lie between 0 and 1"), {});
  step_.store(step);
  return Done{};
}

Status ActiveEngine::setLeak(double leak) {
  if (!(leak >= 0.9 && leak <= 1.0)) return refused(message("the leak must lie between 0.9 and 1"), {});
  leak_.store(leak);
  return Done{};
}

void ActiveEngine::lost() STILLCUT_RT {
  ++telling_.underruns;
  if (!format_.keepsDelay) delayLost_.store(true);
  cut();
}

void ActiveEngine::run(const std::stop_token& stop) {
  int quiet = 0;  // blocks of silence at the end
  while (!stop.stop_requested() || busy() || quiet < kQueued) {
    if (stop.stop_requested() && !busy()) ++quiet;
    const DuplexEvent event = device_->read(in_);
    if (event == DuplexEvent::Gone) break;
    if (event == DuplexEvent::Lost) {
      lost();
      continue;
    }
    const Instant begun = clock_.now();
    block(in_, out_);
    if (device_->write(out_) == DuplexEvent::Lost) lost();
    const Seconds took = secondsBetween(begun, clock_.now());
    if (took.value > telling_.worstBlock.value) telling_.worstBlock = took;
    ++telling_.blocks;
    untold_ += format_.frames;
    if (untold_ >= kTellEvery * format_.rate.value) publish();
  }
  cut();
  open_.store(false, std::memory_order_release);
  publish();
}

void ActiveEngine::block(std::span<const double> in, std::span<safety::ActuatorCommand> out) STILLCUT_RT {
  const auto frames = static_cast<std::size_t>(format_.frames);
  PathRecorder* recorder = recording_.load(std::memory_order_acquire);
  ActiveLoop* loop = loop_.load(std::memory_order_acquire);
  const std::uint64_t renewals = renewals_.load(std::memory_order_relaxed);
  const bool renewed = renewals != heardRenewals_;
  heardRenewals_ = renewals;
  if (recorder != nullptr) {
    if (renewed) recorder->begin();
  } else if (loop != nullptr) {
    if (renewed) loop->begin();
    loop->setStep(step_.load(std::memory_order_relaxed));
    loop->setLeak(leak_.load(std::memory_order_relaxed));
  }
  for (std::size_t f = 0; f < frames; ++f) {
    const AxisPair errors{in[f], in[frames + f]};
    CommandPair strokes{};
    if (recorder != nullptr) {
      strokes = recorder->step(errors);
    } else if (loop != nullptr) {
      strokes = loop->step(errors);
    }
    out[f] = strokes[0];
    out[frames + f] = strokes[1];
  }
  if (recorder != nullptr && recorder->over()) {
    recorder->tell(telling_.axes);
    recording_.store(nullptr, std::memory_order_release);
    recorded_.store(true, std::memory_order_release);
  }
}

void ActiveEngine::cut() STILLCUT_RT {
  if (PathRecorder* recorder = recording_.load(std::memory_order_acquire); recorder != nullptr) {
    recorder->cut();
    recorder->tell(telling_.axes);
    recording_.store(nullptr, std::memory_order_release);
    recorded_.store(true, std::memory_order_release);
  }
  if (ActiveLoop* loop = loop_.load(std::memory_order_acquire); loop != nullptr) loop->cut();
}

void ActiveEngine::publish() STILLCUT_RT {
  untold_ = 0;
  ++telling_.number;
  telling_.time = clock_.now();
  telling_.open = open_.load(std::memory_order_relaxed);
  const PathRecorder* recorder = recording_.load(std::memory_order_acquire);
  const ActiveLoop* loop = loop_.load(std::memory_order_acquire);
  telling_.identifying = recorder != nullptr;
  if (recorder != nullptr) {
    telling_.identified = recorder->part();
    recorder->tell(telling_.axes);
  } else if (loop != nullptr) {
    loop->tell(telling_.axes);
  }
  if (const auto* promises = margins_.read(); promises != nullptr) telling_.paths = *promises;
  for (std::size_t a = 0; a < kActiveAxes; ++a) telling_.paths[a].identified = identifiedAt(a, telling_.paths[a]);
  snapshots_.back() = telling_;
  snapshots_.publish();
}

}  // namespace stillcut::active
