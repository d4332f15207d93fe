// Panels of figures, made from traces of cuts.
// Thread: one.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/cli/reproduce/cut_trace.h"
#include "app/cli/reproduce/picture.h"

namespace stillcut::app {

using OfRow = std::function<double(const TraceRow&)>;

// Of the spindle as it turns; before it does it would lay out the axis from 0 on.
double turningSpeed(const TraceRow& row);
double askedSpeed(const TraceRow& row);

enum class Along { Time, Path };

// One quantity of several cuts over time or path.
Panel rowsPanel(const std::string& title, const std::string& yLabel, std::span<const CutTrace* const> traces,
                const OfRow& value, Along along = Along::Time);
// An indicator of a detector, where its verdict is valid.
Panel indicatorPanel(const std::string& title, const std::string& yLabel, const CutTrace& trace,
                     std::string_view detector, std::string_view indicator, Along along = Along::Time);
// The samples of a channel.
Panel signalPanel(const std::string& title, const CutTrace& trace, int channel);

struct Stretch {
  double from = 0.0, to = 0.0;  // [s]
};
std::vector<double> cutOut(const CutTrace& trace, int channel, Stretch stretch);
// Power spectral density by averaged Hann windows of `window` seconds. Curve over Hz.
Curve density(const std::string& name, std::span<const double> samples, Hertz rate, double window);
double lineAt(const Curve& density, double from, double to);  // Hz of the greatest within
Panel densityPanel(const std::string& title, const std::string& unit, std::vector<Curve> curves, double to_Hz);
Panel spectrogramPanel(const std::string& title, const CutTrace& trace, int channel, double window, double to_Hz);

// x split as Caliskan does: what repeats with the spindle (the recursion of turning_harmonics.h), and the rest.
struct Separated {
  std::vector<double> periodic, rest;
};
Separated separated(std::span<const double> samples, Hertz rate, Hertz spindle, int harmonics, double lambda);

}  // namespace stillcut::app
