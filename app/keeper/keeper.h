// Keeper: the far end of KeptLink. It holds one machine's link, obeys the orders of the program that started it, and
// goes home when that program gives no sign of life for kKeeperPatience or has gone. An engagement that ended so is
// over: no later Set of its number is obeyed. After the program's death, and after its end in order, it stays until the
// machine shows the operator's values, kWayHome at most, where anything of ours may stand in it. Thread: one.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/io/keeper_messages.h"
#include "core/cnc/cnc_link.h"
#include "core/safety/release_watch.h"

namespace stillcut::app {

class Keeper {
 public:
  using LinkMaker = std::function<Result<std::unique_ptr<cnc::CncLink>>(const KeeperBegin& begin)>;
  // `toEnd`: it was told to end itself.
  Keeper(int peer, const Clock& clock, LinkMaker make, const std::function<bool()>& toEnd)
      : peer_(peer), clock_(clock), make_(std::move(make)), toEnd_(toEnd) {}
  // Until nothing is left to be done. The exit code.
  int run();

  static constexpr Duration kWayHome = std::chrono::seconds(10);

 private:
  std::optional<KeeperBegin> hearBegin() const;
  Status start(const KeeperBegin& begin);
  bool programHasGone() const;
  bool hear() noexcept;
  void obey(const KeeperOrder& order, Instant now) noexcept;
  void letGo(Instant now) noexcept;
  void turn() noexcept;
  void report(MachineState state) noexcept;
  bool done() const noexcept;
  void pause() noexcept;

  int peer_;
  const Clock& clock_;
  LinkMaker make_;
  std::function<bool()> toEnd_;
  std::unique_ptr<cnc::CncLink> link_;
  std::shared_ptr<cnc::SentOverridesCell> left_;  // of a keeper before, that is to be brought back
  safety::ReleaseWatch released_;
  bool gone_ = false, closing_ = false;
  bool inForce_ = false;
  bool mayStand_ = false;  // something of ours in the machine: until it was read back after a release
  std::uint64_t engagement_ = 0, endedEngagement_ = 0, releaseNumber_ = 0;
  Instant alive_{}, overSince_{};
};

}  // namespace stillcut::app
