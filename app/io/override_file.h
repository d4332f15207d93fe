// OverrideFile: the record of what stands in one machine, as a file of a few words that a thread of its own writes and
// removes. Nobody waits for its disk: what cannot be written is not on record, and the machine is steered all the same.
// Thread: made and destroyed on the set-up thread; keep() and forget() on the link thread, real-time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/cnc/override_memory.h"
#include "core/rt/realtime_thread.h"
#include "core/rt/wakeup.h"

namespace stillcut::app {

class OverrideFile final : public cnc::OverrideMemory {
 public:
  // `machine`: name and address, whatever letters it has. The folder is made when something is kept.
  OverrideFile(const std::filesystem::path& folder, const std::string& machine);
  ~OverrideFile() override;  // what was said last is on the disk

  std::optional<cnc::SentOverrides> left() const override { return left_; }
  void keep(const cnc::SentOverrides& sent) noexcept override { wanted_.set(sent); }
  void forget() noexcept override { wanted_.set(std::nullopt); }
  const std::filesystem::path& file() const { return file_; }

 private:
  void run(const std::stop_token& stop);
  void write();

  std::filesystem::path file_;
  std::string machine_;
  std::optional<cnc::SentOverrides> left_;
  cnc::SentOverridesCell wanted_;              // to be on record
  std::optional<cnc::SentOverrides> written_;  // the thread's
  Instant nextTry_{};                          // after one that failed
  rt::Wakeup wakeup_;
  std::optional<rt::RealtimeThread> thread_;  // last: joined before what it uses goes
};

}  // namespace stillcut::app
