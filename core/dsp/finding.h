// A finding that stands once looks speak for it so many times more often than against it, and falls the same way.
// Thread: worker; real-time.
#pragma once

#include <algorithm>

namespace stillcut::dsp {

class Finding {
 public:
  void see(bool speaks, int need, int release) noexcept {
    run_ = speaks == stands_ ? std::max(0, run_ - 1) : run_ + 1;
    if (run_ < (stands_ ? release : need)) return;
    stands_ = !stands_;
    run_ = 0;
  }
  bool stands() const noexcept { return stands_; }

 private:
  int run_ = 0;
  bool stands_ = false;
};

}  // namespace stillcut::dsp
