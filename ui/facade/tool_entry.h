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

// What became of a tool, and when.
struct ToolEvent {
  QString day;  // "2026-05-04"
  QString what;
  bool operator==(const ToolEvent&) const = default;
};

struct ToolEntry {
  QString name;    // "T12 D12 Z4 R0.5"
  QString holder;  // "HSK63 shrink-fit, stick-out 48"
  int teeth = 2;
  double diameter_mm = 10.0;
  QString pitch;                  // angles between the teeth in degrees, "90 90 90 90"; empty: even
  QString modes;                  // file with its modes; empty: not measured
  double highestSpeed_rpm = 0.0;  // of tool and holder; 0: no limit said
  double lowestSpeed_rpm = 0.0;   // 0: no limit said
  double stickOut_mm = 0.0;       // 0: not said
  double deepest_mm = 0.0;        // that it may cut: length of its flutes; 0: not said
  QString material;               // it usually cuts, by its id; wanted where `modes` holds modes alone
  QString response;               // file with its frequency response; empty: none
  QString notes;
  std::vector<ChatterNote> chattered;
  std::vector<ToolEvent> history;  // oldest first
  bool operator==(const ToolEntry&) const = default;
};

}  // namespace stillcut::ui
