#include "app/cli/run/run_times.h"

#include <chrono>
#include <cstdio>
#include <ctime>

namespace stillcut::app {
namespace {

std::int64_t ms(Instant t) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(t.time_since_epoch()).count();
}

}  // namespace

std::int64_t utcNowMs() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

std::string timeOfDay(std::int64_t utcMs) {
  const std::time_t whole = utcMs / 1000;
  std::tm local{};
  localtime_r(&whole, &local);
  char text[32];
  std::snprintf(text, sizeof text, "%02d:%02d:%02d.%03d", local.tm_hour % 100, local.tm_min % 100, local.tm_sec % 100,
                static_cast<int>(utcMs % 1000));
  return text;
}

void RunTimes::look(const Snapshot& snapshot) {
  if (!begin_) {
    const double heard_s = static_cast<double>(snapshot.health.blocks) * snapshot.health.blockLength.value;
    begin_ = snapshot.time - toDuration(Seconds{heard_s});
  }
  // Anew at every look: the time of day may be set while the run goes on.
  offsetMs_ = utcNowMs() - ms(live_ ? SteadyClock().now() : snapshot.time);
}

std::int64_t RunTimes::utcMs(Instant t) const {
  return begin_ ? ms(t) + offsetMs_ : utcNowMs();
}

std::optional<Seconds> RunTimes::sinceBegin(Instant t) const {
  return begin_ ? std::optional(secondsBetween(*begin_, t)) : std::nullopt;
}

}  // namespace stillcut::app
