// LinuxCNC as linuxcncrsh and halrmt show it, with the manners found on the real one: one client is in control, an
// override's ACK takes 100 ms, under M49, M50 P0 and M51 P0 it is acknowledged and read back and has no effect, the
// overrides stay when the client dies, and a get without the spindle's number crashes the server. Newer ones (Dialect)
// take the per cent before the spindle, and no more than 100, and complain in lines of their own.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "core/cnc/line_splitter.h"
#include "tests/support/scripted_wire.h"

namespace stillcut::cnc::testing {

enum class Dialect { Old, Ten, Master };  // 2.9, 2.10, and the C sources between them

struct FakeMill {
  Dialect dialect = Dialect::Old;
  int feed = 100, spindle = 100;
  int shownFeed = 100, shownSpindle = 100;  // read-back
  int lost = 0;                             // so many of the next orders are acknowledged and forgotten
  int lies = 0, liedPercent = 0;            // so many of the next answers to both say this
  double s = 8000.0, f = 600.0;
  bool inches = false;
  bool machineOn = true, running = true, paused = false;
  bool speedLocked = false, feedLocked = false;    // M51 P0, M50 P0; both: M49
  bool refusesControl = false;                     // "set enable" is not acknowledged
  bool refusesSpeed = false, refusesFeed = false;  // an override alone is not taken
  bool mumbles = false;                            // obeys an override, and answers in words of its own
  int complaints = 0;                              // of orders that newer dialects refuse
  int questions = 0;                               // to linuxcncrsh
  double moves = 1.0;                              // of the path's velocity: rapid moves, corners
  double adaptive = 1.0;                           // motion.adaptive-feed
  bool adaptiveHeeded = true;                      // M52 P1
  double highest = 1e9, fastest = 1e9;             // the spindle's and the path's own limit, rev/min and units/min
  const void* owner = nullptr;
  bool crashed = false;
  int sets = 0;
  double actual = 8000.0;  // rev/min

  void lock(bool both) { speedLocked = feedLocked = both; }
  double commanded() const { return running ? std::min(s * (speedLocked ? 1.0 : spindle / 100.0), highest) : 0.0; }
  double velocity() const {  // units/s
    const double share = (feedLocked ? 1.0 : feed / 100.0) * (adaptiveHeeded ? adaptive : 1.0);
    return running ? moves * std::min(f * share, fastest) / 60.0 : 0.0;
  }
};

class FakeEmcClient final : public Peer {
 public:
  explicit FakeEmcClient(FakeMill& mill) : mill_(mill) {}
  void connected() override {
    echo_ = true;
    verbose_ = greeted_ = false;
  }
  void gone() override {
    if (mill_.owner == this) mill_.owner = nullptr;
  }
  void take(std::string_view bytes, Instant, const Answer& answer) override {
    splitter_.feed(bytes, [&](std::string_view line) { obey(std::string(line), answer); });
  }

