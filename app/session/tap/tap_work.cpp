#include "app/session/tap/tap_work.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "app/compose/measure_samples.h"
#include "core/milling/identify/response_unit.h"
#include "core/session/open_recording.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

using identify::Axis;
using identify::AxisModes;
using identify::Frf;

constexpr std::size_t kMostLines = 1500;  // more than a screen has columns
constexpr double kBeyondBand = 1.6;       // shown above the band
constexpr double kBelowBand = 0.4;        // and below it

// The lines of a compliance that are worth a picture, from below the band to well above it: an acceleration's noise at
// a few hertz, divided by their square, would be all that is seen.
void showLines(const Frf& compliance, double from, double to, ui::TapResponse& shown) {
  const auto& f = compliance.frequency;
  const double last = compliance.usableTo > 0.0 ? std::max(compliance.usableTo, to) : kBeyondBand * to;
  const double end = to > 0.0 ? std::min(last, kBeyondBand * to) : last;
  const auto count = static_cast<std::size_t>(std::upper_bound(f.begin(), f.end(), end) - f.begin());
  const std::size_t stride = std::max<std::size_t>(1, (count + kMostLines - 1) / kMostLines);
  for (std::size_t i = 0; i < count; i += stride) {
    if (f[i] < kBelowBand * from) continue;
    shown.frequency.push_back(f[i]);
    shown.measured.push_back(compliance.value[i]);
    if (!compliance.coherence.empty()) shown.coherence.push_back(compliance.coherence[i]);
  }
}

ui::TapMode modeRow(const identify::IdentifiedMode& m) {
  ui::TapMode row;
  row.frequency = m.mode.frequency;
  row.frequencySd = m.frequencySd;
  row.damping = m.mode.damping;
  row.dampingSd = m.dampingSd;
  row.stiffness = m.mode.stiffness;
  row.stiffnessSd = m.stiffnessSd;
  row.share = m.depth;
  row.coherence = m.coherence;
  row.doubt = QString::fromStdString(m.caveat);
  return row;
}

void sharesOfSoftest(std::vector<ui::TapMode>& modes) {
  double softest = 0.0;
  for (const ui::TapMode& m : modes) softest = std::max(softest, m.share);
  for (ui::TapMode& m : modes) m.share = softest > 0.0 ? m.share / softest : 0.0;
}

void remark(const std::vector<Message>& remarks, QStringList& out) {
  for (const Message& m : remarks) out << ui::sayCore(m);
}

TapAxis failed(const Error& error) {
  TapAxis axis;
  axis.shown.state = ui::TapResponse::State::Failed;
  axis.shown.problem = ui::sayError(error);
  return axis;
}

// The response is shown also where no mode can be fitted to it.
TapAxis fromResponse(const Frf& frf, const std::vector<Message>& remarks) {
  const Frf compliance = identify::toCompliance(frf);
  auto fit = identify::fitModes(frf, {});
  TapAxis axis;
  if (!fit) axis = failed(fit.error());
  remark(remarks, axis.shown.remarks);
  showLines(compliance, fit ? fit->from : 0.0, fit ? fit->to : 0.0, axis.shown);
  if (!fit) return axis;
  axis.fit = std::move(*fit);
  axis.shown.state = ui::TapResponse::State::Done;
  axis.shown.from = axis.fit.from;
  axis.shown.to = axis.fit.to;
  for (const auto& m : axis.fit.modes) axis.shown.modes.push_back(modeRow(m));
  sharesOfSoftest(axis.shown.modes);
  remark(axis.fit.remarks, axis.shown.remarks);
  drawFit(axis);
  return axis;
}

TapAxis fromDecays(const std::vector<identify::HammerRecord>& records) {
  auto answer = identify::analyseDecays(records, {});
  if (!answer) {
    TapAxis axis = failed(answer.error());
    axis.shown.withForce = false;
    return axis;
  }
  TapAxis axis;
  axis.shown.withForce = false;
  axis.shown.state = ui::TapResponse::State::Done;
  axis.fit = std::move(answer->fit);
  axis.shown.from = axis.fit.from;
  axis.shown.to = axis.fit.to;
  showLines(answer->spectrum, axis.fit.from, axis.fit.to, axis.shown);
  for (std::size_t i = 0; i < answer->modes.size(); ++i) {
    const identify::DecayMode& m = answer->modes[i];
    ui::TapMode row = modeRow(axis.fit.modes[i]);
    row.stiffness = row.stiffnessSd = 0.0;
    row.share = m.flexibility;
    row.doubt.clear();  // said of stiffness, for the most part
    axis.shown.modes.push_back(std::move(row));
  }
  drawFit(axis);
  return axis;
}

