#include "app/cli/cut_options.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "core/milling/identify/modal_measurement.h"
#include "core/milling/identify/model_files.h"
#include "core/milling/material_table.h"

namespace stillcut::app {
namespace {

constexpr double kRadians = kTwoPi / 360.0;

milling::MeasuredResponse measuredOf(const identify::Frf& frf) {
  identify::Frf compliance = identify::toCompliance(frf);
  return {std::move(compliance.frequency), std::move(compliance.value)};
}

Result<identify::ModalAnswer> readResponses(const CutOptions& o) {
  identify::ModalRequest request;
  request.import = o.import;
  request.import.kind = identify::MeasurementKind::Frf;
  for (const std::string& axis : o.responseAxes) request.import.axes.push_back(identify::axisFromLetter(axis[0]));
  request.hammer.flipResponse = o.flip;
  auto answer = identify::measureResponses(o.responses, request);
  if (!answer) return answer;
  if (const Status known = identify::findUnits(*answer, {}); !known) return known.error();
  return answer;
}

// Nothing can be fitted to a cross response that would tell its unit.
Result<milling::MeasuredResponse> readCross(const CutOptions& o) {
  identify::ImportOptions import;
  import.kind = identify::MeasurementKind::Frf;
  import.cross = true;
  import.unit = o.crossUnit;
  import.frequencyUnit = o.import.frequencyUnit;
  import.phaseUnit = o.import.phaseUnit;
  const auto read = identify::importMeasurement(o.crossResponse, import);
  if (!read) return read.error();
  for (const Message& remark : read->remarks) std::fprintf(stderr, "%s\n", text(remark).c_str());
  const identify::Frf& frf = std::get<std::vector<identify::Frf>>(read->data).front();
  if (!frf.unitKnown) {
    return Error{o.crossResponse, message("does not say the unit of its response"),
                 message("give --frf-cross-unit m/N, mm/N, um/N, (m/s^2)/N or g/N")};
  }
  return measuredOf(frf);
}

// The responses themselves, and for the methods that need them modes with the residuals of their fit.
Status takeResponses(const CutOptions& o, milling::ModelParts& parts, milling::MeasuredReceptance& measured) {
  const auto answer = readResponses(o);
  if (!answer) return answer.error();
  for (const Message& remark : answer->remarks) std::fprintf(stderr, "%s\n", text(remark).c_str());
  for (const identify::AxisModes& one : answer->axes) {
    for (const Message& remark : one.remarks) std::fprintf(stderr, "%s\n", text(remark).c_str());
    const bool y = one.axis == identify::Axis::Y;
    (y ? measured.yy : measured.xx) = measuredOf(one.frf);
    const auto fit = identify::fitModes(one.frf, {});
    if (!fit) return fit.error();
    std::vector<milling::Mode> modes = fit->whole;
    for (milling::Mode& m : modes) {
      m.direction = y ? std::array{0.0, 1.0} : std::array{1.0, 0.0};
      parts.modes.push_back(m);
    }
    std::fprintf(stderr, "%s: %zu modes, %d of them for what lies outside %.0f to %.0f Hz, misfit %.1f %%\n",
                 y ? "y" : "x", fit->whole.size(), fit->outside, fit->from, fit->to, 100.0 * fit->realMisfit);
    constexpr double kPoor = 0.1;
    if (fit->realMisfit > kPoor) {
      std::fprintf(stderr, "warning: real modes leave much of this response out: --method zoa takes it as it is\n");
    }
  }
  if (!o.crossResponse.empty()) {
    auto cross = readCross(o);
    if (!cross) return cross.error();
    measured.xy = std::move(*cross);
  }
  return measured.check("--frf");
}

// What `modal` and `coefficients` wrote, several files of modes together (one for each axis hit).
Result<milling::ModelParts> readParts(const CutOptions& o) {
  milling::ModelParts parts;
  for (const std::string& file : o.modes) {
    const auto modes = identify::loadModes(file);
    if (!modes) return modes.error();
    for (const identify::IdentifiedMode& m : modes->modes) {
      parts.modes.push_back(m.mode);
      if (m.caveat.empty()) continue;
      std::fprintf(stderr, "warning: %s: the mode at %.0f Hz %s\n", file.c_str(), m.mode.frequency.value,
                   m.caveat.c_str());
    }
  }
  if (o.material.empty()) return parts;
  std::error_code none;
  if (!std::filesystem::exists(o.material, none) && std::filesystem::path(o.material).extension() != ".toml") {
    const auto named = milling::materialNamed(o.material, "--material");
    if (!named) return named.error();
    parts.material = named.value();
    return parts;
  }
  const auto material = identify::loadMaterial(o.material);
  if (!material) return material.error();
  parts.material = material->material;
  return parts;
}

// "START:EXIT" in degrees.
Result<milling::Engagement> angles(const std::string& text) {
  const std::vector<std::string> parts = CLI::detail::split(text, ':');
  double start = 0.0, exit = 0.0;
  const bool read = parts.size() == 2 && CLI::detail::lexical_cast(parts[0], start) &&
                    CLI::detail::lexical_cast(parts[1], exit) && start >= 0.0 && exit <= 180.0 && start < exit;
  if (!read) {
    return Error{"--engagement", message("'%1' is no engagement", text),
                 message("START:EXIT in degrees, 0 to 180, as 53.13:126.87 for a centred cut")};
  }
  return milling::engagementBetween(start * kRadians, exit * kRadians);
}

}  // namespace

void addCutOptions(CLI::App& command, CutOptions& o) {
  command
      .add_option("CASE", o.file,
                  "The cut: a case, a scenario or a machine's profile (.toml), a reference case (.json)")
      ->required();
  command.add_option("--modes", o.modes, "Modes that `modal` wrote, instead of the file's; once for each axis");
  command.add_option("--material", o.material,
                     "Coefficients that `coefficients` wrote, or a name that `materials` lists, instead of the file's");
  command
      .add_option(
          "--frf", o.responses,
          "Frequency responses of the tool's tip along x and y, instead of modes: zoa takes them as they are, the "
          "others a fit with its residuals")
      ->excludes("--modes");
  command
      .add_option("--frf-axis,--axis", o.responseAxes,
                  "Their axes, where the files do not say: x, y, one for each file")
      ->delimiter(',')
      ->check(CLI::IsMember({"x", "y"}));
  command.add_option("--unit", o.import.unit, "Unit of the responses, where the files do not say: m/N, um/N, g/N ...")
      ->needs("--frf");
  command.add_option("--frequency-unit", o.import.frequencyUnit, "Unit of their frequencies: Hz, kHz, rad/s")
      ->needs("--frf");
  command.add_option("--phase-unit", o.import.phaseUnit, "Unit of their phase: deg, rad")->needs("--frf");
  command.add_option("--response", o.import.responses, "The response along the force, of several in a file")
      ->needs("--frf")
      ->delimiter(',');
  command.add_flag("--flip", o.flip, "The responses point against the force")->needs("--frf");
  CLI::Option* cross =
      command.add_option("--frf-cross", o.crossResponse, "Response along one axis to a force along the other, for zoa")
          ->needs("--frf");
  command.add_option("--frf-cross-unit", o.crossUnit, "Its unit, where the file does not say")->needs(cross);
  command
      .add_option("--feed", o.feedMm,
                  "Feed per tooth [mm], instead of the file's: for force laws that are not straight, removal and "
                  "vibration")
      ->check(CLI::PositiveNumber);
  command.add_option("--engagement", o.engagement, "START:EXIT of the cut [degrees], 0:180 is a slot");
  command
      .add_option_function<double>(
          "--offset",
          [&o](double mm) {
            o.offsetMm = mm;
            o.offsetGiven = true;
          },
          "Middle of the cut from the tool's axis, to the left of the feed [mm]; 0 is a centred cut")
      ->excludes("--engagement");
}

CLI::Option* addSpread(CLI::App& command, std::vector<double>& percent, const std::string& what) {
  return command
      .add_option("--spread", percent,
                  "FREQUENCY,DAMPING,STIFFNESS,FORCE: standard deviations of the model [%]; " + what +
                      ". FORCE may be left out where the material has a spread of its own")
      ->delimiter(',');
}

Result<milling::ModelSpread> spreadOf(const std::vector<double>& percent, const milling::Material& material) {
  milling::ModelSpread spread;
  if (percent.empty()) return spread;
  if (percent.size() != 4 && !(percent.size() == 3 && material.spread > 0.0)) {
    return Error{"--spread", message("needs four numbers"), message("FREQUENCY,DAMPING,STIFFNESS,FORCE in percent")};
  }
  spread.frequency = 0.01 * percent[0];
  spread.damping = 0.01 * percent[1];
  spread.stiffness = 0.01 * percent[2];
  spread.force = percent.size() == 4 ? 0.01 * percent[3] : material.spread;
  spread.processDamping = material.dampingSpread;
  if (Status ok = milling::check(spread, "--spread"); !ok) return ok.error();
  return spread;
}

// A tap test along one axis says nothing of the other.
void warnOfRigidAxis(const std::vector<milling::Mode>& modes) {
  for (const std::size_t axis : {0U, 1U}) {
    const auto moves = [axis](const milling::Mode& m) { return m.direction[axis] != 0.0; };
    if (modes.empty() || std::any_of(modes.begin(), modes.end(), moves)) continue;
    std::fprintf(stderr,
                 "warning: nothing was measured along %s: taken as rigid there, and the true limit may be far lower\n",
                 axis == 0 ? "x" : "y");
  }
}

Result<CutFile> readCut(const CutOptions& o) {
  auto parts = readParts(o);
  if (!parts) return parts.error();
  milling::MeasuredReceptance measured;
  if (!o.responses.empty()) {
    if (const Status ok = takeResponses(o, parts.value(), measured); !ok) return ok.error();
  }
  warnOfRigidAxis(parts->modes);
  CutChanges changes;
  changes.feedPerTooth = Metres(1e-3 * o.feedMm);
  if (!o.engagement.empty()) {
    const auto engagement = angles(o.engagement);
    if (!engagement) return engagement.error();
    changes.engagement = *engagement;
  }
  if (o.offsetGiven) changes.offset = Metres(1e-3 * o.offsetMm);
  Result<CutFile> cut = loadCutFile(o.file, *parts, changes);
  if (!cut) return cut;
  if (cut->model.turning && (o.offsetGiven || !o.engagement.empty())) {
    return Error{o.offsetGiven ? "--offset" : "--engagement", message("a turning cut has none"),
                 message("its edge cuts all the time")};
  }
  if (!o.responses.empty()) cut->measured = std::move(measured);
  if (const Status ok = milling::check(cut->model, o.file); !ok) return ok.error();
  for (const Message& remark : cut->remarks) std::fprintf(stderr, "warning: %s\n", text(remark).c_str());
  return cut;
}

}  // namespace stillcut::app
