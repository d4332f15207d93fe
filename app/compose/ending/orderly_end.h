// OrderlyEnd: the run ends in order whatever becomes of the screen: a display that dies (Qt then leaves by exit()), and
// one that hangs while somebody asks the program to end, keep no machine from its programmed values, no recording from
// being closed, and the program from ending. One at a time in a program, as exit() is.
// Thread: made and let go of on the GUI thread; it watches on a thread of its own.
#pragma once

#include <functional>
#include <memory>

#include "core/base/units.h"

namespace stillcut::app {

class OrderlyEnd {
 public:
  // A display that hangs is waited for so long after somebody has asked the program to end; and, where nothing else is
  // said, as long again, once the run has ended, before the program leaves without it.
  static constexpr Seconds kPatience{0.5};

  // `end`: ends the run; called once, on whatever thread is first. `asked`: whether somebody has asked the program to
  // end; looked at 20 times a second, also after this is gone. `leaves`: what the program has for all that it writes
  // after the run has ended.
  OrderlyEnd(std::function<void()> end, std::function<bool()> asked, Seconds leaves = kPatience);
  // The run has ended by itself.
  ~OrderlyEnd();
  OrderlyEnd(const OrderlyEnd&) = delete;
  OrderlyEnd& operator=(const OrderlyEnd&) = delete;

  // Ends the run, or waits until it has been ended.
  void endNow();

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;  // with the thread, which may outlive this
};

}  // namespace stillcut::app
