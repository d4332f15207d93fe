// ReadPlan: which registers are asked for in one question. Registers that lie without a gap in one table of words, or
// are the same one, are read together: on a wire that holds every answer up, what the machine tells is then as old as
// one answer and not as the sum of all. A gap is never asked for, as a machine may refuse what it does not have. A
// machine that refuses a question for several is asked for each alone until the link is opened again. Thread: link
// thread. Real-time safe, but for the constructor.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/cnc/modbus/register_bus.h"
#include "core/cnc/modbus/register_map.h"

namespace stillcut::cnc {

struct ReadSpan {
  RegisterTable table = RegisterTable::Holding;
  int first = 0;              // register
  int count = 0;              // words; 0: the map does not have the signal
  std::uint32_t members = 0;  // bit s: signal s lies in it

  bool has(std::size_t signal) const noexcept { return (members >> signal & 1U) != 0; }
};

class ReadPlan {
 public:
  explicit ReadPlan(const RegisterMap& map);

  // The question that brings the signal.
  const ReadSpan& of(std::size_t signal) const noexcept { return apart_ ? alone_[signal] : together_[signal]; }
  bool asksForSeveral(std::size_t signal) const noexcept { return of(signal).count > alone_[signal].count; }
  void takeApart() noexcept { apart_ = true; }
  void putTogether() noexcept { apart_ = false; }
  int questions() const noexcept;  // that bring all once

 private:
  std::array<ReadSpan, kMachineSignals> alone_{}, together_{};
  bool apart_ = false;
};

}  // namespace stillcut::cnc
