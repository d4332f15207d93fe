#include "core/cnc/grbl/grbl_status.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/cnc/wire_number.h"

namespace stillcut::cnc {
namespace {

constexpr double kMost = 1e6;  // rev/min or units/min: more is noise on the line

std::optional<double> sane(std::string_view word) noexcept {
  const auto value = wireNumber(word);
  return value && *value >= 0.0 && *value <= kMost ? value : std::nullopt;
}

GrblState stateOf(std::string_view word) noexcept {
  const std::string_view name = word.substr(0, word.find(':'));
  if (name == "Idle") return GrblState::Idle;
  if (name == "Run" || name == "Jog") return GrblState::Run;
  if (name == "Hold" || name == "Door" || name == "Tool") return GrblState::Hold;
  if (name == "Alarm") return GrblState::Alarm;
  return GrblState::Other;
}

void takeField(std::string_view field, GrblReport& r) noexcept {
  const std::size_t colon = field.find(':');
  if (colon == std::string_view::npos) return;
  const std::string_view name = field.substr(0, colon);
  std::string_view values = field.substr(colon + 1);
  if (name == "FS" || name == "F") {
    r.feed = sane(takeToken(values, ','));
    if (name == "FS") r.speed = sane(takeToken(values, ','));
    if (name == "FS" && !values.empty()) r.measuredSpeed = sane(takeToken(values, ','));
  } else if (name == "Ov") {
    const auto feed = sane(takeToken(values, ','));
    takeToken(values, ',');  // rapids
    const auto speed = sane(takeToken(values, ','));
    if (!feed || !speed || *feed > kGrblHighest || *speed > kGrblHighest) return;
    r.feedOverride = static_cast<int>(std::lround(*feed));
    r.speedOverride = static_cast<int>(std::lround(*speed));
  }
}

bool takeWords(std::string_view text, GrblWords& into) noexcept {
  GrblWords words;
  bool feed = false;
  bool speed = false;
  while (true) {
    const std::string_view word = takeToken(text);
    if (word.empty()) break;
    if (word == "G20") words.inches = true;
    const auto value = word.front() == 'F' || word.front() == 'S' ? sane(word.substr(1)) : std::nullopt;
    if (!value) continue;
    (word.front() == 'F' ? words.feed : words.speed) = *value;
    (word.front() == 'F' ? feed : speed) = true;
  }
  if (!feed || !speed) return false;
  into = words;
  return true;
}

}  // namespace

GrblLine readGrblLine(std::string_view line, GrblReport& report, GrblWords& words) noexcept {
  if (line.starts_with("Grbl") && line.find("help") != std::string_view::npos) return GrblLine::Welcome;
  if (line.starts_with("ALARM:")) return GrblLine::AlarmNote;
  if (line.starts_with("[GC:") && line.ends_with("]")) {
    return takeWords(line.substr(4, line.size() - 5), words) ? GrblLine::Words : GrblLine::Other;
  }
  if (line.size() < 3 || !line.starts_with("<") || !line.ends_with(">")) return GrblLine::Other;
  std::string_view fields = line.substr(1, line.size() - 2);
  report = GrblReport{};
  report.state = stateOf(takeToken(fields, '|'));
  while (!fields.empty()) takeField(takeToken(fields, '|'), report);
  return GrblLine::Report;
}

GrblSteps stepToward(int target, int present, unsigned char firstByte) noexcept {
  GrblSteps steps;
  target = std::clamp(target, kGrblLowest, kGrblHighest);
  steps.percent = steps.coarseAlone = steps.fineAlone = present;
  const int away = target - present;
  if (target == 100 && away != 0) {
    steps.coarse = firstByte;
    steps.percent = steps.coarseAlone = 100;
    return steps;
  }
  // Never beyond the target, not for one round: what the operator or the gate's limits allow ends there.
  const int sign = away > 0 ? 1 : -1;
  if (std::abs(away) >= 10) {
    steps.coarse = static_cast<unsigned char>(firstByte + (sign > 0 ? 1 : 2));
    steps.percent += 10 * sign;
  }
  steps.coarseAlone = steps.percent;
  if (std::abs(away) % 10 != 0) {
    steps.fine = static_cast<unsigned char>(firstByte + (sign > 0 ? 3 : 4));
    steps.percent += sign;
    steps.fineAlone = present + sign;
  }
  return steps;
}

}  // namespace stillcut::cnc
