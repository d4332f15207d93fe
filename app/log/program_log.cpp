#include "app/log/program_log.h"

#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/spdlog.h>

#include <array>
#include <string>
#include <utility>

#include "app/compose/resource_folder.h"

namespace stillcut::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFileBytes = 2'000'000;  // some 20,000 lines
constexpr std::size_t kOlderFiles = 4;

constexpr std::array<std::pair<std::string_view, LogLevel>, 4> kNames{
    {{"info", LogLevel::Info}, {"warning", LogLevel::Warning}, {"error", LogLevel::Error}, {"off", LogLevel::Off}}};

spdlog::level::level_enum spdlogLevel(LogLevel level) {
  switch (level) {
    case LogLevel::Info:
      return spdlog::level::info;
    case LogLevel::Warning:
      return spdlog::level::warn;
    case LogLevel::Error:
      return spdlog::level::err;
    case LogLevel::Off:
      break;
  }
  return spdlog::level::off;
}

}  // namespace

std::optional<LogLevel> logLevelFrom(std::string_view name) {
  for (const auto& [known, level] : kNames) {
    if (known == name) return level;
  }
  return std::nullopt;
}

fs::path defaultLogFile() {
  return userFolder("XDG_STATE_HOME", ".local/state") / "stillcut.log";
}

Result<ProgramLog> ProgramLog::open(const fs::path& file, LogLevel lowest) {
  ProgramLog log;
  if (lowest == LogLevel::Off) return log;
  try {
    auto sink = std::make_shared<spdlog::sinks::rotating_file_sink_mt>(file.string(), kFileBytes, kOlderFiles);
    log.logger_ = std::make_shared<spdlog::logger>("stillcut", std::move(sink));
  } catch (const spdlog::spdlog_ex& e) {
    return Error{file.string(), message("the log cannot be written there"), foreign(e.what())};
  }
  log.logger_->set_level(spdlogLevel(lowest));
  log.logger_->set_pattern("%Y-%m-%d %H:%M:%S.%e%z [%P] %l: %v");
  log.logger_->flush_on(spdlog::level::info);  // few lines; the last before a crash is the one that is looked for
  // A disk that fills up must not fill the terminal: the program goes on, the lines are lost.
  log.logger_->set_error_handler([](const std::string&) {});
  return log;
}

void ProgramLog::write(LogLevel level, std::string_view line) const {
  if (logger_) logger_->log(spdlogLevel(level), line);
}

}  // namespace stillcut::app