int indexOf(Axis axis, int otherwise) {
  return axis == Axis::Y ? 1 : axis == Axis::X ? 0 : otherwise;
}

// In English, as the command line asks for it; only the screen's own words are shown.
struct AskedBy {
  std::string_view option;
  ui::TapQuestion question;
};
constexpr AskedBy kAsked[] = {{"--force-unit", ui::TapQuestion::ForceUnit},
                              {"--response-unit", ui::TapQuestion::ResponseUnit},
                              {"--force-sensitivity", ui::TapQuestion::ForceSensitivity},
                              {"--response-sensitivity", ui::TapQuestion::ResponseSensitivity},
                              {"--force-scale", ui::TapQuestion::ForceFullScale},
                              {"--response-scale", ui::TapQuestion::ResponseFullScale},
                              {"--force", ui::TapQuestion::Hammer},
                              {"--response", ui::TapQuestion::Sensor},
                              {"--frequency-unit", ui::TapQuestion::FrequencyUnit},
                              {"--phase-unit", ui::TapQuestion::PhaseUnit},
                              {"--unit", ui::TapQuestion::Unit}};

// "--force" is not asked for by "--force-unit".
bool mentions(std::string_view text, std::string_view option) {
  for (std::size_t at = text.find(option); at != std::string_view::npos; at = text.find(option, at + 1)) {
    const std::size_t after = at + option.size();
    if (after == text.size() || text[after] != '-') return true;
  }
  return false;
}

std::optional<double> typedNumber(const QString& text) {
  bool isNumber = false;
  const double value = QString(text).replace(u',', u'.').toDouble(&isNumber);
  return isNumber && value > 0.0 ? std::optional(value) : std::nullopt;
}

identify::ModalRequest requestOf(const TapReading& reading) {
  identify::ModalRequest request;
  // What is along no axis that anybody knows is shown along the one of the button.
  request.without = {{Axis::Unknown, reading.without[reading.axis == 1 ? 1 : 0]},
                     {Axis::X, reading.without[0]},
                     {Axis::Y, reading.without[1]}};
  request.hammer.flipResponse = reading.answers.flip;
  identify::ImportOptions& import = request.import;
  for (const auto& [question, said] : reading.answers.said) {
    const std::string text = said.trimmed().toStdString();
    if (text.empty()) continue;
    switch (question) {
      case ui::TapQuestion::Hammer:
        import.force = text;
        break;
      case ui::TapQuestion::Sensor:
        import.responses = {text};
        break;
      case ui::TapQuestion::ForceUnit:
        import.forceUnit = text;
        break;
      case ui::TapQuestion::ResponseUnit:
        import.responseUnit = text;
        break;
      case ui::TapQuestion::ForceSensitivity:
        import.forceSensitivity = text;
        break;
      case ui::TapQuestion::ResponseSensitivity:
        import.responseSensitivity = text;
        break;
      case ui::TapQuestion::ForceFullScale:
        import.forceScale = typedNumber(said);
        break;
      case ui::TapQuestion::ResponseFullScale:
        import.responseScale = typedNumber(said);
        break;
      case ui::TapQuestion::Unit:
        import.unit = text;
        break;
      case ui::TapQuestion::FrequencyUnit:
        import.frequencyUnit = text;
        break;
      case ui::TapQuestion::PhaseUnit:
        import.phaseUnit = text;
        break;
    }
  }
  import.open = [](const std::string& path, const record::ReadOptions& options) {
    return record::openRecording(path, options);
};
return request;
}  // namespace

