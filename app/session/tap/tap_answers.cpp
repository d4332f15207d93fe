#include <QCoreApplication>
#include <QDate>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/session/tap/tap_bench.h"
#include "app/session/tap/tap_materials.h"
#include "app/session/tool_cut.h"
#include "core/milling/identify/model_files.h"
#include "core/milling/stability/lobe_case.h"
#include "ui/base/format.h"
#include "ui/base/say.h"

// What a tap test gives: files in the place of a device, modes, lobes, and what is kept of them.
namespace stillcut::app {

// What the second axis needs is opened beside what the first one has; a file that cannot be read changes nothing.
void TapBench::openFiles(const QStringList& paths, int axis) {
  if (paths.isEmpty()) return;
  stopListening();
  wanted_ = paths;
  wantedAxis_ = axis;
  fileReading_ = {};
  readFiles(paths, {axis, {}, {}});
}

void TapBench::answer(const ui::TapAnswers& answers) {
  if (wanted_.isEmpty()) return;
  fileReading_.answers = answers;
  readFiles(wanted_, {wantedAxis_, {}, answers});
}

void TapBench::readFiles(const QStringList& paths, const TapReading& reading) {
  std::vector<std::string> names;
  for (const QString& path : paths) names.push_back(path.toStdString());
  fileReading_.runs = true;
  fileReading_.problem.clear();
  reading_.start(
      ui::TaskState::What::Reading, paths.front(),
      [this, names, paths, reading](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
        auto read = fromFiles(names, reading);
        if (!read) return read.error();
        return BackgroundTask::Apply(
            [this, paths, reading, read = std::move(*read)] { takeFiles(paths, reading, read); });
      },
      [this, reading](const Error& error) { notTaken(error, reading); });
}

void TapBench::takeFiles(const QStringList& paths, const TapReading& reading, TapFiles read) {
  fileReading_.runs = false;
  fileReading_.problem.clear();
  files_ = paths;
  for (std::size_t a = 0; a < read.axes.size(); ++a) {
    if (!read.there[a]) continue;
    Axis& axis = axes_[a];
    axis.fitting.leave();
    axis.test.reset();
    axis.files = paths;
    axis.reading = reading;
    read.axes[a].shown.remarks = read.remarks + read.axes[a].shown.remarks;
    take(axis, std::move(read.axes[a]));
  }
}

// An axis that has nothing shows why; what another has stays.
void TapBench::notTaken(const Error& error, const TapReading& reading) {
  fileReading_.runs = false;
  for (const ui::TapQuestion question : questionsOf(error)) {
    auto& known = fileReading_.questions;
    if (std::ranges::find(known, question) == known.end()) known.push_back(question);
  }
  fileReading_.flipAsked = fileReading_.flipAsked || asksToFlip(error);
  const bool asks = !questionsOf(error).empty() || asksToFlip(error);
  const Error plain{error.where, error.what};
  const QString rest = QCoreApplication::translate("Tap", "Say it below and touch READ.");
  fileReading_.problem = asks ? ui::sayError(plain) + QStringLiteral(". ") + rest : ui::sayError(error);
  ui::TapResponse& shown = axisOf(reading.axis).known.shown;
  if (shown.state != ui::TapResponse::State::None && shown.state != ui::TapResponse::State::Failed) return;
  shown.state = ui::TapResponse::State::Failed;
  shown.problem = fileReading_.problem;
  changed(shown);
}

// One axis of files again, with other hits left out. The other one keeps its own.
void TapBench::readHitsAnew(int axis) {
  Axis& one = axisOf(axis);
  std::vector<std::string> names;
  for (const QString& path : one.files) names.push_back(path.toStdString());
  one.known.shown.state = ui::TapResponse::State::Working;
  changed(one.known.shown);
  const std::size_t at = axis == 1 ? 1 : 0;
  one.fitting.start(
      ui::TaskState::What::Reading, one.files.front(),
      [this, names, at, reading = one.reading](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
        auto read = fromFiles(names, reading);
        TapAxis found;
        if (read) {
          found = std::move(read->axes[at]);
          found.shown.remarks = read->remarks + found.shown.remarks;
        } else {
          found.shown.state = ui::TapResponse::State::Failed;
          found.shown.problem = ui::sayError(read.error());
        }
        return BackgroundTask::Apply([this, at, found = std::move(found)] { take(axes_[at], found); });
      });
}

QStringList TapBench::sources() const {
  QStringList all;
  for (const Axis& axis : axes_) {
    for (const QString& file : axis.files) {
      if (!all.contains(file)) all << file;
    }
  }
  return all;
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

// Without it the limits would be too high, and a hint beside the depth would not be read.
double TapBench::missingMode() const {
  for (const Axis& axis : axes_) {
    const bool known = axis.known.shown.state == ui::TapResponse::State::Done;
    if (known && axis.known.fit.missing > 0.0) return axis.known.fit.missing;
  }
  return 0.0;
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
  if (const double missing = missingMode(); missing > 0.0) {
    lobes_.state = ui::TapLobes::State::Failed;
    lobes_.problem =
        QCoreApplication::translate(
            "Tap",
            "The resonance at %1 Hz is deeper than every mode found, and too noisy to be fitted: a depth would "
            "be too large. Hit harder, average more hits, or take a harder tip.")
            .arg(ui::number(missing));
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

QString TapBench::keptAlready(ui::TapKept what, const QString& name) const {
  if (folder_.isEmpty()) return {};
  const QDir place(
      QDir(folder_).filePath(what == ui::TapKept::Modes ? QStringLiteral("modes") : QStringLiteral("cuts")));
  const QString path = place.absoluteFilePath(fileNameOf(name));
  return QFileInfo::exists(path) ? path : QString();
}

Result<QString> TapBench::saveModes(const QString& name) {
  identify::ModesFile file;
  file.modes = modes();
  if (file.modes.empty()) return Error{message("modes"), message("there are none to keep")};
  const QStringList from = sources();
  file.source = from.isEmpty() ? "tap test" : from.join(QStringLiteral(", ")).toStdString();
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
