// Tables as loggers, oscilloscopes and phones write them, all of the same cut.
// Thread: any; no state.
#pragma once

#include "tests/support/field_cases/table_cut.h"

namespace stillcut::field {

enum class UserTable {
  Control,         // time and two axes, with units: as the program's own tables
  Klipper,         // ACCELEROMETER_MEASURE: "#time" is the time in s, mm/s^2
  RepRapFirmware,  // M956: the rate in the last line, in g
  SensorLogger,    // a phone: time in ns and seconds_elapsed in s; neither is a signal
  PicoScope,       // units in a line of their own, in brackets; ms
  PhysicsToolbox,  // a constant column beside three axes
  Artis,           // repeats of unequal length side by side; "TimeStamp" is in s
  TimeStamps,      // ISO 8601, as loggers, OPC UA and MTConnect write them
  Siglent,         // the time's column is called Second
  Tektronix,       // the header stands beside the first rows
  Audacity,        // sample export: the rate in the first line
  OneBadCell,      // NaN in one of 25600 rows: a gap
  CutMidLine,      // the logger lost its power in the last line
};

FileCase userTable(const TableCut& s, UserTable table);

}  // namespace stillcut::field