// Several responses, and their channels say along which axis each lies: each axis by itself. Where none says it, the
// one of the button.
Result<identify::ModalAnswer> measureAlongAxes(const std::vector<std::string>& paths, const TapReading& reading) {
  identify::ModalRequest request = requestOf(reading);
  auto measured = identify::measureResponses(paths, request);
  if (measured || !mentions(measured.error().line(), "--axis")) return measured;
  identify::ModalAnswer both;
  std::optional<Error> why;  // of the axis in turn, where it is something else
  for (const Axis axis : {Axis::X, Axis::Y}) {
    request.import.axes = {axis};
    auto along = identify::measureResponses(paths, request);
    if (!along) {
      const bool inTurn = (axis == Axis::Y) == (reading.axis == 1);
      if (inTurn && !mentions(along.error().line(), "--axis")) why = along.error();
      continue;
    }
    for (AxisModes& found : along->axes) both.axes.push_back(std::move(found));
    if (both.remarks.empty()) both.remarks = std::move(along->remarks);
  }
  // Averages of which the file does not say along what the force acted; of hits it shows in their force.
  const bool averages = std::ranges::all_of(both.axes, [](const AxisModes& axis) { return axis.hits.empty(); });
  if (both.axes.size() == 2 && averages) {
    both.remarks.push_back(
        message("two responses and no word of the force: right only if x and y were each hit along "
                "themselves"));
  }
  if (both.axes.empty()) return why ? Result<identify::ModalAnswer>(*why) : measured;
  return both;
}

ui::TapFault faultOf(const identify::Hit& hit) {
  if (hit.forceOverload) return ui::TapFault::ForceOverload;
  if (hit.responseOverload) return ui::TapFault::ResponseOverload;
  return hit.doubleHit ? ui::TapFault::DoubleHit : ui::TapFault::None;
}

std::vector<ui::TapHitRow> rowsOf(const AxisModes& axis) {
  std::vector<ui::TapHitRow> rows;
  for (const identify::Hit& hit : axis.hits) {
    const QString file = QString::fromStdString(std::filesystem::path(axis.records[hit.record]).filename().string());
    rows.push_back({hit.peakForce, Seconds(hit.width), faultOf(hit), hit.used, file});
  }
  return rows;
}

TapFiles empty() {
  TapFiles files;
  files.axes.resize(ui::kTapAxes);
  files.there.assign(ui::kTapAxes, false);
  return files;
}

// A file of modes, as `modal` writes it.
TapFiles fromModes(const identify::ModesFile& file) {
  TapFiles files = empty();
  for (const identify::IdentifiedMode& m : file.modes) {
    const bool alongY = std::abs(m.mode.direction[1]) > std::abs(m.mode.direction[0]);
    const std::size_t at = alongY ? 1 : 0;
    TapAxis& axis = files.axes[at];
    files.there[at] = true;
    axis.fit.modes.push_back(m);
    ui::TapMode row = modeRow(m);
    row.share = 1.0 / (m.mode.stiffness * m.mode.damping);
    axis.shown.modes.push_back(std::move(row));
    axis.shown.state = ui::TapResponse::State::Done;
  }
  for (TapAxis& axis : files.axes) {
    sharesOfSoftest(axis.shown.modes);
    if (axis.shown.modes.empty()) continue;
    const double to = kBeyondBand * axis.shown.modes.back().frequency.value;
    for (std::size_t i = 1; i <= kMostLines / 2; ++i) {
      axis.shown.frequency.push_back(to * 2.0 * static_cast<double>(i) / static_cast<double>(kMostLines));
    }
    axis.shown.measured.assign(axis.shown.frequency.size(), {});
    drawFit(axis);
    axis.shown.measured = axis.shown.fitted;
  }
  return files;
}

// A channel of a hammer or of a frequency response: whatever was wrong with the file, it is no response alone.
bool speaksOfMore(const ChannelInfo& channel) {
  if (channel.quantity == SensorQuantity::Force) return true;
  const QString name = QString::fromStdString(channel.name).toLower();
  for (const char* word : {"force", "hammer", "freq", "real", "imag", "re ", "im ", "mag", "phase", "coher"}) {
    if (name.startsWith(QLatin1String(word))) return true;
  }
  return false;
}

