// What a register can say, and what would be a jump: by the map's own range, and where it has none by what machines
// are. Thread: link thread. Real-time safe.
#pragma once

#include "core/cnc/modbus/register_map.h"

namespace stillcut::cnc {

bool isFlag(MachineSignal s) noexcept;
// Whether `value` (rev/min, mm/min, %) can be. `fastest`: the highest programmed speed that was believed, rev/min,
// which a spindle exceeds by its override at most twofold; 0: none was.
bool canBe(const RegisterMap& map, MachineSignal s, double value, double fastest) noexcept;
// The difference from which on a value has jumped, in its unit: no ramp is as fast between two polls. `programmed`:
// speed or feed of the program, whichever `s` is of.
double jumpOf(MachineSignal s, double programmed) noexcept;
// The program's value of the same kind.
MachineSignal programmedOf(MachineSignal s) noexcept;

}  // namespace stillcut::cnc
