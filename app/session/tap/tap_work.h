// What takes a tap test longer than a screen may wait: files, averages, fits, lobes. Pure functions. Thread: any.
#pragma once

#include <array>
#include <stop_token>
#include <string>
#include <vector>

#include "core/milling/identify/live/free_decay.h"
#include "core/milling/identify/live/tap_test.h"
#include "core/milling/identify/modal_measurement.h"
#include "core/milling/identify/model_files.h"
#include "ui/facade/tap_controller.h"

namespace stillcut::app {

// What is known along one axis, and what the screen shows of it.
struct TapAxis {
  ui::TapResponse shown;
  identify::ModalFit fit;           // with force
  std::vector<ui::TapHitRow> hits;  // of files
};

// Of hits that were taken here; at least one record.
TapAxis fromRecords(const std::vector<identify::HammerRecord>& records, const identify::TapTestOptions& options);

using TapHitsOut = std::array<std::vector<int>, ui::kTapAxes>;
struct TapFiles {
  std::vector<TapAxis> axes;  // kTapAxes of them
  std::vector<bool> there;    // which were measured
  QStringList remarks;
};
struct TapReading {
  int axis = 0;        // of files that name none
  TapHitsOut without;  // hits left out along each axis, as they are numbered over all files, from 1
  ui::TapAnswers answers;
};
// Hammer records, frequency responses, a file of modes, or recordings without force. Where the channels name both axes
// both are taken.
Result<TapFiles> fromFiles(const std::vector<std::string>& paths, const TapReading& reading);
// What an error of fromFiles() asks for.
std::vector<ui::TapQuestion> questionsOf(const Error& error);
bool asksToFlip(const Error& error);

// The ticked modes' compliance at the lines shown.
void drawFit(TapAxis& axis);
// Along the axis, with their deviations; what is not ticked is left out.
std::vector<identify::IdentifiedMode> tickedModes(const TapAxis& axis, int index);

milling::CutModel cutModel(const std::vector<identify::IdentifiedMode>& modes, const milling::Material& material,
                           const ui::TapCut& cut);
// Limits, their band and the cut that is recommended; or, without stiffness, speeds to try.
ui::TapLobes tapLobes(const std::vector<identify::IdentifiedMode>& modes, const milling::Material& material,
                      double materialSpread, const ui::TapCut& cut, const std::stop_token& stop);
std::vector<ui::TapSpeed> speedsToTry(const TapAxis& axis, const ui::TapCut& cut);

}  // namespace stillcut::app
