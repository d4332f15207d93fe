// Machines for the table of ends: each with a link to it through a wire that is late on purpose, the truth of what
// stands in it, read beside that wire, and its operator's hand. Thread: one, but for what a machine runs by itself.
#pragma once

#include <csignal>
#include <cstdint>
#include <memory>
#include <string>

#include "core/base/units.h"
#include "core/cnc/cnc_link.h"

namespace stillcut::ends {

struct Stand {
  int speed = 0, feed = 0;  // %, in force or in the register that counts
  bool operator==(const Stand&) const = default;
};

class Machine {
 public:
  enum class Lie : std::uint8_t { None, Once, Always };

  virtual ~Machine() = default;
  // Every byte to and from it is so late from now on.
  virtual void delay(Seconds late) = 0;
  // Called in the program that is tried; keeps to itself.
  virtual std::unique_ptr<cnc::CncLink> link() = 0;
  virtual Stand stands() = 0;
  // As a cut begins: at 100 %, by nobody who is tried, and with nothing wrong any more.
  virtual void rest() = 0;

  // What may become of it. False, and nothing done: this machine has no such thing.
  // Sets both; the knob shares a register with us.
  virtual bool hand(Stand) { return false; }
  virtual bool pull(bool /*out*/) { return false; }    // the cable
  virtual bool hang(bool /*hangs*/) { return false; }  // its server or controller
  virtual bool power(bool /*on*/) { return false; }    // the operator's button, or its alarm
  virtual bool deaf(bool /*deaf*/) { return false; }   // takes orders, and nothing comes of them
  virtual bool lie(Lie) { return false; }              // of where the overrides stand
  // SIGKILL or SIGSTOP to the program with HAL pins beside it.
  virtual bool component(int /*signal*/) { return false; }
};

std::unique_ptr<Machine> makeGrbl();
// Null, with one line in `why`, where it cannot be run here.
std::unique_ptr<Machine> makeSender(std::string& why);
std::unique_ptr<Machine> makeModbus(bool serial, std::string& why);
std::unique_ptr<Machine> makeLinuxCnc(bool component, std::string& why);

}  // namespace stillcut::ends
