#include "core/evaluate/own_value_log.h"

#include <cmath>

namespace stillcut::evaluate {
namespace {

template <class Part>
void note(OwnValueLog::Entry*& next, const Part& part, std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i, ++next) {
    const detect::OwnValue now = part.own(i);
    if (!std::isfinite(now.value) && std::isfinite(next->value)) continue;
    next->value = now.value;
    next->why = next->decl->whys[now.why];
  }
}

}  // namespace

OwnValueLog::OwnValueLog(const pipeline::Chain& chain) : chain_(&chain) {
  const auto add = [this](detect::OwnValueTable table) {
    for (const detect::OwnValueDecl& decl : table) entries_.push_back({&decl, config::kAutomatic, decl.whys.front()});
  };
  add(detect::Conditioner::ownValues());
  for (const auto& detector : chain.parts().detectors) add(detector->ownValues());
}

void OwnValueLog::observe() noexcept {
  Entry* next = entries_.data();
  note(next, chain_->conditioner(), detect::Conditioner::ownValues().size());
  for (const auto& detector : chain_->parts().detectors) note(next, *detector, detector->ownValues().size());
}

}  // namespace stillcut::evaluate
