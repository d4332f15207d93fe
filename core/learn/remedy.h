// What may be done about a chatter, by its kind, and what was tried before on this tool. Thread: any. Allocates.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/message.h"
#include "core/learn/cut_evidence.h"
#include "core/learn/speed_variation.h"
#include "core/model/verdict.h"

namespace stillcut::learn {

struct RemedyRequest {
  ChatterKind kind = ChatterKind::Unknown;
  Rpm speed{};
  Metres depth{};
  int teeth = 0;
  Hertz frequency{};                       // of the chatter, or of the forced vibration
  std::optional<milling::CutModel> model;  // where modes are known or learned: speed variation is tried on it
  VariationLimits limits;
  std::optional<Rpm> quietSpeed;     // from lobes or rules
  std::optional<Metres> quietDepth;  // at the present speed
  bool wasQuietBefore = false;       // a cut with these numbers on this tool
};

struct Remedy {
  std::vector<Message> words;               // the best first
  std::optional<SpeedVariation> variation;  // offered for period doubling, where the simulation shows that it helps
};

Remedy remedyFor(const RemedyRequest& request);

// "chattered at 8500 rev/min, was quiet at 7900": the nearest of each, at least as deep or as shallow as `depth`.
std::vector<Message> remembered(std::span<const CutEvidence> cuts, Rpm speed, Metres depth);

}  // namespace stillcut::learn
