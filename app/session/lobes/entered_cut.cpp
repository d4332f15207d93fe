#include "app/session/lobes/entered_cut.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/session/tool_cut.h"
#include "core/milling/identify/model_files.h"
#include "core/milling/linear_force.h"
#include "core/milling/material_table.h"

namespace stillcut::app {
namespace {

const char* const kWhere = "entered cut";
constexpr double kSameCoefficient = 1e-6;  // relative: what a field with few digits gives back was not changed

std::vector<ui::EnteredMode> shown(const std::vector<milling::Mode>& modes) {
  std::vector<ui::EnteredMode> out;
  out.reserve(modes.size());
  for (const milling::Mode& m : modes) out.push_back({m.frequency, m.damping, m.stiffness, m.direction});
  return out;
}

bool same(double a, double b) {
  return std::abs(a - b) <= kSameCoefficient * std::max(std::abs(a), std::abs(b));
}

// As the file has it where nobody changed it: the page shows neither its motion along z nor what the speed makes of it.
milling::Mode modeOf(const ui::EnteredMode& entered, const std::vector<milling::Mode>& ofFile) {
  for (const milling::Mode& m : ofFile) {
    const bool unchanged = same(m.frequency.value, entered.frequency.value) && same(m.damping, entered.damping) &&
                           same(m.stiffness, entered.stiffness) && m.direction == entered.direction;
    if (unchanged) return m;
  }
  return {entered.frequency, entered.damping, entered.stiffness, entered.direction};
}

// The file's cut where there is one, and over it what stands in the fields.
Result<milling::CutModel> modelOf(const ui::EnteredCut& cut) {
  milling::CutModel model;
  const std::string file = cut.file.toStdString();
  if (!file.empty() && !holdsModesAlone(file)) {
    auto loaded = loadCutFile(file);
    if (!loaded) return loaded.error();
    model = std::move(loaded->model);
  }
  const std::vector<milling::Mode> ofFile = std::exchange(model.modes, {});
  for (const ui::EnteredMode& m : cut.modes) model.modes.push_back(modeOf(m, ofFile));
  if (model.modes.empty()) {
    return Error{message("modes"), message("none is entered"),
                 message("type frequency, damping and stiffness, or open a file with modes")};
  }
  // Another number of teeth has another pitch, which nobody has told.
  if (model.tool.teeth != cut.teeth) model.tool = milling::Tool{};
  if (!same(model.tool.helix, cut.helix)) model.tool.toothHelix.clear();
  model.tool.teeth = cut.teeth;
  model.tool.diameter = cut.diameter;
  model.tool.helix = cut.helix;
  if (!cut.material.isEmpty()) {
    const auto material = milling::materialNamed(cut.material.toStdString(), kWhere);
    if (!material) return material.error();
    model.material = *material;
  } else if (cut.tangential > 0.0 &&
             !(same(cut.tangential, model.material.tangential) && same(cut.radial, model.material.radial))) {
    model.material = milling::Material{};
    model.material.tangential = cut.tangential;
    model.material.radial = cut.radial;
  }
  const bool otherWidth = !same(model.engagement.radialImmersion, cut.immersion);
  if (otherWidth) model.engagement.offset.reset();
  model.engagement.radialImmersion = cut.immersion;
  if (!model.engagement.offset)
    model.engagement.side = cut.upMilling ? milling::MillingDirection::Up : milling::MillingDirection::Down;
  if (Status sane = milling::check(model, kWhere); !sane) return sane.error();
  milling::lineariseForLobes(model, cut.feedPerTooth);
  return model;
}

ui::LobeFrame frameOf(const ui::EnteredCut& cut, const milling::CutModel& model) {
  ui::LobeFrame frame = usualFrame(model);
  frame.name = cut.file.isEmpty() ? QString() : QFileInfo(cut.file).completeBaseName();
  if (cut.highest > cut.lowest) {
    frame.lowest = frame.reachLow = cut.lowest;
    frame.highest = frame.reachHigh = cut.highest;
  }
  frame.depth = cut.depth;
  frame.maxAxialDepth = std::max(cut.deepest, cut.depth * 1.25);
  frame.feedPerTooth = cut.feedPerTooth;
  return frame;
}

}  // namespace

EnteredCutLobes::EnteredCutLobes() {
  for (const milling::TableMaterial& row : milling::materialTable()) {
    // The coefficients of a power law have another unit, and another value at every chip.
    const bool straight = row.material.exponent == 1.0;
    materials_.push_back({QString::fromStdString(row.name), QString::fromStdString(row.what),
                          straight ? row.material.tangential : 0.0, straight ? row.material.radial : 0.0});
  }
}

Result<ui::EnteredCut> EnteredCutLobes::read(const ui::EnteredCut& cut, const QString& file) const {
  ui::EnteredCut out = cut;
  const std::string path = file.toStdString();
  if (holdsModesAlone(path)) {
    const auto modes = identify::loadModes(path);
    if (!modes) return modes.error();
    out.modes.clear();
    for (const identify::IdentifiedMode& m : modes->modes) out.modes.push_back(shown({m.mode}).front());
    return out;
  }
  const auto loaded = loadCutFile(path);
  if (!loaded) return loaded.error();
  const milling::CutModel& model = loaded->model;
  if (model.turning) {
    return Error{path, message("is a turning cut, and this page enters milling cuts"),
                 message("stillcut-cli lobes takes it")};
  }
  out.file = file;
  out.modes = shown(model.modes);
  out.teeth = model.tool.teeth;
  out.diameter = model.tool.diameter;
  out.helix = model.tool.helix;
  out.material.clear();
  out.tangential = model.material.tangential;
  out.radial = model.material.radial;
  out.immersion = model.engagement.radialImmersion;
  out.upMilling = model.engagement.side == milling::MillingDirection::Up;
  out.feedPerTooth = loaded->feedPerTooth;
  if (loaded->depth.value > 0.0) out.depth = loaded->depth;
  out.deepest = loaded->maxAxialDepth;
  out.lowest = loaded->lowest;
  out.highest = loaded->highest;
  return out;
}

Status EnteredCutLobes::enter(const ui::EnteredCut& cut) {
  if (!(cut.depth.value > 0.0)) return Error{message("depth of cut"), message("must be above zero")};
  auto model = modelOf(cut);
  if (!model) return model.error();
  LobeWorker::Cut computed;
  computed.frame = frameOf(cut, *model);
  computed.model = std::move(*model);
  lobes_ = std::make_unique<LobeWorker>(std::move(computed));
  return Done{};
}

}  // namespace stillcut::app
