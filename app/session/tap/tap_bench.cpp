#include "app/session/tap/tap_bench.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/compose/profile_rig.h"
#include "core/daq/registry.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

constexpr double kMeterFalls = 0.93;  // of its level with every block: half a second or so
constexpr double kLeastForce = 2.0;   // [N] that is a hit
const QString kSimulated = QStringLiteral("simulated-hammer");
const QString kProfile = QStringLiteral("profile:");

ui::TapRun::Phase phaseOf(identify::TapTest::Phase phase) {
  using From = identify::TapTest::Phase;
  using To = ui::TapRun::Phase;
  switch (phase) {
    case From::Settling:
      return To::Settling;
    case From::Waiting:
      return To::HitNow;
    case From::Recording:
      return To::Recording;
    case From::Ringing:
      return To::Ringing;
    case From::Enough:
      return To::Enough;
  }
  return To::Off;
}

ui::TapFault faultOf(identify::HitFault fault) {
  using From = identify::HitFault;
  using To = ui::TapFault;
  switch (fault) {
    case From::None:
      return To::None;
    case From::DoubleHit:
      return To::DoubleHit;
    case From::ForceOverload:
      return To::ForceOverload;
    case From::ResponseOverload:
      return To::ResponseOverload;
    case From::Weak:
      return To::Weak;
    case From::TooSoon:
      return To::TooSoon;
    case From::Gap:
      return To::Gap;
    case From::Incoherent:
      return To::Incoherent;
  }
  return To::None;
}

std::optional<identify::FrfQuantity> quantityOf(SensorQuantity quantity) {
  switch (quantity) {
    case SensorQuantity::Acceleration:
    case SensorQuantity::Sound:  // without a hammer: its scale does not matter
      return identify::FrfQuantity::Accelerance;
    case SensorQuantity::Velocity:
      return identify::FrfQuantity::Mobility;
    case SensorQuantity::Displacement:
      return identify::FrfQuantity::Compliance;
    default:
      return std::nullopt;
  }
}

int axisOf(const std::string& name) {
  return name == "x" ? 0 : name == "y" ? 1 : -1;
}

}  // namespace

TapBench::~TapBench() {
  stopLobes_.request_stop();
}

std::vector<ui::TapDevice> TapBench::devices() const {
  std::vector<ui::TapDevice> all{{kSimulated, QCoreApplication::translate("Tap", "Simulated hammer and tool")}};
  if (!profiles) return all;
  for (const QString& name : profiles()) {
    all.push_back(
        {kProfile + name, name.isEmpty() ? QCoreApplication::translate("Tap", "As chosen under Set up") : name});
  }
  return all;
}

void TapBench::listen(const QString& device) {
  stopListening();
  fileReading_ = {};
  files_.clear();
  listening_ = {};
  listening_.device = device;
  openDevice();
}

void TapBench::openDevice() {
  listening_.state = ui::TapListening::State::Opening;
  listening_.channels.clear();
  if (listening_.device == kSimulated) {
    listener_.listen([pace = pace_, alongY = axis_ == 1]() -> Result<TapListener::Device> {
      daq::SourceRequest request;
      request.settings = {{"axis", alongY ? "y" : "x"}, {"pace", std::to_string(pace)}};
      auto source = daq::makeSource("simulated-hammer", request);
      if (!source) return source.error();
      return TapListener::Device{nullptr, std::move(*source), {}};
    });
    return;
  }
  const QString name = listening_.device.mid(kProfile.size());
  auto chosen = profile ? profile(name) : Result<config::Profile>(Error{message("profile"), message("is missing")});
  if (!chosen) {
    listening_.state = ui::TapListening::State::Failed;
    listening_.problem = ui::sayError(chosen.error());
    return;
  }
  chosen->link = {};
  listener_.listen([chosen = *chosen, path = profilePath(name)]() -> Result<TapListener::Device> {
    auto parts = makeProfileParts(chosen, path);
    if (!parts) return parts.error();
    return TapListener::Device{std::move(parts->clock), std::move(parts->device), chosen.cut.channels};
  });
}

void TapBench::stopListening() {
  end();
  beginning_ = false;
  listener_.stop();
  listening_.state = ui::TapListening::State::Off;
}

// The hammer is the channel of a force.
void TapBench::guessChannels() {
  const auto channels = listener_.channels();
  listening_.rate = listener_.rate();
  for (const ChannelInfo& channel : channels) {
    ui::TapChannel shown;
    shown.name = QString::fromStdString(channel.name);
    shown.unit = QString::fromUtf8(siUnit(channel.quantity).data());
    shown.axis = app::axisOf(channel.axis);
    shown.force = channel.quantity == SensorQuantity::Force;
    shown.usable = quantityOf(channel.quantity).has_value();
    if (shown.force && listening_.force < 0 && !withoutForce_) {
      listening_.force = static_cast<int>(listening_.channels.size());
    }
    listening_.channels.push_back(std::move(shown));
  }
  chooseAlong();
}

// The response: the first along the axis in turn, or the first that is one.
void TapBench::chooseAlong() {
  int first = -1, along = -1;
  for (int c = static_cast<int>(listening_.channels.size()) - 1; c >= 0; --c) {
    const ui::TapChannel& channel = listening_.channels[static_cast<std::size_t>(c)];
    if (!channel.usable) continue;
    first = c;
    if (channel.axis == axis_) along = c;
  }
  listening_.response = along >= 0 ? along : first;
}

void TapBench::meter(const HeardBlock& block) {
  for (std::size_t c = 0; c < block.samples.size() && c < listening_.channels.size(); ++c) {
    ui::TapChannel& channel = listening_.channels[c];
    channel.level *= kMeterFalls;
    for (const double v : block.samples[c]) channel.level = std::max(channel.level, std::abs(v));
    channel.most = std::max(channel.most, channel.level);
    channel.clipped = channel.clipped || block.clipped;
  }
}

