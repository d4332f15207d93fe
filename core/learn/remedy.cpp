#include "core/learn/remedy.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stillcut::learn {
namespace {

std::string number(const char* form, double value) {
  char text[32];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

std::string wholeSpeed(Rpm speed) {
  return number("%.0f", speed.value);
}

void addSpeedOrDepth(const RemedyRequest& r, std::vector<Message>& words) {
  if (r.quietSpeed) words.push_back(message("another speed: %1 rpm", wholeSpeed(*r.quietSpeed)));
  if (r.quietDepth) words.push_back(message("less depth: %1 mm", number("%.2f", 1e3 * r.quietDepth->value)));
}

// A harmonic of the teeth is taken off the resonance by a tenth.
void addForced(const RemedyRequest& r, std::vector<Message>& words) {
  if (r.teeth > 0 && r.frequency.value > 0.0 && r.speed.value > 0.0) {
    const double harmonic = std::max(1.0, std::round(r.frequency / toothPassing(r.speed, r.teeth)));
    const Rpm off(60.0 * 0.9 * r.frequency.value / (harmonic * r.teeth));
    words.push_back(message("a tooth harmonic meets a resonance: take the speed off it, as %1 rpm", wholeSpeed(off)));
  } else {
    words.push_back(message("a tooth harmonic meets a resonance: take the speed off it"));
  }
  words.push_back(message("check runout and balance"));
}

}  // namespace

Remedy remedyFor(const RemedyRequest& r) {
  Remedy remedy;
  if (r.kind == ChatterKind::Flip && r.model) {
    remedy.variation = helpfulVariation(*r.model, r.speed, r.depth, r.limits);
    if (remedy.variation) {
      remedy.words.push_back(message(
          "vary the spindle speed by %1 % with a period of %2 s: in simulation this quiets it",
          number("%.0f", 100.0 * remedy.variation->amplitude.value), number("%.1f", remedy.variation->period.value)));
    }
  }
  if (r.kind == ChatterKind::Forced) {
    addForced(r, remedy.words);
  } else {
    addSpeedOrDepth(r, remedy.words);
  }
  if (r.kind == ChatterKind::Hopf) remedy.words.push_back(message("a tool with another or an uneven pitch"));
  if (r.wasQuietBefore) remedy.words.push_back(message("this cut was quiet before: is the tool worn, or loose?"));
  return remedy;
}

std::vector<Message> remembered(std::span<const CutEvidence> cuts, Rpm speed, Metres depth) {
  const CutEvidence* loud = nullptr;
  const CutEvidence* quiet = nullptr;
  const auto nearer = [&](const CutEvidence& cut, const CutEvidence* than) {
    if (than == nullptr) return true;
    const double gap = std::abs((cut.speed - speed).value);
    const double other = std::abs((than->speed - speed).value);
    return gap < other || (gap == other && cut.time_s > than->time_s);
  };
  for (const CutEvidence& cut : cuts) {
    const bool chatter = cut.outcome == CutOutcome::Chatter;
    if (chatter && cut.depth <= 1.05 * depth && nearer(cut, loud)) loud = &cut;
    if (!chatter && cut.depth >= 0.95 * depth && nearer(cut, quiet)) quiet = &cut;
  }
  std::vector<Message> words;
  if (loud != nullptr) words.push_back(message("this tool chattered at %1 rpm", wholeSpeed(loud->speed)));
  if (quiet != nullptr) words.push_back(message("it was quiet at %1 rpm", wholeSpeed(quiet->speed)));
  return words;
}

}  // namespace stillcut::learn
