// What a machine is left with, measured: for each link, each end of what moved it and each delay on its wire, over so
// many tries the worst time and the median until the operator's values stand in it again, as Markdown. For the manual
// (resources/manual/ends.md); each try on standard error. Ends with 1 where one was left elsewhere though somebody was
// there to bring it back.
//   safe_ends_table [--tries N] [--link grbl|sender|modbus|modbus-rtu|linuxcnc|linuxcnc-hal]... [--delays MS,MS,...]
//   [--rows NAME,...]
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "tests/bench/ends/ends.h"
#include "tests/support/bounded_wait.h"

namespace stillcut::ends {
namespace {

using cnc::testing::within;

constexpr Seconds kLongest{15.0};   // that is waited for the way home
constexpr Seconds kForgotten{2.0};  // ... where nobody is left to go it
constexpr Seconds kEngages{20.0};   // and for the way out
constexpr Seconds kStays{0.3};      // afterwards nobody moves it again
constexpr Seconds kHandStays{0.7};  // while the program still asks for its own

struct Tried {
  enum class Outcome { Absent, NeverThere, Left, Home };
  Outcome outcome = Outcome::Absent;
  double seconds = 0.0;
  Stand at{};
};

std::string told(const Tried& t) {
  const std::string where = std::to_string(t.at.speed) + "/" + std::to_string(t.at.feed);
  switch (t.outcome) {
    case Tried::Outcome::Absent:
      return "no such end";
    case Tried::Outcome::NeverThere:
      return "never engaged, at " + where;
    case Tried::Outcome::Left:
      return "left at " + where;
    case Tried::Outcome::Home:
      break;
  }
  return std::to_string(std::lround(1e3 * t.seconds)) + " ms";
}

// `late`: what the wire holds up, each way.
Tried tryOnce(Machine& machine, const End& end, Seconds late) {
  static const SteadyClock kClock;
  machine.rest();
  const Program program(machine);
  if (!within(kEngages, [&] { return machine.stands() == Stand{kOurs, kOurs}; })) {
    return {Tried::Outcome::NeverThere, 0.0, machine.stands()};
  }
  within(Seconds(0.15) + late * 4.0, [] { return false; });  // it has settled, and the link has seen it
  const auto began = end.act(program, machine);
  if (!began) return {};
  if (!within(end.mayStay ? kForgotten : kLongest, [&] { return machine.stands() == end.then; })) {
    return {Tried::Outcome::Left, 0.0, machine.stands()};
  }
  const double after = std::max(0.0, secondsBetween(*began, kClock.now()).value);
  const Seconds stays = end.then == kHand ? kHandStays : kStays;
  if (within(stays, [&] { return machine.stands() != end.then; })) return {Tried::Outcome::Left, 0.0, machine.stands()};
  return {Tried::Outcome::Home, after, end.then};
}

// "2 left at 83/83", for each place.
std::string lefts(const std::vector<Tried>& tries, const char* word) {
  std::map<std::string, int> places;
  for (const Tried& t : tries) {
    if (t.outcome == Tried::Outcome::Left) ++places[std::to_string(t.at.speed) + "/" + std::to_string(t.at.feed)];
  }
  std::string text;
  for (const auto& [place, count] : places) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + word + place;
  }
  return text.empty() ? "" : "**" + text + "**";
}

std::string cell(const std::vector<Tried>& tries, bool hand) {
  std::vector<double> home;
  int never = 0;
  for (const Tried& t : tries) {
    if (t.outcome == Tried::Outcome::Absent) return "-";
    never += t.outcome == Tried::Outcome::NeverThere ? 1 : 0;
    if (t.outcome == Tried::Outcome::Home) home.push_back(1e3 * t.seconds);
  }
  const std::string left = lefts(tries, hand ? " over it, at " : " left at ");
  const std::string missed = never > 0 ? " (" + std::to_string(never) + " never engaged)" : "";
  if (home.empty()) return left.empty() ? "never engaged" : left + missed;
  if (hand) return "kept" + (left.empty() ? "" : " " + left) + missed;
  std::sort(home.begin(), home.end());
  char text[64];
  std::snprintf(text, sizeof text, "%.0f, %.0f", home.back(), home[home.size() / 2]);
  return text + (left.empty() ? "" : " " + left) + missed;
}

std::unique_ptr<Machine> make(const std::string& link, std::string& why) {
  if (link == "grbl") return makeGrbl();
  if (link == "sender") return makeSender(why);
  if (link == "modbus" || link == "modbus-rtu") return makeModbus(link == "modbus-rtu", why);
  return makeLinuxCnc(link == "linuxcnc-hal", why);
}

bool wanted(const std::vector<std::string>& list, const std::string& name) {
  return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
}

double load() {
  double minute = 0.0;
  return ::getloadavg(&minute, 1) == 1 ? minute : -1.0;
}

void heading(const std::string& link, const std::vector<double>& delays, int tries) {
  std::printf("\n%s, %d tries, %u cores, load %.1f at the start\n\n| worst and median, ms |", link.c_str(), tries,
              std::thread::hardware_concurrency(), load());
  for (const double ms : delays) std::printf(" %g ms |", ms);
  std::printf(" load |\n|---|");
  for (std::size_t k = 0; k <= delays.size(); ++k) std::printf("---|");
  std::printf("\n");
}

// False: at least once it was left elsewhere than where its operator had it.
bool row(Machine& machine, const End& end, const std::vector<double>& delays, int tries) {
  bool home = true;
  std::printf("| %s |", end.said.c_str());
  for (const double ms : delays) {
    machine.delay(Seconds(1e-3 * ms));
    std::vector<Tried> all;
    try {
      for (int k = 0; k < tries; ++k) {
        all.push_back(tryOnce(machine, end, Seconds(1e-3 * ms)));
        std::fprintf(stderr, "%s, %g ms: %s\n", end.name.c_str(), ms, told(all.back()).c_str());
        if (all.back().outcome == Tried::Outcome::Absent) break;
      }
      std::printf(" %s |", cell(all, end.then == kHand).c_str());
      for (const Tried& t : all) home = home && (end.mayStay || t.outcome != Tried::Outcome::Left);
    } catch (const std::exception& e) {
      home = false;
      std::printf(" **%s** |", e.what());
    }
    std::fflush(stdout);
  }
  std::printf(" %.1f |\n", load());
  std::fflush(stdout);
  return home;
}

int table(const std::vector<std::string>& links, const std::vector<double>& delays, int tries,
          const std::vector<std::string>& rows) {
  bool home = true;
  for (const std::string& link : links) {
    std::string why;
    const auto machine = make(link, why);
    if (!machine) {
      std::printf("\n%s: %s\n", link.c_str(), why.c_str());
      continue;
    }
    heading(link, delays, tries);
    for (const End& end : ends()) {
      if (wanted(rows, end.name)) home = row(*machine, end, delays, tries) && home;
    }
    machine->rest();
  }
  return home ? 0 : 1;
}

}  // namespace
}  // namespace stillcut::ends

int main(int argc, char** argv) {
  try {
    CLI::App app("What a machine is left with, measured");
    int tries = 20;
    std::vector<std::string> links, rows;
    std::vector<double> delays{0.0, 0.5, 5.0, 20.0, 100.0};
    std::string names;
    for (const auto& end : stillcut::ends::ends()) names += (names.empty() ? "" : ", ") + end.name;
    app.add_option("--tries", tries, "of each cell");
    app.add_option("--link", links, "grbl, sender, modbus, modbus-rtu, linuxcnc, linuxcnc-hal");
    app.add_option("--delays", delays, "ms, each way")->delimiter(',');
    app.add_option("--rows", rows, names)->delimiter(',');
    CLI11_PARSE(app, argc, argv);
    if (links.empty()) links = {"grbl", "sender", "modbus", "modbus-rtu", "linuxcnc", "linuxcnc-hal"};
    return stillcut::ends::table(links, delays, tries, rows);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "safe_ends_table: %s\n", e.what());
    return 3;
  }
}
