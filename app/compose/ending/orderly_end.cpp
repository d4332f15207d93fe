#include "app/compose/ending/orderly_end.h"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <utility>

namespace stillcut::app {
namespace {

constexpr std::chrono::milliseconds kLook{50};

// What exit() calls has no argument.
OrderlyEnd* atExit = nullptr;

void endAtExit() {
  if (atExit != nullptr) atExit->endNow();
}

}  // namespace

struct OrderlyEnd::Shared {
  std::function<void()> end;
  std::function<bool()> asked;
  Seconds leaves{};
  std::once_flag ended;
  std::mutex lock;
  std::condition_variable changed;
  bool gone = false;  // the run has ended, and nobody asked for it

  void endNow() { std::call_once(ended, end); }
  void watch() {
    std::unique_lock held(lock);
    while (!gone && !asked()) changed.wait_for(held, kLook);
    const auto isGone = [this] { return gone; };
    const std::chrono::duration<double> patience(kPatience.value);
    if (changed.wait_for(held, patience, isGone)) return;
    held.unlock();
    endNow();
    held.lock();
    // The program has had time to leave by itself: what it waits for now is a display that hangs.
    if (!changed.wait_for(held, std::chrono::duration<double>(leaves.value), isGone)) std::_Exit(EXIT_SUCCESS);
  }
};

OrderlyEnd::OrderlyEnd(std::function<void()> end, std::function<bool()> asked, Seconds leaves)
    : shared_(std::make_shared<Shared>()) {
  shared_->end = std::move(end);
  shared_->asked = std::move(asked);
  shared_->leaves = leaves;
  static const bool registered = std::atexit(endAtExit) == 0;
  static_cast<void>(registered);
  atExit = this;
  std::thread([shared = shared_] { shared->watch(); }).detach();
}

OrderlyEnd::~OrderlyEnd() {
  atExit = nullptr;
  std::call_once(shared_->ended, [] {});  // what would be ended is gone after this
  if (shared_->asked()) return;           // the thread sees to it that the program leaves, too
  const std::scoped_lock held(shared_->lock);
  shared_->gone = true;
  shared_->changed.notify_one();
}

void OrderlyEnd::endNow() {
  shared_->endNow();
}

}  // namespace stillcut::app
