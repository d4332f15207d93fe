// RunTranslator: from the lines of a run (`stillcut-cli run --json`, resources/manual/scripts.md) to what a shop is
// told. It remembers what was told last, so that a state is told once; memory() and recall() carry that over a restart.
// Thread: one.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/shop/shop_message.h"

namespace stillcut::shop {

class RunTranslator {
 public:
  RunTranslator();
  RunTranslator(const RunTranslator&) = delete;  // a copy would tell everything a second time
  RunTranslator& operator=(const RunTranslator&) = delete;

  // One line in the order of the run. What it does not know it passes over: a newer program may say more.
  std::vector<ShopMessage> take(const nlohmann::json& line);

  nlohmann::json memory() const;
  void recall(const nlohmann::json& memory);

 private:
  void start(const nlohmann::json& line);
  void state(const nlohmann::json& line, bool status);
  void alarm(const nlohmann::json& line);
  void endAlarm(std::int64_t utcMs, const nlohmann::json& line, const char* how);
  void event(const nlohmann::json& line);
  void silent(const nlohmann::json& line, const char* reason);
  void lost(const nlohmann::json& line);
  nlohmann::json about(const nlohmann::json& line) const;
  void tell(std::string topic, nlohmann::json payload, bool retained = false);

  nlohmann::json run_;    // what every message says of its run: run, machine, job, tool
  nlohmann::json state_;  // as told last; null: nothing yet
  nlohmann::json alarm_;  // the one that goes on, as its begin was told; null: none
  std::int64_t featuresUtcMs_ = 0;
  std::int64_t newestUtcMs_ = 0;  // of the run's lines
  std::uint64_t lines_ = 0;       // of this run: number of the newest
  bool statusComes_ = false;
  std::vector<ShopMessage> told_;
};

}  // namespace stillcut::shop