 private:
  void ack(const std::string& what, bool yes, double delay, const Answer& answer) const {
    if (verbose_) answer("SET " + what + (yes ? " ACK\n\r" : " NAK\n\r"), delay);
  }
  void obey(const std::string& line, const Answer& answer) {
    if (mill_.crashed) return;
    if (line.starts_with("hello EMC ")) {
      greeted_ = true;
      answer("HELLO ACK EMCNETSVR 1.1\r\n", 0.0);
      return;
    }
    if (!greeted_) {
      answer("HELLO NAK\r\n", 0.0);
      return;
    }
    if (echo_) answer(line + "\r\n", 0.0);
    if (line == "set echo off") {
      echo_ = false;
    } else if (line == "set verbose on") {
      verbose_ = true;
      ack("VERBOSE", true, 0.0, answer);
    } else if (line == "set enable EMCTOO") {
      if (!mill_.refusesControl) mill_.owner = this;
      ack("ENABLE", !mill_.refusesControl, 0.0, answer);
    } else if (line == "set enable off") {
      if (mill_.owner == this) mill_.owner = nullptr;
      ack("ENABLE", true, 0.0, answer);
    } else if (line == "set set_wait received") {
      setWait(answer);
    } else if (line == "set wait_mode received" && mill_.dialect != Dialect::Old) {
      ack("WAIT_MODE", true, 0.0, answer);
    } else if (line.starts_with("set feed_override ")) {
      set(line.substr(18), "FEED_OVERRIDE", mill_.feed, mill_.shownFeed, answer);
    } else if (mill_.dialect != Dialect::Old && line.starts_with("set spindle_override ")) {
      setSpindle(line.substr(21), answer);
    } else if (line.starts_with("set spindle_override 0 ")) {
      set(line.substr(23), "SPINDLE_OVERRIDE", mill_.spindle, mill_.shownSpindle, answer);
    } else if (line.starts_with("set spindle_override") || line == "get spindle_override" || line == "get spindle") {
      mill_.crashed = true;
    } else {
      get(line, answer);
    }
  }
  void setWait(const Answer& answer) const {
    if (mill_.dialect == Dialect::Ten) {
      answer("error: Subcommand not found: SET set_wait\r\n", 0.0);
      answer("SET NAK\r\n", 0.0);
      return;
    }
    if (mill_.dialect == Dialect::Master) answer("WARNING: \"set_wait\" is deprecated\n", 0.0);
    ack("SET_WAIT", true, 0.0, answer);
  }
  // "95 0"
  void setSpindle(const std::string& words, const Answer& answer) {
    const std::size_t space = words.find(' ');
    const int percent = std::stoi(words);
    const int spindle = space == std::string::npos ? 0 : std::stoi(words.substr(space));
    if (spindle < -1 || spindle > 0 || percent < 0 || percent > 100) {
      ++mill_.complaints;
      answer("error: invalid\r\n", 0.0);
      if (mill_.dialect == Dialect::Ten) ack("SPINDLE_OVERRIDE", false, 0.0, answer);
      return;
    }
    set(std::to_string(percent), "SPINDLE_OVERRIDE", mill_.spindle, mill_.shownSpindle, answer);
  }
  std::string shown(int percent) const {
    if (mill_.lies > 0) {
      --mill_.lies;
      percent = mill_.liedPercent;
    }
    return std::to_string(percent) + (mill_.dialect == Dialect::Master ? ".000000" : "");
  }
  void set(const std::string& value, const std::string& what, int& inForce, int& shown, const Answer& answer) {
    const bool refused = what == "FEED_OVERRIDE" ? mill_.refusesFeed : mill_.refusesSpeed;
    if (mill_.owner != this || !mill_.machineOn || refused) {
      ack(what, false, 0.0, answer);
      return;
    }
    ++mill_.sets;
    if (mill_.lost > 0) {
      --mill_.lost;
    } else {
      inForce = shown = std::stoi(value);
    }
    if (mill_.mumbles) return answer("okay, done\r\n", 0.1);
    ack(what, true, 0.1, answer);
  }
  void get(const std::string& line, const Answer& answer) const {
    const std::string nl = "\r\n";
    mill_.questions += line.starts_with("get pinval ") ? 0 : 1;
    if (line == "get enable") answer(std::string("ENABLE ") + (mill_.owner == this ? "ON" : "OFF") + nl, 0.0);
    if (line == "get feed_override") answer("FEED_OVERRIDE " + shown(mill_.shownFeed) + nl, 0.0);
    if (line == "get spindle_override 0") {
      answer("SPINDLE_OVERRIDE 0 " + shown(mill_.shownSpindle) + nl, 0.0);
    }
    if (line == "get machine") answer(std::string("MACHINE ") + (mill_.machineOn ? "ON" : "OFF") + nl, 0.0);
    if (line == "get program_status") {
      answer(std::string("PROGRAM_STATUS ") + (mill_.paused ? "PAUSED" : mill_.running ? "RUNNING" : "IDLE") + nl, 0.0);
    }
    if (line == "get program_codes") {
      answer("PROGRAM_CODES G80 G17 " + std::string(mill_.inches ? "G20" : "G21") + " G90 G94 F" +
                 std::to_string(mill_.f) + " S" + std::to_string(mill_.s) + nl,
             0.0);
    }
    if (line.starts_with("get pinval ")) pin(line.substr(11), answer);
  }
  void pin(const std::string& name, const Answer& answer) const {
    const auto say = [&](const std::string& n, const std::string& v) { answer("PINVAL " + n + " " + v + "\r\n", 0.0); };
    if (name == "spindle.0.speed-in") say(name, std::to_string(mill_.actual / 60.0));
    if (name == "spindle.0.speed-out") {
      say(name, std::to_string(mill_.commanded()));
      say(name + "-abs", std::to_string(mill_.commanded()));
      say(name + "-rps", std::to_string(mill_.commanded() / 60.0));
    }
    if (name == "spindle.0.at-speed") say(name, std::abs(mill_.actual - mill_.commanded()) < 100.0 ? "TRUE" : "FALSE");
    if (name == "motion.feed-hold") say(name, "FALSE");
    if (name == "motion.current-vel") say(name, std::to_string(mill_.velocity()));
    if (name == "motion.adaptive-feed") say(name, std::to_string(mill_.adaptive));
  }

  FakeMill& mill_;
  LineSplitter splitter_;
  bool echo_ = true, verbose_ = false, greeted_ = false;
};

}  // namespace stillcut::cnc::testing
