// Loaded before a program (LD_PRELOAD): its wall clock jumps by two hours, thirty times a second, as a computer's does
// whose time is set while it runs. The steady clock is left alone: nobody can set that one.
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include <ctime>

namespace {

constexpr time_t kHour = 3600;
constexpr long kStep_ns = 33'000'000;

timespec stepped() {
  timespec steady{}, wall{};
  ::syscall(SYS_clock_gettime, CLOCK_MONOTONIC, &steady);
  ::syscall(SYS_clock_gettime, CLOCK_REALTIME, &wall);
  wall.tv_sec += steady.tv_nsec / kStep_ns % 2 == 0 ? -kHour : kHour;
  return wall;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* now) noexcept {
  if (clock != CLOCK_REALTIME && clock != CLOCK_REALTIME_COARSE)
    return static_cast<int>(::syscall(SYS_clock_gettime, clock, now));
  *now = stepped();
  return 0;
}

int gettimeofday(timeval* now, void* /*zone*/) noexcept {
  const timespec wall = stepped();
  *now = {wall.tv_sec, wall.tv_nsec / 1000};
  return 0;
}

time_t time(time_t* now) noexcept {
  const time_t wall = stepped().tv_sec;
  if (now != nullptr) *now = wall;
  return wall;
}

}  // extern "C"
