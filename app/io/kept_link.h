// KeptLink: a machine's link in a process of its own (stillcut-keeper), which holds the wire as a lease: once this
// program dies, hangs or is killed it brings the operator's values back, by the same link that moved them. Here is its
// near end: orders go out, states come back, at the pace of the link. A keeper that dies or hangs is started anew and
// brings back what its predecessor left. One that is not home when the program ends stays behind. Thread: as CncLink.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/io/keeper_process.h"
#include "core/cnc/registry.h"
#include "core/cnc/release_budget.h"
#include "core/safety/release_watch.h"

namespace stillcut::app {

// Analog outputs hold a voltage from open() on; a trial leaves them as they are.
enum class AnalogOutputs { Written, LeftAlone };

// makeOneProgramLink(), kept so. Without a keeper: simulated machines; those behind stillcut-hal, which is one itself;
// and where the program stillcut-keeper is missing, which LinkInfo::kept tells.
Result<std::unique_ptr<cnc::CncLink>> makeKeptLink(std::string_view id, const cnc::LinkRequest& request,
                                                   AnalogOutputs outputs = AnalogOutputs::Written,
                                                   const std::string& locks = "");

class KeptLink final : public cnc::CncLink {
 public:
  // `known`: what its link says of itself before it is opened. `clock` is steady: the keeper has the same.
  KeptLink(KeeperBegin begin, const cnc::LinkInfo& known, const Clock& clock);
  ~KeptLink() override;

  cnc::LinkInfo describe() const override;
  Status open() override;
  MachineState read(Instant now) noexcept override;
  void apply(const OverrideCommand& command, Instant now) noexcept override;
  void release(Instant now) noexcept override;
  void adopt(std::optional<Ratio> speed, std::optional<Ratio> feed) noexcept override;
  void close() noexcept override;

  static constexpr Duration kWait = std::chrono::milliseconds(6);
  // As long as the longest way home of a link, and a look more.
  static constexpr Duration kReleaseTime = std::chrono::milliseconds(1200);

 private:
  void look(Duration atMost, Instant now) noexcept;
  void startAgain(Instant now) noexcept;
  void lost(Instant now) noexcept;
  void sendEnd() noexcept;

  KeeperBegin begin_;
  std::string id_, label_;
  cnc::LinkInfo info_;
  const Clock& clock_;
  KeeperProcess keeper_;
  KeeperReport report_;
  bool heardFirst_ = false;
  bool inForce_ = false;
  Instant heard_{}, nextTry_{};
  std::uint64_t releases_ = 0;
  std::uint64_t engagement_ = 0, endedEngagement_ = 0;
  std::optional<cnc::SentOverrides> sent_;  // what may stand in the machine, until it was read back after a release
  safety::ReleaseWatch released_;
  cnc::ReleaseBudget releaseBudget_;
};

}  // namespace stillcut::app
