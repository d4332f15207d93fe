#include "app/io/kept_link.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/io/one_program_link.h"

namespace stillcut::app {
namespace {

constexpr Duration kRetry = std::chrono::milliseconds(500);
// A board that starts anew when its port opens is waited for by the link for 4 s and 3 s more; and a start.
constexpr Duration kOpenTime = std::chrono::seconds(10);
// A keeper is busy with a peer that hangs for as long as its way home may take; beyond that it hangs itself.
constexpr Duration kLongestSilence = std::chrono::seconds(2);
constexpr Duration kLook = std::chrono::milliseconds(100);

int percentOf(Ratio r) noexcept {
  return isFinite(r) ? static_cast<int>(std::lround(100.0 * r.value)) : 100;
}

cnc::SentOverride sentOn(Ratio base, Ratio ours) noexcept {
  return {percentOf(base), percentOf(Ratio(base.value * ours.value))};
}

}  // namespace

Result<std::unique_ptr<cnc::CncLink>> makeKeptLink(std::string_view id, const cnc::LinkRequest& request,
                                                   AnalogOutputs outputs, const std::string& locks) {
  auto plain = makeOneProgramLink(id, request, locks);  // says what is wrong with the settings
  if (!plain) return plain;
  const auto component = request.settings.find("hal_component_port");
  const bool itself = component != request.settings.end() && component->second != "0";
  if ((*plain)->describe().simulated || itself || KeeperProcess::program().empty()) return plain;
  const KeeperBegin begin{std::string(id),
                          request.settings,
                          request.folder,
                          request.programmedSpeed,
                          request.programmedFeed,
                          outputs == AnalogOutputs::LeftAlone,
                          locks,
                          ::getpid(),
                          {}};
  return std::unique_ptr<cnc::CncLink>(std::make_unique<KeptLink>(begin, (*plain)->describe(), *request.clock));
}

KeptLink::KeptLink(KeeperBegin begin, const cnc::LinkInfo& known, const Clock& clock)
    : begin_(std::move(begin)),
      id_(known.id),
      label_(known.label),
      info_(known),
      clock_(clock),
      releaseBudget_(clock, kReleaseTime) {
  begin_.settings.erase(std::string(cnc::kSavedDelay));
  begin_.settings.erase(std::string(cnc::kSavedEffect));
}

KeptLink::~KeptLink() {
  KeptLink::close();
}

cnc::LinkInfo KeptLink::describe() const {
  cnc::LinkInfo info = info_;
  info.id = id_;
  info.label = label_;
  info.kept = true;
  return info;
}

Status KeptLink::open() {
  begin_.left.reset();
  heardFirst_ = false;
  if (!keeper_.start(begin_)) {
    return Error{KeeperProcess::program(), message("does not start"), message("is the installation complete?")};
  }
  const Instant began = clock_.now();
  std::optional<KeeperOpened> opened;
  while (!opened && keeper_.running() && clock_.now() - began < kOpenTime) opened = keeper_.opened(kLook);
  if (opened && !opened->refused) {
    label_ = opened->label;
    heard_ = clock_.now();
    while (!heardFirst_ && keeper_.running() && clock_.now() - began < kOpenTime) look(kLook, clock_.now());
    if (keeper_.running()) return Done{};
  }
  keeper_.kill();
  (void)keeper_.bury(kLongestSilence);
  if (opened && opened->refused) return *opened->refused;
  return Error{KeeperProcess::program(), message("gives no answer"), message("is the installation complete?")};
}

void KeptLink::startAgain(Instant now) noexcept {
  begin_.left = sent_;
  nextTry_ = now + kRetry;
  heard_ = now;
  heardFirst_ = false;
  (void)keeper_.start(begin_);
}

// It let go with its last breath, or its successor does: what was in force is over.
void KeptLink::lost(Instant now) noexcept {
  keeper_.kill();
  (void)keeper_.bury({});
  if (std::exchange(inForce_, false)) endedEngagement_ = std::max(endedEngagement_, engagement_);
  if (sent_) released_.release(now);
  report_ = {};
  releases_ = 0;
  nextTry_ = std::max(nextTry_, now);
}

void KeptLink::look(Duration atMost, Instant now) noexcept {
  if (!keeper_.greeted()) {
    const auto opened = keeper_.opened(atMost);
    if (opened && opened->refused) return lost(now);  // the machine is away, or somebody else has it
    if (!opened) return;
    atMost = Duration::zero();
  }
  const auto report = keeper_.newest(atMost);
  if (!report) return;
  report_ = *report;
  report_.giveTo(info_);
  endedEngagement_ = std::max(endedEngagement_, report_.state.endedEngagement);
  inForce_ = inForce_ && engagement_ > endedEngagement_;
  heardFirst_ = true;
  heard_ = now;
}

MachineState KeptLink::read(Instant now) noexcept {
  if (!keeper_.running() && now >= nextTry_) startAgain(now);
  const bool was = keeper_.running();
  (void)keeper_.send({});
  look(kWait, now);
  // Asked after the look: what it has said while nobody read it counts.
  const bool hangs = now - heard_ > (heardFirst_ ? kLongestSilence : kOpenTime);
  if (was && (hangs || !keeper_.running())) lost(now);
  MachineState m = report_.state;
  m.endedEngagement = endedEngagement_;
  if (!m.valid) return m;
  releaseBudget_.anew();
  // Read back after the keeper had obeyed: a successor has nothing to bring back.
  if (report_.released >= releases_) released_.look(m);
  if (!inForce_ && !released_.notYetBack()) sent_.reset();
  return m;
}

void KeptLink::apply(const OverrideCommand& command, Instant now) noexcept {
  if (command.kind() != CommandKind::Set) return release(now);
  releaseBudget_.anew();
  if (command.engagement() <= endedEngagement_) return;
  engagement_ = command.engagement();
  inForce_ = true;
  released_.set();
  const MachineState& m = report_.state;
  if (m.valid) sent_ = {sentOn(m.operatorSpeed, command.speed()), sentOn(m.operatorFeed, command.feed())};
  KeeperOrder order;
  order.carry(command);
  if (keeper_.running() && !keeper_.send(order) && !keeper_.running()) lost(now);
}

void KeptLink::release(Instant now) noexcept {
  inForce_ = false;
  released_.release(now);
  if (!keeper_.running()) return;  // the next one brings it back
  KeeperOrder order;
  order.kind = KeeperOrder::Kind::Release;
  order.number = ++releases_;
  if (!keeper_.send(order)) {
    if (!keeper_.running()) lost(now);
    return;
  }
  releaseBudget_.run(
      now, kWait, [&] { return report_.released >= releases_ || !keeper_.running(); },
      [&](Instant at) { look(kWait, at); });
}

void KeptLink::adopt(std::optional<Ratio> speed, std::optional<Ratio> feed) noexcept {
  KeeperOrder order;
  order.kind = KeeperOrder::Kind::Adopt;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  order.speed = speed ? speed->value : kNone;
  order.feed = feed ? feed->value : kNone;
  (void)keeper_.send(order);
}

// The way home is waited for as long as it takes on a good wire. A keeper that needs longer goes on without this
// program; one that is dead or gives no sign of life is replaced by one that does.
void KeptLink::close() noexcept {
  if (keeper_.running()) release(clock_.now());
  if (keeper_.running()) sendEnd();
  if (!keeper_.running() && sent_) startAgain(clock_.now());
  keeper_.leave();
  sent_.reset();
  report_ = {};
  releases_ = 0;
  heardFirst_ = false;
  nextTry_ = {};
}

void KeptLink::sendEnd() noexcept {
  (void)keeper_.newest({});
  KeeperOrder order;
  order.kind = KeeperOrder::Kind::Close;
  (void)keeper_.send(order);
  const Instant began = clock_.now();
  bool alive = false;
  while (!keeper_.bury(kWait)) {
    alive = keeper_.newest({}).has_value() || alive;
    if (clock_.now() - began < (alive ? kReleaseTime : kLongestSilence)) continue;
    if (alive) return;
    keeper_.kill();
    (void)keeper_.bury(kLongestSilence);
    break;
  }
  keeper_.leave();
  if (keeper_.endedInOrder()) sent_.reset();
}

}  // namespace stillcut::app
