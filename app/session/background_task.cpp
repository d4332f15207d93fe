#include "app/session/background_task.h"

#include <exception>
#include <utility>

#include "ui/base/say.h"

namespace stillcut::app {

void BackgroundTask::start(ui::TaskState::What what, const QString& file, Work work,
                           std::function<void(const Error&)> failed, BackgroundTask* other) {
  leave();
  std::jthread also;
  if (other != nullptr) {
    other->leave();
    also = std::move(other->thread_);
  }
  failed_ = std::move(failed);
  what_ = what;
  file_ = file;
  problem_.clear();
  job_ = std::make_shared<Job>();
  thread_ =
      std::jthread([before = std::move(thread_), also = std::move(also), job = job_, work = std::move(work)]() mutable {
        if (before.joinable()) before.join();
        if (also.joinable()) also.join();
        try {
          const bool left = job->left.load(std::memory_order_relaxed);
          job->result.emplace(left ? Result<Apply>(Error{message("task"), message("stopped")}) : work(job->progress));
        } catch (const std::exception& e) {
          job->result.emplace(Error{message("task"), foreign(e.what())});
        }
        job->finished.store(true, std::memory_order_release);
      });
}

void BackgroundTask::askToEnd() {
  if (job_) job_->progress.stop.store(true, std::memory_order_relaxed);
}

void BackgroundTask::leave() {
  if (!job_) return;
  askToEnd();
  job_->left.store(true, std::memory_order_relaxed);
  job_.reset();
}

void BackgroundTask::cancel() {
  leave();
  if (thread_.joinable()) thread_.join();
}

bool BackgroundTask::collect() {
  if (!job_ || !job_->finished.load(std::memory_order_acquire)) return false;
  thread_.join();
  const std::shared_ptr<Job> job = std::exchange(job_, nullptr);
  if (!*job->result) {
    problem_ = ui::sayError(job->result->error());
    if (failed_) failed_(job->result->error());
  } else if (const Apply& apply = job->result->value()) {
    apply();
  }
  return true;
}

ui::TaskState BackgroundTask::state() const {
  return {what_, job_ != nullptr, job_ ? job_->progress.part.load(std::memory_order_relaxed) : 1.0, file_, problem_};
}

}  // namespace stillcut::app
