#include "app/session/tool_cut.h"

#include <filesystem>
#include <numeric>

#include "app/session/tap/tap_materials.h"
#include "core/config/toml_reader.h"
#include "core/milling/identify/model_files.h"
#include "core/milling/stability/lobe_case.h"
#include "ui/models/setup_draft.h"

namespace stillcut::app {

bool holdsModesAlone(const std::string& path) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(path, problem) || path.ends_with(".json")) return false;
  const config::TomlReader in = config::TomlReader::file(path);
  return !in.error() && in.root().has("mode") && !in.root().has("tool");
}

Status writeCut(const ui::ToolEntry& tool, const std::string& modesPath, const std::string& path) {
  const auto modes = identify::loadModes(modesPath);
  if (!modes) return modes.error();
  const TapMaterialRow* material = findTapMaterial(tool.material.toStdString());
  if (material == nullptr) {
    std::string known;
    for (const TapMaterialRow& row : tapMaterials()) known += (known.empty() ? "" : ", ") + std::string(row.id);
    return Error{modesPath, message("holds modes alone"), message("say what the tool cuts: %1", known)};
  }
  milling::LobeCase cut;
  cut.name = tool.name.toStdString();
  for (const identify::IdentifiedMode& m : modes->modes) cut.model.modes.push_back(m.mode);
  cut.model.tool.teeth = tool.teeth;
  cut.model.tool.diameter = Metres(1e-3 * tool.diameter_mm);
  cut.model.tool.pitch = ui::pitchAngles(tool).value_or(std::vector<double>());
  const double around = std::accumulate(cut.model.tool.pitch.begin(), cut.model.tool.pitch.end(), 0.0);
  for (double& angle : cut.model.tool.pitch) angle *= kTwoPi / around;
  cut.model.material = material->material;
  if (tool.deepest_mm > 0.0) cut.maxAxialDepth = Metres(1e-3 * tool.deepest_mm);
  if (Status sane = milling::check(cut.model, modesPath); !sane) return sane;
  std::error_code problem;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), problem);
  return milling::saveLobeCase(cut, path);
}

QString fileNameOf(const QString& name) {
  QString base;
  for (const QChar c : name.trimmed()) base += c.isLetterOrNumber() || c == u'.' || c == u'-' ? c : QChar(u'-');
  if (base.isEmpty() || base.startsWith(u'.')) base.prepend(QStringLiteral("tap"));
  return base + QStringLiteral(".toml");
}

}  // namespace stillcut::app
