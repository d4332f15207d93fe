#include "core/milling/identify/modal_measurement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "core/milling/identify/hits_by_axis.h"
#include "core/milling/identify/response_unit.h"

namespace stillcut::identify {
namespace {

// All that was read, sorted by axis.
struct Sorted {
  std::map<Axis, std::vector<HammerRecord>> records;
  std::map<Axis, std::vector<Frf>> frfs;
  std::vector<Message> remarks;
};

ImportOptions optionsOf(const ModalRequest& request, std::size_t file, std::size_t files) {
  ImportOptions options = request.import;
  if (files > 1 && options.axes.size() == files) options.axes = {request.import.axes[file]};
  return options;
}

Result<Sorted> readAll(const std::vector<std::string>& paths, const ModalRequest& request) {
  Sorted sorted;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    auto measured = importMeasurement(paths[i], optionsOf(request, i, paths.size()));
    if (!measured) return measured.error();
    for (Message& remark : measured->remarks) {
      const bool said = std::find(sorted.remarks.begin(), sorted.remarks.end(), remark) != sorted.remarks.end();
      if (!said) sorted.remarks.push_back(std::move(remark));
    }
    if (auto* records = std::get_if<std::vector<HammerRecord>>(&measured->data)) {
      for (HammerRecord& record : *records) sorted.records[record.axis].push_back(std::move(record));
    } else {
      for (Frf& frf : std::get<std::vector<Frf>>(measured->data)) sorted.frfs[frf.axis].push_back(std::move(frf));
    }
  }
  return sorted;
}

// Frequency responses come averaged: two of one axis are two structures, or two states of one.
Result<AxisModes> fromFrf(std::vector<Frf> frfs, const HammerOptions& options) {
  if (frfs.size() > 1) {
    return Error{frfs[1].source, message("is a second frequency response of the axis of %1", frfs[0].source),
                 message("name one file for each axis, as --axis x,y")};
  }
  AxisModes axis;
  axis.frf = std::move(frfs.front());
  axis.axis = axis.frf.axis;
  if (options.flipResponse) {
    for (auto& v : axis.frf.value) v = -v;
  }
  return axis;
}

Result<AxisModes> fromHammer(const std::vector<HammerRecord>& records, const HammerOptions& options) {
  auto analysed = analyseHammer(records, options);
  if (!analysed) return analysed.error();
  AxisModes axis;
  axis.axis = records.front().axis;
  axis.fromHammer = true;
  for (const HammerRecord& record : records) axis.records.push_back(record.source);
  axis.hits = std::move(analysed->hits);
  axis.remarks = std::move(analysed->remarks);
  axis.frf = std::move(analysed->frf);
  return axis;
}

// Every axis by itself; where a record holds hits along x and along y, each with its own.
Result<std::vector<AxisModes>> fromHammers(const std::map<Axis, std::vector<HammerRecord>>& records,
                                           const ModalRequest& request) {
  std::array<std::vector<int>, 2> alongOther;
  const auto analyse = [&](Axis axis) {
    HammerOptions hammer = request.hammer;
    if (const auto out = request.without.find(axis); out != request.without.end()) hammer.without = out->second;
    hammer.alongOther = alongOther[axis == Axis::Y ? 1 : 0];
    return fromHammer(records.at(axis), hammer);
  };
  std::vector<AxisModes> axes;
  for (const auto& [axis, ignored] : records) {
    auto one = analyse(axis);
    if (!one) return one.error();
    axes.push_back(std::move(*one));
  }
  const bool both = axes.size() == 2 && axes[0].axis == Axis::X && axes[1].axis == Axis::Y;
  if (!both || axes[0].records != axes[1].records) return axes;
  alongOther = hitsAlongOther(axes[0].hits, axes[1].hits);
  for (AxisModes& axis : axes) {
    if (alongOther[0].empty()) break;
    auto own = analyse(axis.axis);
    if (!own) return own.error();
    axis = std::move(*own);
  }
  return axes;
}

}  // namespace

