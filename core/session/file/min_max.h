// MinMax: the least and the greatest of some samples. Pure: any thread.
#pragma once

namespace stillcut::record {

struct MinMax {
  float min = 0.0F;
  float max = 0.0F;
};

}  // namespace stillcut::record
