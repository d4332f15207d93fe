#include "app/cli/cut_options.h"

#include <cstdio>

#include "core/milling/identify/model_files.h"

namespace stillcut::app {
namespace {

constexpr double kRadians = kTwoPi / 360.0;

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
  const auto material = identify::loadMaterial(o.material);
  if (!material) return material.error();
  parts.material = material->material;
  return parts;
}

// "START:EXIT" in degrees.
Status setAngles(milling::CutModel& model, const std::string& text) {
  const std::vector<std::string> parts = CLI::detail::split(text, ':');
  double start = 0.0, exit = 0.0;
  const bool read = parts.size() == 2 && CLI::detail::lexical_cast(parts[0], start) &&
                    CLI::detail::lexical_cast(parts[1], exit) && start >= 0.0 && exit <= 180.0 && start < exit;
  if (!read) {
    return Error{"--engagement", message("'%1' is no engagement", text),
                 message("START:EXIT in degrees, 0 to 180, as 53.13:126.87 for a centred cut")};
  }
  model.engagement = milling::engagementBetween(start * kRadians, exit * kRadians);
  return Done{};
}

}  // namespace

void addCutOptions(CLI::App& command, CutOptions& o) {
  command
      .add_option("CASE", o.file,
                  "The cut: a case, a scenario or a machine's profile (.toml), a reference case (.json)")
      ->required();
  command.add_option("--modes", o.modes, "Modes that `modal` wrote, instead of the file's; once for each axis");
  command.add_option("--material", o.material, "Coefficients that `coefficients` wrote, instead of the file's");
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

Result<CutFile> readCut(const CutOptions& o) {
  const auto parts = readParts(o);
  if (!parts) return parts.error();
  Result<CutFile> cut = loadCutFile(o.file, *parts);
  if (!cut) return cut;
  if (!o.engagement.empty()) {
    if (const Status ok = setAngles(cut->model, o.engagement); !ok) return ok.error();
  }
  if (o.offsetGiven) cut->model.engagement.offset = 2e-3 * o.offsetMm / cut->model.tool.diameter.value;
  if (const Status ok = milling::check(cut->model, o.file); !ok) return ok.error();
  for (const Message& remark : cut->remarks) std::fprintf(stderr, "warning: %s\n", text(remark).c_str());
  return cut;
}

}  // namespace stillcut::app