// Recordings without a hammer channel: a phone's sound, an accelerometer alone.
Result<TapFiles> fromResponses(const std::vector<std::string>& paths, int otherwise) {
  constexpr double kLength = 0.4;  // [s] of a hit
  std::vector<std::vector<identify::HammerRecord>> records(ui::kTapAxes);
  for (const std::string& path : paths) {
    const auto heard = measureRecording(path, {});
    if (!heard) return heard.error();
    if (std::any_of(heard->channels.begin(), heard->channels.end(), speaksOfMore)) {
      return Error{path, message("has a hammer or a frequency response")};
    }
    for (std::size_t c = 0; c < heard->samples.size(); ++c) {
      const std::string& axis = heard->channels[c].axis;
      if (axis == "z" || (axis.empty() && c > 0)) continue;  // a phone's first channel, where none is named
      const std::vector<double> samples(heard->samples[c].begin(), heard->samples[c].end());
      for (identify::HammerRecord& hit : identify::cutDecays(samples, heard->rate.value, kLength)) {
        hit.source = path;
        if (heard->channels[c].quantity == SensorQuantity::Velocity) hit.quantity = identify::FrfQuantity::Mobility;
        const bool alongY = axis == "y" || (axis != "x" && otherwise == 1);
        records[alongY ? 1 : 0].push_back(std::move(hit));
      }
    }
  }
  TapFiles files = empty();
  for (std::size_t a = 0; a < records.size(); ++a) {
    if (records[a].empty()) continue;
    files.axes[a] = fromDecays(records[a]);
    files.there[a] = true;
    for (const auto& hit : records[a]) {
      const auto most = std::max_element(hit.response.begin(), hit.response.end(),
                                         [](double p, double q) { return std::abs(p) < std::abs(q); });
      const QString file = QString::fromStdString(std::filesystem::path(hit.source).filename().string());
      files.axes[a].hits.push_back({std::abs(*most), Seconds(), ui::TapFault::None, true, file});
    }
  }
  if (!files.there[0] && !files.there[1]) return Error{paths.front(), message("holds no hit")};
  return files;
}

}  // namespace stillcut::app

TapAxis fromRecords(const std::vector<identify::HammerRecord>& records, const identify::TapTestOptions& options) {
  if (!options.withForce) return fromDecays(records);
  auto analysed = identify::analyseHammer(records, options.hammer);
  if (!analysed) return failed(analysed.error());
  return fromResponse(analysed->frf, analysed->remarks);
}

std::vector<ui::TapQuestion> questionsOf(const Error& error) {
  const std::string line = error.line();
  std::vector<ui::TapQuestion> questions;
  for (const AskedBy& asked : kAsked) {
    if (mentions(line, asked.option)) questions.push_back(asked.question);
  }
  return questions;
}

bool asksToFlip(const Error& error) {
  return mentions(error.line(), "--flip");
}

Result<TapFiles> fromFiles(const std::vector<std::string>& paths, const TapReading& reading) {
  if (paths.size() == 1 && paths.front().ends_with(".toml")) {
    const auto modes = identify::loadModes(paths.front());
    if (!modes) return modes.error();
    return fromModes(*modes);
  }
  auto measured = measureAlongAxes(paths, reading);
  if (!measured) {
    auto alone = fromResponses(paths, reading.axis);
    return alone ? std::move(alone) : Result<TapFiles>(measured.error());
  }
  TapFiles files = empty();
  remark(measured->remarks, files.remarks);
  for (AxisModes& found : measured->axes) {
    const auto at = static_cast<std::size_t>(indexOf(found.axis, reading.axis));
    if (!found.frf.unitKnown) {
      auto unit = identify::unitByStiffness(found.frf, {});
      if (!unit) return unit.error();
      for (auto& v : found.frf.value) v *= unit->factor;
      found.remarks.push_back(std::move(unit->remark));
    }
    files.axes[at] = fromResponse(found.frf, found.remarks);
    files.axes[at].hits = rowsOf(found);
    files.there[at] = true;
  }
  return files;
}

void drawFit(TapAxis& axis) {
  axis.shown.fitted.assign(axis.shown.frequency.size(), {});
  for (std::size_t k = 0; k < axis.shown.modes.size(); ++k) {
    if (!axis.shown.modes[k].used) continue;
    const milling::Mode& m = axis.fit.modes[k].mode;
    for (std::size_t i = 0; i < axis.shown.frequency.size(); ++i) {
      const double u = axis.shown.frequency[i] / m.frequency.value;
      axis.shown.fitted[i] += 1.0 / (m.stiffness * std::complex<double>(1.0 - u * u, 2.0 * m.damping * u));
    }
  }
}

std::vector<identify::IdentifiedMode> tickedModes(const TapAxis& axis, int index) {
  std::vector<identify::IdentifiedMode> modes;
  for (std::size_t k = 0; k < axis.shown.modes.size(); ++k) {
    if (!axis.shown.modes[k].used || axis.shown.modes[k].stiffness <= 0.0) continue;
    modes.push_back(axis.fit.modes[k]);
    modes.back().mode.direction = index == 1 ? std::array<double, 2>{0.0, 1.0} : std::array<double, 2>{1.0, 0.0};
  }
  return modes;
}

}  // namespace stillcut::app
