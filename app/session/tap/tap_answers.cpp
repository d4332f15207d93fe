#include <QDate>
#include <QDir>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/session/tap/tap_bench.h"
#include "app/session/tap/tap_materials.h"
#include "app/session/tool_cut.h"
#include "core/milling/identify/model_files.h"
#include "core/milling/stability/lobe_case.h"
#include "ui/base/say.h"

// What a tap test gives: files in the place of a device, modes, lobes, and what is kept of them.
namespace stillcut::app {

void TapBench::openFiles(const QStringList& paths) {
  if (paths.isEmpty()) return;
  stopListening();
  const bool measured = std::any_of(axes_.begin(), axes_.end(), [](const Axis& axis) { return axis.test.has_value(); });
  if (!files_.isEmpty() || !measured) {
    files_ = paths;
    without_ = {};
    return readFiles();
  }
  // What was measured here goes only when there is something in its place.
  std::vector<std::string> names;
  for (const QString& path : paths) names.push_back(path.toStdString());
  reading_.start(
      ui::TaskState::What::Reading, paths.front(),
      [this, names, paths](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
        if (auto read = fromFiles(names, {}); !read) return read.error();
        return BackgroundTask::Apply([this, paths] {
          files_ = paths;
          without_ = {};
          readFiles();
        });
      },
      [this](const Error& error) {
        listening_.state = ui::TapListening::State::Failed;
        listening_.problem = ui::sayError(error);
      });
}

void TapBench::readFiles() {
  std::vector<std::string> paths;
  for (const QString& path : files_) paths.push_back(path.toStdString());
  for (Axis& axis : axes_) {
    axis.fitting.leave();
    axis.test.reset();
    axis.known.shown.state = ui::TapResponse::State::Working;
    changed(axis.known.shown);
  }
  const auto failed = [this](const Error& error) {
    for (Axis& axis : axes_) take(axis, {});
    axes_[0].known.shown.state = ui::TapResponse::State::Failed;
    axes_[0].known.shown.problem = ui::sayError(error);
  };
  reading_.start(
      ui::TaskState::What::Reading, files_.front(),
      [this, paths, without = without_](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
        auto read = fromFiles(paths, without);
        if (!read) return read.error();
        return BackgroundTask::Apply([this, read = std::move(*read)]() mutable {
          for (std::size_t a = 0; a < read.axes.size(); ++a) {
            if (read.there[a]) read.axes[a].shown.remarks = read.remarks + read.axes[a].shown.remarks;
            take(axes_[a], std::move(read.axes[a]));
          }
        });
      },
      failed);
}

const ui::TapResponse& TapBench::response(int axis) const {
  return axisOf(axis).known.shown;
}

void TapBench::useMode(int axis, std::size_t mode, bool use) {
  TapAxis& known = axisOf(axis).known;
  if (mode >= known.shown.modes.size()) return;
  known.shown.modes[mode].used = use;
  drawFit(known);
  changed(known.shown);
  computeAnew();
}

std::vector<ui::TapMaterial> TapBench::materials() const {
  std::vector<ui::TapMaterial> all;
  for (const TapMaterialRow& row : tapMaterials()) {
    all.push_back(
        {QString::fromUtf8(row.id.data(), static_cast<qsizetype>(row.id.size())), ui::sayCore(std::string(row.name))});
  }
  return all;
}

std::vector<identify::IdentifiedMode> TapBench::modes() const {
  std::vector<identify::IdentifiedMode> all;
  for (int a = 0; a < ui::kTapAxes; ++a) {
    const auto ticked = tickedModes(axisOf(a).known, a);
    all.insert(all.end(), ticked.begin(), ticked.end());
  }
  return all;
}

void TapBench::compute(const ui::TapCut& cut) {
  asked_ = cut;
  computeAnew();
}

void TapBench::computeAnew() {
  stopLobes_.request_stop();
  computing_.leave();
  lobes_ = {};
  lobes_.version = ++versions_;
  if (!asked_) return;
  lobes_.cut = *asked_;
  const auto all = modes();
  if (all.empty()) {
    for (const Axis& axis : axes_) {
      const auto more = speedsToTry(axis.known, *asked_);
      lobes_.toTry.insert(lobes_.toTry.end(), more.begin(), more.end());
    }
    if (!lobes_.toTry.empty()) lobes_.state = ui::TapLobes::State::Done;
    return;
  }
  lobes_.state = ui::TapLobes::State::Working;
  stopLobes_ = std::stop_source();
  int rigid = -1;
  for (int a = 0; a < ui::kTapAxes; ++a) {
    if (tickedModes(axisOf(a).known, a).empty()) rigid = a;
  }
  const TapMaterialRow& material = tapMaterial(asked_->material.toStdString());
  computing_.start(ui::TaskState::What::None, {},
                   [this, all, material, rigid, cut = *asked_,
                    stop = stopLobes_.get_token()](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
                     auto found = tapLobes(all, material.material, material.spread, cut, stop);
                     return BackgroundTask::Apply([this, rigid, found = std::move(found)]() mutable {
                       found.version = ++versions_;
                       found.rigid = rigid;
                       lobes_ = std::move(found);
                     });
                   });
}

Result<QString> TapBench::saveModes(const QString& name) {
  identify::ModesFile file;
  file.modes = modes();
  if (file.modes.empty()) return Error{message("modes"), message("there are none to keep")};
  file.source = files_.isEmpty() ? "tap test" : files_.join(QStringLiteral(", ")).toStdString();
  bool first = true;
  for (const Axis& axis : axes_) {
    const identify::ModalFit& fit = axis.known.fit;
    if (fit.modes.empty()) continue;
    file.from = first ? fit.from : std::min(file.from, fit.from);
    file.to = std::max(file.to, fit.to);
    file.misfit = std::max(file.misfit, fit.misfit);
    file.realMisfit = std::max(file.realMisfit, fit.realMisfit);
    file.writtenMisfit = std::max(file.writtenMisfit, fit.writtenMisfit);
    first = false;
    // Residuals stand beside all modes of a fit, not beside some.
    const auto& rows = axis.known.shown.modes;
    const bool all = std::all_of(rows.begin(), rows.end(), [](const ui::TapMode& m) { return m.used; });
    if (!all || !(fit.residual.at > 0.0)) continue;
    file.residuals.push_back(fit.residual);
    file.residuals.back().direction =
        &axis == &axes_[1] ? std::array<double, 2>{0.0, 1.0} : std::array<double, 2>{1.0, 0.0};
  }
  const auto path = fileIn("modes", name);
  if (!path) return path.error();
  if (Status saved = identify::saveModes(file, path->toStdString()); !saved) return saved.error();
  return *path;
}

Result<QString> TapBench::fileIn(const char* folder, const QString& name) const {
  if (folder_.isEmpty()) return Error{message("modes"), message("there is no folder to keep them in")};
  const QDir place(QDir(folder_).filePath(QLatin1String(folder)));
  std::error_code problem;
  std::filesystem::create_directories(place.absolutePath().toStdString(), problem);
  return place.absoluteFilePath(fileNameOf(name));
}

QStringList TapBench::tools() const {
  QStringList names;
  const auto known = library ? library() : Result<std::vector<ui::ToolEntry>>(std::vector<ui::ToolEntry>());
  if (!known) return names;
  for (const ui::ToolEntry& tool : *known) names << tool.name;
  return names;
}

ui::TapCut TapBench::withTool(ui::TapCut cut, const QString& name) const {
  const auto known = library ? library() : Result<std::vector<ui::ToolEntry>>(std::vector<ui::ToolEntry>());
  if (!known) return cut;
  for (const ui::ToolEntry& tool : *known) {
    if (tool.name != name) continue;
    const double width = cut.immersion * cut.diameter.value;
    cut.teeth = tool.teeth;
    cut.diameter = Metres(1e-3 * tool.diameter_mm);
    cut.immersion = std::clamp(width / cut.diameter.value, 0.005, 1.0);
    if (tool.deepest_mm > 0.0) cut.deepest = Metres(1e-3 * tool.deepest_mm);
    if (tool.lowestSpeed_rpm > 0.0) cut.lowest = Rpm(tool.lowestSpeed_rpm);
    if (tool.highestSpeed_rpm > 0.0) cut.highest = Rpm(tool.highestSpeed_rpm);
    break;
  }
  return cut;
}

Result<QString> TapBench::saveCut(const QString& tool) {
  const auto all = modes();
  if (all.empty() || !asked_) return Error{message("modes"), message("there are none to keep")};
  const auto path = fileIn("cuts", tool);
  if (!path) return path.error();
  milling::LobeCase cut;
  cut.name = tool.isEmpty() ? "tap test" : tool.toStdString();
  cut.model = cutModel(all, tapMaterial(asked_->material.toStdString()).material, *asked_);
  cut.maxAxialDepth = asked_->deepest;
  if (Status sane = milling::check(cut.model, cut.name); !sane) return sane.error();
  if (Status saved = milling::saveLobeCase(cut, path->toStdString()); !saved) return saved.error();
  if (tool.isEmpty() || !library || !keepLibrary) return *path;
  auto known = library();
  if (!known) return known.error();
  for (ui::ToolEntry& entry : *known) {
    if (entry.name != tool) continue;
    entry.modes = *path;
    entry.history.push_back({QDate::currentDate().toString(Qt::ISODate),
                             QCoreApplication::translate("Tap", "tap test: %1 modes").arg(all.size())});
  }
  if (Status kept = keepLibrary(*known); !kept) return kept.error();
  return *path;
}

}  // namespace stillcut::app