void TapBench::hear(const HeardBlock& block) {
  meter(block);
  gap_ = gap_ || block.gap;
  if (!running_ || listening_.response < 0) return;
  Axis& axis = axisOf(axis_);
  static const std::vector<double> kNone;
  const auto& force = listening_.force >= 0 ? block.samples[static_cast<std::size_t>(listening_.force)] : kNone;
  if (!axis.test->feed(force, block.samples[static_cast<std::size_t>(listening_.response)], std::exchange(gap_, false)))
    return;
  showHits(axis);
  fit(axis_);
  if (axis.test->phase() == identify::TapTest::Phase::Enough) running_ = false;
}

bool TapBench::poll() {
  bool news = false;
  const TapListener::State state = listener_.state();
  if (listening_.state == ui::TapListening::State::Opening && state != TapListener::State::Opening &&
      state != TapListener::State::Off) {
    if (!listener_.channels().empty()) guessChannels();
    listening_.state = ui::TapListening::State::Running;
    if (std::exchange(beginning_, false)) begin(axis_);
    news = true;
  }
  for (const HeardBlock& block : listener_.take()) {
    hear(block);
    news = true;
  }
  if (listening_.state == ui::TapListening::State::Running && state == TapListener::State::Ended) {
    // What it had to say before it ended has been taken above.
    listening_.problem = ui::sayCore(listener_.problem());
    listening_.state = ui::TapListening::State::Failed;
    running_ = false;
    news = true;
  }
  for (Axis& axis : axes_) news = axis.fitting.collect() || news;
  news = reading_.collect() || news;
  return computing_.collect() || news;
}

void TapBench::chooseForce(int channel) {
  listening_.force = channel < static_cast<int>(listening_.channels.size()) ? channel : -1;
  withoutForce_ = listening_.force < 0;
  end();
}

void TapBench::chooseResponse(int channel) {
  if (channel < 0 || channel >= static_cast<int>(listening_.channels.size())) return;
  listening_.response = channel;
  end();
}

void TapBench::begin(int axis) {
  if (listening_.state != ui::TapListening::State::Running || listening_.response < 0) return;
  if (axis != std::exchange(axis_, axis)) {
    if (listening_.device == kSimulated) {  // its hammer turns with the axis
      listener_.stop();
      openDevice();
      beginning_ = true;
      return;
    }
    chooseAlong();
  }
  files_.clear();
  fileReading_ = {};
  const auto channels = listener_.channels();
  identify::TapTestOptions options;
  options.withForce = listening_.force >= 0;
  options.catcher.least = options.withForce ? kLeastForce : 0.0;
  options.hammer.useDoubleHits = true;  // which hits count has been decided before the analysis
  options.axis = axis == 1 ? identify::Axis::Y : identify::Axis::X;
  options.quantity = quantityOf(channels[static_cast<std::size_t>(listening_.response)].quantity)
                         .value_or(identify::FrfQuantity::Accelerance);
  Axis& one = axisOf(axis);
  one.test.emplace(listening_.rate.value, options);
  one.fitting.leave();
  one.files.clear();
  take(one, {});
  running_ = true;
  gap_ = false;
}

void TapBench::end() {
  running_ = false;
}

ui::TapRun TapBench::run() const {
  ui::TapRun run;
  run.axis = axis_;
  const Axis& axis = axisOf(axis_);
  if (!axis.test) return run;
  run.good = axis.test->good();
  run.wanted = axis.test->options().enough;
  const auto phase = phaseOf(axis.test->phase());
  if (running_ || phase == ui::TapRun::Phase::Enough) run.phase = phase;
  return run;
}

const std::vector<ui::TapHitRow>& TapBench::hits(int axis) const {
  return axisOf(axis).hits;
}

void TapBench::showHits(Axis& axis) {
  axis.hits.clear();
  for (const identify::TapHit& hit : axis.test->hits()) {
    axis.hits.push_back({hit.peak, Seconds(hit.width), faultOf(hit.fault), hit.used(), {}});
  }
}

void TapBench::useHit(int axis, std::size_t hit, bool use) {
  Axis& one = axisOf(axis);
  if (hit >= one.hits.size()) return;
  if (one.files.isEmpty()) {
    if (!one.test) return;
    one.test->use(hit, use);
    showHits(one);
    return fit(axis);
  }
  std::vector<int>& out = one.reading.without[axis == 1 ? std::size_t{1} : std::size_t{0}];
  const int number = static_cast<int>(hit) + 1;
  const auto at = std::find(out.begin(), out.end(), number);
  if (use && at != out.end()) out.erase(at);
  if (!use && at == out.end()) out.push_back(number);
  readHitsAnew(axis);
}

void TapBench::fit(int axis) {
  Axis& one = axisOf(axis);
  const auto records = one.test->records();
  if (records.empty()) return take(one, {});
  one.known.shown.state = ui::TapResponse::State::Working;
  changed(one.known.shown);
  one.fitting.start(
      ui::TaskState::What::None, {},
      [this, axis, records, options = one.test->options()](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
        return BackgroundTask::Apply(
            [this, axis, found = fromRecords(records, options)]() mutable { take(axisOf(axis), std::move(found)); });
      });
}

void TapBench::take(Axis& axis, TapAxis found) {
  if (!found.hits.empty() || !axis.test) axis.hits = found.hits;
  if (axis.test && axis.test->hits().empty()) axis.hits.clear();
  axis.known = std::move(found);
  changed(axis.known.shown);
  computeAnew();
}

}  // namespace stillcut::app
