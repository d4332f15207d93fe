// A tool in its holder, as the shop keeps it. Plain value.
#pragma once

#include <QString>
#include <vector>

namespace stillcut::ui {

// "Chattered here before".
struct ChatterNote {
  double speed_rpm = 0.0, depth_mm = 0.0, frequency_hz = 0.0;
  QString note;
  bool operator==(const ChatterNote&) const = default;
};

struct ToolEntry {
  QString name;    // "T12 D12 Z4 R0.5"
  QString holder;  // "HSK63 shrink-fit, stick-out 48"
  int teeth = 2;
  double diameter_mm = 10.0;
  QString pitch;                  // angles between the teeth in degrees, "90 90 90 90"; empty: even
  QString modes;                  // file with its modes; empty: not measured
  double highestSpeed_rpm = 0.0;  // of tool and holder; 0: no limit said
  QString notes;
  std::vector<ChatterNote> chattered;
  bool operator==(const ToolEntry&) const = default;
};

}  // namespace stillcut::ui
