// AutoValueLog: what conditioner and detectors of a run have set themselves, and why: as last known, since a floor is
// forgotten where the cut ends.
// Thread: whoever runs the rig; not the sample path.
#pragma once

#include <string_view>
#include <vector>

#include "core/pipeline/chain.h"

namespace stillcut::evaluate {

class AutoValueLog {
 public:
  // `chain` outlives it.
  explicit AutoValueLog(const pipeline::Chain& chain);

  // After each step.
  void observe() noexcept;

  struct Entry {
    const detect::AutoValueDecl* decl = nullptr;
    double value = 0.0;  // not a number: never known
    std::string_view why;
  };
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  const pipeline::Chain* chain_;
  std::vector<Entry> entries_;
};

}  // namespace stillcut::evaluate
