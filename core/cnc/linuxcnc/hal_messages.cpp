#include "core/cnc/linuxcnc/hal_messages.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/cnc/wire_number.h"

namespace stillcut::cnc {
namespace {

constexpr double kMostPercent = 1000.0;
constexpr double kLongestWatchdog = 10000.0;
constexpr std::array<std::string_view, 5> kStandings{"UNPROVEN", "HOME", "HELD", "TAKEN", "FALLEN"};

std::optional<int> whole(std::string_view word, double most) noexcept {
  const auto value = wireNumber(word);
  if (!value || *value < 0.0 || *value > most || *value != std::floor(*value)) return std::nullopt;
  return static_cast<int>(*value);
}

std::optional<double> share(std::string_view word) noexcept {
  const auto value = wireNumber(word);
  return value && *value >= 0.0 && *value <= 1.0 ? value : std::nullopt;
}

// "-" leaves the knob alone; false: neither that nor a percentage.
bool knob(std::string_view word, std::optional<int>& into) noexcept {
  into = whole(word, kMostPercent);
  return into || word == "-";
}

class Line {
 public:
  explicit Line(std::span<char, kHalLine> into) : into_(into) {}
  Line& word(std::string_view text) noexcept {
    if (size_ > 0) into_[size_++] = ' ';
    size_ += text.copy(into_.data() + size_, text.size());
    return *this;
  }
  Line& number(int value) noexcept {
    std::array<char, 12> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return word({digits.data(), static_cast<std::size_t>(end - digits.data())});
  }
  Line& share(double value) noexcept {
    std::array<char, 12> digits{};
    const double bounded = std::clamp(value, 0.0, 1.0);
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), bounded, std::chars_format::fixed, 3).ptr;
    return word({digits.data(), static_cast<std::size_t>(end - digits.data())});
  }
  Line& knob(const std::optional<int>& percent) noexcept { return percent ? number(*percent) : word("-"); }
  std::string_view end() noexcept {
    into_[size_++] = '\n';
    return {into_.data(), size_};
  }

 private:
  std::span<char, kHalLine> into_;
  std::size_t size_ = 0;
};

}  // namespace

std::optional<HalRequest> readHalRequest(std::string_view line) noexcept {
  HalRequest r;
  const std::string_view verb = takeToken(line);
  r.hold = verb == "set";
  if (!r.hold && verb != "home") return std::nullopt;
  if (r.hold) {
    if (!knob(takeToken(line), r.speed) || !knob(takeToken(line), r.feed)) return std::nullopt;
    const auto adaptive = share(takeToken(line));
    if (!adaptive) return std::nullopt;
    r.adaptiveFeed = *adaptive;
  }
  const auto speed = whole(takeToken(line), kMostPercent);
  const auto feed = whole(takeToken(line), kMostPercent);
  if (!speed || !feed || !takeToken(line).empty()) return std::nullopt;
  r.restoreSpeed = *speed;
  r.restoreFeed = *feed;
  return r;
}

std::optional<HalReport> readHalReport(std::string_view line) noexcept {
  HalReport r;
  const std::string_view name = takeToken(line);
  const auto* const standing = std::find(kStandings.begin(), kStandings.end(), name);
  if (standing == kStandings.end()) return std::nullopt;
  r.standing = static_cast<HalLeaseState>(standing - kStandings.begin());
  const auto speed = whole(takeToken(line), kMostPercent);
  const auto feed = whole(takeToken(line), kMostPercent);
  const auto adaptive = share(takeToken(line));
  const auto watchdog = whole(takeToken(line), kLongestWatchdog);
  if (!speed || !feed || !adaptive || !watchdog || !takeToken(line).empty()) return std::nullopt;
  r.speed = *speed;
  r.feed = *feed;
  r.adaptiveFeed = *adaptive;
  r.watchdogMs = *watchdog;
  return r;
}

std::string_view writeHalRequest(const HalRequest& r, std::span<char, kHalLine> into) noexcept {
  Line line(into);
  line.word(r.hold ? "set" : "home");
  if (r.hold) line.knob(r.speed).knob(r.feed).share(r.adaptiveFeed);
  return line.number(r.restoreSpeed).number(r.restoreFeed).end();
}

std::string_view writeHalReport(const HalReport& r, std::span<char, kHalLine> into) noexcept {
  return Line(into)
      .word(kStandings[static_cast<std::size_t>(r.standing)])
      .number(r.speed)
      .number(r.feed)
      .share(r.adaptiveFeed)
      .number(r.watchdogMs)
      .end();
}

}  // namespace stillcut::cnc
