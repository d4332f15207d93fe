#include "core/evaluate/auto_value_log.h"

#include <cmath>

namespace stillcut::evaluate {
namespace {

template <class Part>
void note(AutoValueLog::Entry*& next, const Part& part, std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i, ++next) {
    const detect::AutoValue now = part.own(i);
    if (!std::isfinite(now.value) && std::isfinite(next->value)) continue;
    next->value = now.value;
    next->why = next->decl->whys[now.why];
  }
}

}  // namespace

AutoValueLog::AutoValueLog(const pipeline::Chain& chain) : chain_(&chain) {
  const auto add = [this](detect::AutoValueTable table) {
    for (const detect::AutoValueDecl& decl : table) entries_.push_back({&decl, config::kAutomatic, decl.whys.front()});
  };
  add(detect::Conditioner::autoValues());
  for (const auto& detector : chain.parts().detectors) add(detector->autoValues());
}

void AutoValueLog::observe() noexcept {
  Entry* next = entries_.data();
  note(next, chain_->conditioner(), detect::Conditioner::autoValues().size());
  for (const auto& detector : chain_->parts().detectors) note(next, *detector, detector->autoValues().size());
}

}  // namespace stillcut::evaluate
