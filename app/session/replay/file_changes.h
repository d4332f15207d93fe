// Changes of files that wait for their turn: each is made once, in order, by whoever works next. Any thread.
#pragma once

#include <deque>
#include <functional>
#include <mutex>
#include <utility>

#include "core/base/result.h"

namespace stillcut::app {

class FileChanges {
 public:
  using Change = std::function<Status()>;

  void add(Change change) {
    const std::lock_guard lock(waiting_);
    changes_.push_back(std::move(change));
  }
  // Makes all that wait. The first error, though the others were made.
  Status make() {
    const std::lock_guard alone(making_);
    Status all = Done{};
    while (Change change = next()) {
      if (Status done = change(); !done && all) all = std::move(done);
    }
    return all;
  }

 private:
  Change next() {
    const std::lock_guard lock(waiting_);
    if (changes_.empty()) return {};
    Change first = std::move(changes_.front());
    changes_.pop_front();
    return first;
  }

  std::mutex waiting_, making_;
  std::deque<Change> changes_;
};

}  // namespace stillcut::app