Result<ModalAnswer> measureResponses(const std::vector<std::string>& paths, const ModalRequest& request) {
  const std::size_t axes = request.import.axes.size();
  if (paths.size() > 1 && axes > 1 && axes != paths.size() && axes != 2) {
    return Error{message("--axis"), message("names %1 axes for %2 files", axes, paths.size()),
                 message("one for all, or one for each file")};
  }
  auto sorted = readAll(paths, request);
  if (!sorted) return sorted.error();
  if (!request.takesZ && sorted->frfs.contains(Axis::Z)) return measuredAlongZ(sorted->frfs[Axis::Z][0].source);
  if (!request.takesZ && sorted->records.contains(Axis::Z)) return measuredAlongZ(sorted->records[Axis::Z][0].source);
  ModalAnswer answer;
  answer.remarks = std::move(sorted->remarks);
  for (auto& [axis, frfs] : sorted->frfs) {
    if (sorted->records.contains(axis)) {
      return Error{frfs[0].source, message("is a frequency response beside hammer records of the same axis"),
                   message("name either of them")};
    }
    auto one = fromFrf(std::move(frfs), request.hammer);
    if (!one) return one.error();
    answer.axes.push_back(std::move(*one));
  }
  auto hammered = fromHammers(sorted->records, request);
  if (!hammered) return hammered.error();
  for (AxisModes& one : *hammered) answer.axes.push_back(std::move(one));
  std::sort(answer.axes.begin(), answer.axes.end(),
            [](const AxisModes& a, const AxisModes& b) { return a.axis < b.axis; });
  return answer;
}

namespace {

// A wrong unit or scale gives numbers that no tool has. Nobody is refused: it may be a workpiece.
std::vector<Message> whatNoToolHas(const AxisModes& axis) {
  std::vector<Message> remarks;
  constexpr double kLongestHit = 0.02;  // [s]; a soft tip on a heavy part takes 5 ms
  for (const Hit& hit : axis.hits) {
    if (hit.width < kLongestHit) continue;
    remarks.push_back(message("a hit is %1 ms wide, and no hammer's is: is the time of the file in seconds?",
                              std::lround(1e3 * hit.width)));
    break;
  }
  double softest = std::numeric_limits<double>::infinity();
  for (const IdentifiedMode& m : axis.fit.modes) softest = std::min(softest, m.mode.stiffness);
  if (softest < kSoftestTool || (std::isfinite(softest) && softest > kStiffestTool)) {
    char stiffness[16];
    std::snprintf(stiffness, sizeof stiffness, "%.2g", softest);
    remarks.push_back(message("the softest mode has %1 N/m, and tools have 1e5 to 1e9: are the units right?",
                              std::string(stiffness)));
  }
  return remarks;
}

}  // namespace

Status findUnits(ModalAnswer& answer, const ModalOptions& options) {
  for (AxisModes& axis : answer.axes) {
    if (axis.frf.unitKnown) continue;
    auto unit = unitByStiffness(axis.frf, options);
    if (!unit) return unit.error();
    for (auto& v : axis.frf.value) v *= unit->factor;
    axis.frf.unitKnown = true;
    axis.remarks.push_back(std::move(unit->remark));
  }
  return Done{};
}

Error measuredAlongZ(const std::string& source) {
  return Error{
      source, message("its response is along z, and lobes are computed from x and y"),
      message("if the sensor sat along x or y, name it: --response CHANNEL or --dataset NUMBER, and --axis x")};
}

Result<ModalAnswer> identifyModes(const std::vector<std::string>& paths, const ModalRequest& request) {
  auto answer = measureResponses(paths, request);
  if (!answer) return answer;
  if (const Status known = findUnits(*answer, request.fit); !known) return known.error();
  for (AxisModes& axis : answer->axes) {
    auto fit = fitModes(axis.frf, request.fit);
    if (!fit) return fit.error();
    axis.remarks.insert(axis.remarks.end(), fit->remarks.begin(), fit->remarks.end());
    axis.fit = std::move(*fit);
    for (Message& remark : whatNoToolHas(axis)) axis.remarks.push_back(std::move(remark));
  }
  return answer;
}

}  // namespace stillcut::identify
