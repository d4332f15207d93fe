#include "core/detect/share_test.h"

#include <cmath>

namespace stillcut::detect {

void ShareTest::skipStale() {
  const unsigned seen = seen_;
  reset();
  seen_ = seen;
  stale_ = SeriesWatch::kLooksPerWindow;
}

void ShareTest::see(const SeriesLook& look) {
  if (look.count == seen_) return;
  seen_ = look.count;
  if (stale_ > 0) {
    --stale_;
    return;
  }
  const bool counts = look.whole && look.agreed && look.steady && look.certainty > kLikely && look.teethHeard &&
                      look.lines >= kFewestLines;
  uncounted_ = counts ? 0 : uncounted_ + 1;
  share_ = counts ? look.free.share : 0.0;
  const double joint = counts ? look.joint : 0.0;
  const bool apart = std::abs(look.free.offset) >= kLeastOffset;
  above_ = apart && share_ >= kFull && joint >= kJoint && (alarmed_ || !look.leaving) ? above_ + 1 : 0;
  const bool low = counts && (share_ < kEnds * kFull || joint < kEnds * kJoint);
  if (counts) below_ = low ? below_ + 1 : 0;
  alarmed_ = above_ >= kLooks || (alarmed_ && below_ < kLooks && uncounted_ < kMostUncounted);
  if (share_ > 0.0) line_ = look.free.line;
}

}  // namespace stillcut::detect
