// stillcut-hal: the override pins of Stillcut in LinuxCNC's HAL. It runs beside the machine, loaded by its HAL file
// (packaging/linuxcnc/stillcut.hal), and listens on this machine alone unless told otherwise.
//   loadusr -W stillcut-hal [--listen ADDRESS] [--port PORT]
// Built only where LinuxCNC's headers are; Stillcut itself is not linked with HAL.
#include <hal.h>
#include <sched.h>

#include <charconv>
#include <csignal>
#include <cstdio>
#include <string>
#include <string_view>

#include "app/hal/line_server.h"
#include "app/hal/override_arbiter.h"

namespace stillcut::hal {
namespace {

constexpr const char* kComponent = "stillcut-hal";
constexpr Duration kTick = std::chrono::milliseconds(3);

volatile std::sig_atomic_t ended = 0;
void onSignal(int /*number*/) {
  ended = 1;
}

// In HAL's shared memory: it outlives this program, and a machine left alone goes on reading what stands there.
struct Pins {
  hal_bit_t *active, *heartbeat, *speedEnable, *feedEnable, *watchdogOk, *permit;
  hal_s32_t *speed, *feed, *restoreSpeed, *restoreFeed;
  hal_float_t* adaptiveFeed;
};

bool makePins(Pins& p, int component) {
  const bool made = hal_pin_bit_newf(HAL_OUT, &p.active, component, "stillcut.active") == 0 &&
                    hal_pin_bit_newf(HAL_OUT, &p.heartbeat, component, "stillcut.heartbeat") == 0 &&
                    hal_pin_bit_newf(HAL_OUT, &p.speedEnable, component, "stillcut.speed-enable") == 0 &&
                    hal_pin_bit_newf(HAL_OUT, &p.feedEnable, component, "stillcut.feed-enable") == 0 &&
                    hal_pin_s32_newf(HAL_OUT, &p.speed, component, "stillcut.speed-percent") == 0 &&
                    hal_pin_s32_newf(HAL_OUT, &p.feed, component, "stillcut.feed-percent") == 0 &&
                    hal_pin_s32_newf(HAL_OUT, &p.restoreSpeed, component, "stillcut.speed-home") == 0 &&
                    hal_pin_s32_newf(HAL_OUT, &p.restoreFeed, component, "stillcut.feed-home") == 0 &&
                    hal_pin_float_newf(HAL_OUT, &p.adaptiveFeed, component, "stillcut.adaptive-feed") == 0 &&
                    hal_pin_bit_newf(HAL_IN, &p.watchdogOk, component, "stillcut.watchdog-ok") == 0 &&
                    hal_pin_bit_newf(HAL_IN, &p.permit, component, "stillcut.permit") == 0;
  if (made) *p.permit = true;  // a machine without the switch leaves this pin alone
  return made;
}

// Knobs that are let go of are let go of before the numbers move; the watchdog is armed last.
void show(const ArbiterPins& pins, const Pins& p) {
  *p.speedEnable = pins.speedEnable;
  *p.feedEnable = pins.feedEnable;
  *p.restoreSpeed = pins.restoreSpeed;
  *p.restoreFeed = pins.restoreFeed;
  *p.speed = pins.speed;
  *p.feed = pins.feed;
  *p.adaptiveFeed = pins.adaptiveFeed;
  *p.heartbeat = pins.heartbeat;
  *p.active = pins.active;
}

void run(const Pins& pins, LineServer& server, const Clock& clock) {
  OverrideArbiter keeper;
  std::array<char, cnc::kHalLine> text{};
  bool listening = true;
  const LineServer::Handlers handlers{[&](int client, std::string_view line) -> std::string_view {
                                        if (!listening) return {};
                                        if (const auto request = cnc::readHalRequest(line))
                                          keeper.take(*request, client, clock.now());
                                        return cnc::writeHalReport(keeper.report(client), text);
                                      },
                                      [&](int client) { keeper.clientGone(client, clock.now()); }};
  const auto round = [&] {
    server.serve(kTick, handlers);
    show(keeper.tick({*pins.watchdogOk != 0, *pins.permit != 0}, clock.now()), pins);
  };
  while (ended == 0) round();
  // The way home is walked before the pins go.
  listening = false;
  keeper.end(clock.now());
  const Instant until = clock.now() + OverrideArbiter::kRestoreTime;
  while (clock.now() < until) round();
}

struct Options {
  std::string address = "127.0.0.1";
  int port = 5008;
};

bool parse(int argc, char** argv, Options& o) {
  for (int i = 1; i < argc; i += 2) {
    const std::string_view name(argv[i]);
    if (i + 1 == argc || (name != "--listen" && name != "--port")) return false;
    const std::string_view value(argv[i + 1]);
    if (name == "--listen") {
      o.address = value;
      continue;
    }
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), o.port);
    if (error != std::errc() || end != value.data() + value.size() || o.port < 1 || o.port > 65535) return false;
  }
  return true;
}

int start(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options)) {
    std::fputs("usage: stillcut-hal [--listen ADDRESS] [--port 1..65535]\n", stderr);
    return 2;
  }
  const SteadyClock clock;
  LineServer server(clock);
  if (const Status listening = server.listen(options.address, options.port); !listening) {
    std::fprintf(stderr, "stillcut-hal: %s\n", listening.error().line().c_str());
    return 3;
  }
  const int component = hal_init(kComponent);
  if (component < 0) {
    std::fputs("stillcut-hal: HAL does not take the component: is LinuxCNC running, and is this the only one?\n",
               stderr);
    return 3;
  }
  auto* const pins = static_cast<Pins*>(hal_malloc(sizeof(Pins)));
  const bool made = pins != nullptr && makePins(*pins, component);
  if (made) {
    show(ArbiterPins{}, *pins);
    std::signal(SIGTERM, onSignal);
    std::signal(SIGINT, onSignal);
    // Where the user may, as LinuxCNC's own users may: a busy host does not delay the heartbeat then.
    const sched_param first{1};
    ::sched_setscheduler(0, SCHED_FIFO, &first);
    hal_ready(component);
    run(*pins, server, clock);
  }
  hal_exit(component);
  if (!made) std::fputs("stillcut-hal: HAL has no room for the pins\n", stderr);
  return made ? 0 : 3;
}

}  // namespace
}  // namespace stillcut::hal

int main(int argc, char** argv) {
  return stillcut::hal::start(argc, argv);
}
