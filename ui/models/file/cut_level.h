// How loud the cut is in a recording, so that two of them can be compared. GUI thread, values.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/model/recording_spectra.h"
#include "ui/facade/file_controller.h"

namespace stillcut::ui {

// Mean power of the spectra on show in what was judged and is no air [dB re 1 SI unit]; empty: there is nothing of it.
inline std::optional<double> cutLevelDb(const Spectra* spectra, const FileAnswer* answer) {
  if (spectra == nullptr || answer == nullptr || answer->tracks.empty()) return {};
  double power = 0.0;
  int count = 0;
  for (int k = 0; k < spectra->columns; ++k) {
    const Seconds at = spectra->first + spectra->step * static_cast<double>(k);
    const auto inCut = [&](const FileState& state) {
      return state.judged && state.state != CutState::AirCutting && at >= state.begin && at < state.end;
    };
    const auto& states = answer->tracks.front().states;
    if (std::none_of(states.begin(), states.end(), inCut)) continue;
    const float* column = spectra->column(k);
    if (!std::isfinite(column[spectra->bins / 2])) continue;  // samples are missing
    for (int b = 0; b < spectra->bins; ++b) power += std::pow(10.0, 0.1 * static_cast<double>(column[b]));
    ++count;
  }
  if (count == 0 || !(power > 0.0)) return {};
  return 10.0 * std::log10(power / count);
}

}  // namespace stillcut::ui
