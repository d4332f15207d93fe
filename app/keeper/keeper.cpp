#include "app/keeper/keeper.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <utility>

#include "core/cnc/remembering_link.h"

namespace stillcut::app {
namespace {

constexpr int kDone = 0, kWrongUsage = 2, kMachine = 3;
constexpr int kBeginWithin = 5000, kOpenAgain = 200;  // ms
constexpr Duration kPause = std::chrono::milliseconds(5);

// What a keeper before this one has left, as RememberingLink takes it. The record on disk is the program's.
class LeftBehind final : public cnc::OverrideMemory {
 public:
  explicit LeftBehind(const cnc::SentOverrides& left) : left_(left) {}
  std::optional<cnc::SentOverrides> left() const override { return left_; }
  bool fresh() const noexcept override { return true; }
  void keep(const cnc::SentOverrides& /*sent*/) noexcept override {}
  void forget() noexcept override {}

 private:
  cnc::SentOverrides left_;
};

bool sendText(int peer, const std::string& text) {
  return ::send(peer, text.data(), text.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(text.size());
}

}  // namespace

std::optional<KeeperBegin> Keeper::hearBegin() const {
  pollfd entry{peer_, POLLIN, 0};
  if (::poll(&entry, 1, kBeginWithin) <= 0) return std::nullopt;
  std::string text(kLongestKeeperText, '\0');
  const ssize_t n = ::recv(peer_, text.data(), text.size(), MSG_DONTWAIT);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  return keeperBeginFrom(text);
}

Status Keeper::start(const KeeperBegin& begin) {
  auto made = make_(begin);
  if (!made) return made.error();
  link_ = std::move(made).value();
  if (begin.left) {
    // Registers that are ours alone are home to be before they are read; a shared one is not known yet, and compared.
    link_->adopt(Ratio(begin.left->speed.base * 0.01), Ratio(begin.left->feed.base * 0.01));
    left_ = std::make_shared<cnc::SentOverridesCell>();
    link_ = std::make_unique<cnc::RememberingLink>(std::move(link_), std::make_unique<LeftBehind>(*begin.left), left_);
  }
  return link_->open();
}

bool Keeper::programHasGone() const {
  char byte = 0;
  const ssize_t n = ::recv(peer_, &byte, sizeof byte, MSG_PEEK | MSG_DONTWAIT);
  return n == 0 || (n < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
}

int Keeper::run() {
  const auto begin = hearBegin();
  if (!begin) return kWrongUsage;
  mayStand_ = begin->left.has_value();
  Status started = start(*begin);
  // With nobody left who would start another one, a machine that is away is waited for as it is by a keeper that runs.
  const Instant until = clock_.now() + kWayHome;
  while (!started && link_ && mayStand_ && programHasGone() && clock_.now() < until) {
    ::poll(nullptr, 0, kOpenAgain);
    started = link_->open();
  }
  KeeperOpened opened;
  if (link_) opened.label = link_->describe().label;
  if (!started) opened.refused = started.error();
  // A program that has gone since does not hear it, and what a keeper before this one left is brought back all the
  // same.
  (void)sendText(peer_, toText(opened));
  if (!started) return kMachine;
  alive_ = clock_.now();
  while (!done()) turn();
  link_->close();
  return kDone;
}

bool Keeper::done() const noexcept {
  if (overSince_ == Instant{}) return false;  // no turn has let go yet: that the program went was seen in a pause
  return !mayStand_ || clock_.now() - overSince_ > kWayHome;
}

// Whatever has come since the last look: the newest Set counts, a Release is obeyed in its place. True: there was more
// than a sign of life.
bool Keeper::hear() noexcept {
  std::optional<KeeperOrder> set;
  bool ordered = false;
  while (!gone_ && !closing_) {
    KeeperOrder order;
    const ssize_t n = ::recv(peer_, &order, sizeof order, MSG_DONTWAIT | MSG_TRUNC);
    if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      gone_ = true;
      break;
    }
    if (n != static_cast<ssize_t>(sizeof order)) continue;
    alive_ = clock_.now();
    if (order.kind == KeeperOrder::Kind::Life) continue;
    ordered = true;
    if (order.kind == KeeperOrder::Kind::Set) {
      set = order;
      continue;
    }
    if (set) obey(*std::exchange(set, std::nullopt), alive_);
    obey(order, alive_);
  }
  if (set && !gone_) obey(*set, alive_);
  return ordered || gone_;
}

void Keeper::obey(const KeeperOrder& order, Instant now) noexcept {
  switch (order.kind) {
    case KeeperOrder::Kind::Set: {
      const auto command = order.carried();
      if (!command || command->engagement() <= endedEngagement_) return;
      engagement_ = command->engagement();
      inForce_ = mayStand_ = true;
      released_.set();
      link_->apply(*command, now);
      return;
    }
    case KeeperOrder::Kind::Release:
      inForce_ = false;
      released_.release(now);
      link_->release(now);
      releaseNumber_ = order.number;
      return;
    case KeeperOrder::Kind::Adopt: {
      mayStand_ = true;
      const auto given = [](double r) { return std::isfinite(r) ? std::optional(Ratio(r)) : std::nullopt; };
      link_->adopt(given(order.speed), given(order.feed));
      return;
    }
    case KeeperOrder::Kind::Close:
      closing_ = true;
      return;
    case KeeperOrder::Kind::Life:
      return;
  }
}

void Keeper::letGo(Instant now) noexcept {
  if (!std::exchange(inForce_, false)) return;
  endedEngagement_ = std::max(endedEngagement_, engagement_);
  released_.release(now);
  link_->release(now);
}

void Keeper::turn() noexcept {
  hear();
  const Instant now = clock_.now();
  const bool over = gone_ || closing_ || toEnd_();
  if (over && overSince_ == Instant{}) overSince_ = now;
  if (over || now - alive_ > kKeeperPatience) letGo(now);
  // Letting go may have taken a second: what was heard before it is not new by the clock of then.
  const MachineState state = link_->read(clock_.now());
  released_.look(state);
  const bool leftStands = left_ && left_->get();
  if (leftStands) {  // nothing is told before: what was left stands in the operator's place
    released_.release(clock_.now());
    link_->release(clock_.now());
  } else {
    report(state);
  }
  if (state.valid && !inForce_ && !leftStands && !released_.notYetBack()) mayStand_ = false;
  pause();
}

// The link's own pace, as a run gives it. An order ends the pause, and the program's end.
void Keeper::pause() noexcept {
  const Instant until = clock_.now() + kPause;
  for (Duration left = kPause; left > Duration::zero(); left = until - clock_.now()) {
    pollfd entry{gone_ || closing_ ? -1 : peer_, POLLIN, 0};
    const timespec limit{0, static_cast<long>(left.count())};
    if (::ppoll(&entry, 1, &limit, nullptr) > 0 && hear()) return;
  }
}

// One that the program does not take is lost: it hangs, and the next one tells the same.
void Keeper::report(MachineState state) noexcept {
  if (gone_) return;
  KeeperReport r;
  state.endedEngagement = endedEngagement_;
  r.state = state;
  r.released = releaseNumber_;
  r.take(link_->describe());
  (void)!::send(peer_, &r, sizeof r, MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace stillcut::app
