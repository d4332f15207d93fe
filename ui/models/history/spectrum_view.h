// The spectrum of the Analyse page as values: which column is looked at, the highest of the stretch, a reference, and
// what the harmonic cursor reads. GUI thread, pure functions.
#pragma once

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "ui/models/history/analyse_view.h"
#include "ui/models/history/run_history.h"

namespace stillcut::ui {

using Levels = std::array<float, kSpectrumBins>;

struct SpectrumView {
  bool known = false;
  bool atCursor = false;  // the column under cursor A, else the newest
  Levels level_dB{};
  std::optional<Levels> hold;       // highest of the stretch on show
  Hertz top{};                      // upper edge of the last bin
  Hertz spindle{}, chatter{};       // of that column; 0: not known, none
  QString time;                     // of that column, as the clock shows it
  std::vector<Hertz> toothPassing;  // harmonics up to `top`
  std::vector<Hertz> harmonics;     // of the harmonic cursor, up to `top`
  QString unit;                     // of the signal
  QString reading;                  // "1 713 Hz, order 12.0, -8.2 dB, B: -20.1 dB"; empty without a cursor
};

// SI unit of a channel; empty where there is no such channel.
QString channelUnit(const CutSetup& setup, int channel);
// "dB re 1 m/s2"; of a signal without a unit "dB".
QString decibelUnit(const QString& unit);
// "m/s2 rms".
QString rmsUnit(const QString& unit);
double amplitudeOf(double level_dB);

SpectrumView makeSpectrumView(const RunHistory& history, const AnalyseView& view, const SessionInfo& info);

// The strongest line between `low` and `high`, to a fraction of a bin (a parabola through three levels); none where the
// spectrum is flat.
std::optional<Hertz> strongestLine(const Levels& level_dB, Hertz top, Hertz low, Hertz high);

}  // namespace stillcut::ui
