// ProgramLog: one file of lines with time of day, level and process: what "it happened on Tuesday" is answered from.
// $XDG_STATE_HOME/stillcut/stillcut.log, else ~/.local/state/stillcut/stillcut.log; at 2 MB it becomes stillcut.1.log,
// and four older ones are kept. Lines are in English, whatever the screen speaks. Two programs may write at once.
// Thread: any; write() waits for the disk: never on a real-time thread.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "core/base/result.h"

namespace spdlog {
class logger;
}

namespace stillcut::app {

enum class LogLevel { Info, Warning, Error, Off };
std::optional<LogLevel> logLevelFrom(std::string_view name);  // "info", "warning", "error", "off"

std::filesystem::path defaultLogFile();

class ProgramLog {
 public:
  ProgramLog() = default;  // writes nothing
  // Makes the folder. An error: nothing can be written there; the program goes on without.
  static Result<ProgramLog> open(const std::filesystem::path& file, LogLevel lowest);

  void write(LogLevel level, std::string_view line) const;

 private:
  std::shared_ptr<spdlog::logger> logger_;
};

}  // namespace stillcut::app
