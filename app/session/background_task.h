// One piece of work on a thread of its own, with its progress, and its result taken over on the GUI thread.
// Thread: GUI, but for the work itself and the progress it reports.
#pragma once

#include <QString>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "ui/facade/session_controller.h"

namespace stillcut::app {

class BackgroundTask {
 public:
  // Work's own view of it: how far it is, and whether to go on.
  struct Progress {
    std::atomic<double> part{0.0};
    std::atomic<bool> stop{false};
    bool stopped() const { return stop.load(std::memory_order_relaxed); }
  };
  // Gives what to do on the GUI thread with the result; an empty function: nothing.
  using Apply = std::function<void()>;
  using Work = std::function<Result<Apply>(Progress&)>;

  ~BackgroundTask() { cancel(); }

  // What still runs is left; the new work begins when that has ended. `failed`: in the place of a result, on the GUI
  // thread, where the work gives an error or throws. `other`: left as well, and ended before the work begins. Returns
  // at once.
  void start(ui::TaskState::What what, const QString& file, Work work,
             std::function<void(const Error&)> failed = nullptr, BackgroundTask* other = nullptr);
  // It need not go on; what it has by then is taken over as usual. Returns at once.
  void askToEnd();
  // Tells it to stop and throws its result away. Returns at once: the work may be deep in a slow disk.
  void leave();
  // The same, and waits for its end: afterwards nobody works any more.
  void cancel();
  // True: something has been finished and applied.
  bool collect();
  ui::TaskState state() const;

 private:
  struct Job {
    Progress progress;
    std::atomic<bool> finished{false}, left{false};
    std::optional<Result<Apply>> result;  // the worker's until `finished`
  };
  std::shared_ptr<Job> job_;
  std::jthread thread_;
  ui::TaskState::What what_ = ui::TaskState::What::None;
  QString file_, problem_;
  std::function<void(const Error&)> failed_;
};

}  // namespace stillcut::app
