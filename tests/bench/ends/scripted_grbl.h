// What the machines of the table with a scripted GRBL have in common, whatever stands between it and the wire: the
// truth of its overrides, the operator's hand on them, and reports that lie on the way. Thread: one.
#pragma once

#include <regex>
#include <string>
#include <utility>

#include "tests/bench/ends/machine.h"
#include "tests/support/delay_proxy.h"
#include "tests/support/grbl/fake_grbl.h"

namespace stillcut::ends {

// controller: with(f) calls f on its FakeGrbl.
template <class Controller>
Stand standsIn(Controller& controller) {
  Stand s;
  controller.with([&](const cnc::testing::FakeGrbl& g) { s = {g.spindle, g.feed}; });
  return s;
}

template <class Controller>
void turn(Controller& controller, Stand percent) {
  controller.with([&](cnc::testing::FakeGrbl& g) { g.turn(percent.speed, percent.feed); });
}

// What `overrides` matches in its reports becomes `instead`, once or always.
inline void lieInReports(cnc::testing::DelayProxy& wire, Machine::Lie how, const std::string& overrides,
                         const std::string& instead) {
  if (how == Machine::Lie::None) {
    wire.lie(nullptr);
    return;
  }
  wire.lie([how, report = std::regex(overrides), instead, lied = false](std::string& bytes) mutable {
    if (lied || !std::regex_search(bytes, report)) return;
    bytes = std::regex_replace(bytes, report, instead);
    lied = how == Machine::Lie::Once;
  });
}

}  // namespace stillcut::ends
