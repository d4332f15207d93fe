#include "core/rt/realtime_thread.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <utility>

namespace stillcut::rt {

RealtimeThread::RealtimeThread(const ThreadRequest& request, std::function<void(std::stop_token)> body)
    : thread_(std::move(body)) {
  const pthread_t handle = thread_.native_handle();
  ::pthread_setname_np(handle, request.name.substr(0, 15).c_str());
  if (request.scheduling != Scheduling::Fifo) return;
  sched_param param{};
  param.sched_priority = request.priority;
  if (::pthread_setschedparam(handle, SCHED_FIFO, &param) == 0) granted_ = Scheduling::Fifo;
}

bool lockMemory() {
  return ::mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
}

}  // namespace stillcut::rt
