#include "tests/bench/ends/ends.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "tests/support/bounded_wait.h"

namespace stillcut::ends {
namespace {

using Moment = std::optional<Instant>;

constexpr Seconds kOut{2.5};    // so long a cable is out, a machine hangs or is off
constexpr Seconds kLying{3.0};  // and lies

Instant now() {
  static const SteadyClock kClock;
  return kClock.now();
}
void pass(Seconds time) {
  cnc::testing::within(time, [] { return false; });
}

int keeperOf(int parent) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream stat(entry.path() / "stat");
    int process = 0, its = 0;
    std::string name, state;
    if (stat >> process >> name >> state >> its && its == parent && name == "(stillcut-keeper)") return process;
  }
  return -1;
}

Moment toKeeper(int number, const Program& p) {
  const int keeper = keeperOf(p.process());
  const Instant began = now();
  return keeper > 0 && ::kill(keeper, number) == 0 ? Moment(began) : std::nullopt;
}

// Where orders and reports of an operator's hand cannot be told apart from ours by time alone, nobody may be moved by
// what is not so: neither above what the operator has nor below what we ask for.
void standsWhile(Seconds time, Machine& m) {
  const bool strayed = cnc::testing::within(time, [&] {
    const Stand s = m.stands();
    const auto outside = [](int percent) { return percent < kOurs || percent > kHome.speed; };
    return outside(s.speed) || outside(s.feed);
  });
  if (strayed) throw std::runtime_error("a lie moved the machine");
}

// Something that ends by itself after a while; the way home counts from then on.
Moment forAWhile(const Program& p, bool off, const std::function<bool(bool)>& wrong) {
  if (!wrong(true)) return std::nullopt;
  if (off) p.tell('o');
  pass(kOut);
  const Instant over = now();
  wrong(false);
  return over;
}

Moment lies(const Program& p, Machine& m, Machine::Lie how) {
  if (!m.lie(how)) return std::nullopt;
  standsWhile(how == Machine::Lie::Once ? kOut : kLying, m);
  const Instant began = now();
  m.lie(Machine::Lie::None);
  p.tell('o');
  return began;
}

template <class Tell>
Moment timed(Tell&& tell) {
  const Instant began = now();
  return tell() ? Moment(began) : std::nullopt;
}

}  // namespace

const std::vector<End>& ends() {
  static const std::vector<End> kEnds{
      {"off", "authority Off", [](const Program& p, Machine&) { return timed([&] { return p.tell('o'), true; }); }},
      {"closed", "the run ended, the program closed",
       [](const Program& p, Machine&) { return timed([&] { return p.tell('c'), true; }); }},
      {"worker", "the worker hangs",
       [](const Program& p, Machine&) { return timed([&] { return p.tell('w'), true; }); }},
      {"killed", "the program killed (`kill -9`)",
       [](const Program& p, Machine&) { return timed([&] { return p.signal(SIGKILL), true; }); }},
      {"hangs", "the program hangs",
       [](const Program& p, Machine&) { return timed([&] { return p.signal(SIGSTOP), true; }); }},
      {"keeper-killed", "its keeper killed", [](const Program& p, Machine&) { return toKeeper(SIGKILL, p); }},
      {"keeper-hangs", "its keeper hangs", [](const Program& p, Machine&) { return toKeeper(SIGSTOP, p); }},
      {"keeper-program", "its keeper killed, and the program 0.02 s later",
       [](const Program& p, Machine&) {
         if (!toKeeper(SIGKILL, p)) return Moment();
         pass(Seconds(0.02));
         return timed([&] { return p.signal(SIGKILL), true; });
       }},
      {"both", "program and keeper killed at once",
       [](const Program& p, Machine&) {
         const Moment began = toKeeper(SIGKILL, p);
         if (began) p.signal(SIGKILL);
         return began;
       },
       kHome, true},
      {"component-both", "program and `stillcut-hal` killed at once",
       [](const Program& p, Machine& m) {
         return timed([&] { return m.component(SIGKILL) && (p.signal(SIGKILL), true); });
       }},
      {"component-killed", "`stillcut-hal` killed",
       [](const Program&, Machine& m) { return timed([&] { return m.component(SIGKILL); }); }},
      {"component-hangs", "`stillcut-hal` hangs",
       [](const Program&, Machine& m) { return timed([&] { return m.component(SIGSTOP); }); }},
      {"cable", "the cable out for 2.5 s; from when it is in",
       [](const Program& p, Machine& m) { return forAWhile(p, false, [&](bool on) { return m.pull(on); }); }},
      {"cable-killed", "the program killed with the cable out; from when it is in",
       [](const Program& p, Machine& m) {
         return forAWhile(p, false, [&](bool on) {
           if (on) p.signal(SIGKILL);
           return m.pull(on);
         });
       }},
      {"cable-closed", "the program closed with the cable out; from when it is in",
       [](const Program& p, Machine& m) {
         return forAWhile(p, false, [&](bool on) {
           const bool done = m.pull(on);
           if (on) p.tell('c');
           return done;
         });
       }},
      {"machine-hangs", "the machine hangs for 2.5 s; from when it goes on",
       [](const Program& p, Machine& m) { return forAWhile(p, false, [&](bool on) { return m.hang(on); }); }},
      {"machine-hangs-off", "Off while the machine hangs; from when it goes on",
       [](const Program& p, Machine& m) { return forAWhile(p, true, [&](bool on) { return m.hang(on); }); }},
      {"machine-off", "Off while the machine is off or in alarm; from when it is on",
       [](const Program& p, Machine& m) { return forAWhile(p, true, [&](bool on) { return m.power(!on); }); }},
      {"deaf", "Off while orders come to nothing; from when they count",
       [](const Program& p, Machine& m) { return forAWhile(p, true, [&](bool on) { return m.deaf(on); }); }},
      {"lie", "one false report of an override, then Off",
       [](const Program& p, Machine& m) { return lies(p, m, Machine::Lie::Once); }},
      {"lies", "false reports for 3 s, then Off",
       [](const Program& p, Machine& m) { return lies(p, m, Machine::Lie::Always); }},
      {"hand", "a hand on the knobs (to 40 %, feed 0 %)",
       [](const Program&, Machine& m) { return timed([&] { return m.hand(kHand); }); }, kHand},
      {"hand-off", "the same, and Off a quarter of a second later",
       [](const Program& p, Machine& m) {
         return timed([&] {
           if (!m.hand(kHand)) return false;
           pass(Seconds(0.25));  // as soon as a person can
           p.tell('o');
           return true;
         });
       },
       kHand},
      {"hand-killed", "the same, and the program killed half a second later",
       [](const Program& p, Machine& m) {
         return timed([&] {
           if (!m.hand(kHand)) return false;
           pass(Seconds(0.5));
           p.signal(SIGKILL);
           return true;
         });
       },
       kHand},
  };
  return kEnds;
}

}  // namespace stillcut::ends
