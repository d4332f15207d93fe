// For loops over every reason code there is, so that none that is added is left out of a test.
#pragma once

#include "core/model/reason.h"

namespace stillcut::test {

// Codes follow each other from None = 0 on.
inline bool isReason(int code) {
  return code == 0 || identifier(static_cast<ReasonCode>(code)) != identifier(ReasonCode::None);
}

}  // namespace stillcut::test
