#include "core/learn/cut_evidence.h"

#include <cctype>
#include <cmath>
#include <cstdio>
#include <random>

namespace stillcut::learn {

std::string_view name(CutOutcome outcome) {
  return outcome == CutOutcome::Chatter ? "chatter" : "stable";
}

namespace {

// "48" stands in "HSK63, stick-out 48" and not in "480" or "48.5".
bool namesNumber(const std::string& words, const std::string& number) {
  const auto partOfOne = [&](std::size_t at) {
    return at < words.size() && (std::isdigit(static_cast<unsigned char>(words[at])) != 0 || words[at] == '.');
  };
  for (std::size_t at = words.find(number); at != std::string::npos; at = words.find(number, at + 1)) {
    if ((at == 0 || !partOfOne(at - 1)) && !partOfOne(at + number.size())) return true;
  }
  return false;
}

}  // namespace

Assembly byNameAlone(const Assembly& assembly) {
  Assembly alone{assembly.machine, assembly.tool, {}, {}};
  if (!assembly.holder.empty()) alone.tool += ' ' + assembly.holder;
  if (!(assembly.stickOut.value > 0.0)) return alone;
  char stickOut[32];
  std::snprintf(stickOut, sizeof stickOut, "%g", 1e3 * assembly.stickOut.value);
  if (!namesNumber(assembly.holder, stickOut)) alone.tool += std::string(" stick-out ") + stickOut;
  return alone;
}

Status check(const CutEvidence& cut, const std::string& where) {
  const auto bad = [&](Message what) { return Status(Error{where, std::move(what)}); };
  const auto within = [](double value, double low, double high) {
    return std::isfinite(value) && value > low && value <= high;
  };
  if (cut.assembly.machine.empty() || cut.assembly.tool.empty()) return bad(message("machine and tool must be named"));
  if (cut.teeth < 1 || cut.teeth > milling::kMostTeeth) return bad(message("teeth must be 1 to 200"));
  if (!within(cut.diameter.value, 0.0, 1.0)) return bad(message("diameter must lie above 0 and up to 1000 mm"));
  if (!within(cut.speed.value, 0.0, 1e6)) return bad(message("speed must lie above 0 and up to 1e6 rpm"));
  if (!within(cut.depth.value, 0.0, 1.0)) return bad(message("depth must lie above 0 and up to 1000 mm"));
  if (!within(cut.engagement.radialImmersion, 0.0, 1.0)) return bad(message("radial immersion must lie in (0, 1]"));
  if (!(cut.doubt >= 0.0 && cut.doubt <= 0.5)) return bad(message("doubt must lie between 0 and 0.5"));
  const bool frequency = cut.frequency.value >= 0.0 && cut.frequency.value <= 1e5 && cut.frequencySd.value >= 0.0 &&
                         std::isfinite(cut.frequencySd.value);
  if (!frequency) return bad(message("chatter frequency must lie between 0 and 100 kHz"));
  if (!(cut.assembly.stickOut.value >= 0.0 && cut.assembly.stickOut.value <= 2.0)) {
    return bad(message("stick-out must lie between 0 and 2000 mm"));
  }
  return Done{};
}

std::string newEvidenceId() {
  std::random_device device;
  std::string id;
  for (int i = 0; i < 4; ++i) {
    char part[12];
    std::snprintf(part, sizeof part, "%08x", static_cast<unsigned>(device()));
    id += part;
  }
  return id;
}

}  // namespace stillcut::learn
