#include "app/cli/learn/learn_options.h"

#include <filesystem>

#include "app/compose/learn/evidence_log.h"
#include "core/milling/identify/model_files.h"
#include "core/milling/material_table.h"

namespace stillcut::app {
namespace {

using learn::CutEvidence;

Result<learn::MachinePrior> priorOf(const WorkOptions& w, Metres diameter, const std::string& material) {
  if (w.modes.empty()) return learn::priorOfTool(diameter, material);
  std::vector<learn::PriorMode> modes;
  for (const std::string& file : w.modes) {
    const auto read = identify::loadModes(file);
    if (!read) return read.error();
    for (const identify::IdentifiedMode& m : read->modes) {
      modes.push_back(
          {m.mode,
           {m.frequencySd / m.mode.frequency.value, m.dampingSd / m.mode.damping, m.stiffnessSd / m.mode.stiffness}});
    }
  }
  milling::Material force;
  const learn::MachinePrior usual = learn::priorOfTool(diameter, material);
  force.tangential = usual.tangential;
  force.radial = usual.radialRatio * usual.tangential;
  if (!w.coefficients.empty()) {
    const auto read = identify::loadMaterial(w.coefficients);
    if (!read) return read.error();
    force = read->material;
  }
  return w.coupled ? learn::priorOfCoupling(modes, force) : learn::priorOfTap(modes, force);
}

Status readSpeeds(const std::string& text, learn::MapRequest& work) {
  const std::vector<std::string> parts = CLI::detail::split(text, ':');
  const bool read = parts.size() == 2 && CLI::detail::lexical_cast(parts[0], work.lowest.value) &&
                    CLI::detail::lexical_cast(parts[1], work.highest.value) && work.lowest.value > 0.0 &&
                    work.highest > work.lowest && work.highest.value <= 1e6;
  if (read) return Done{};
  return Error{"--speeds", message("'%1' is no range", text), message("FROM:TO in rpm, as 3000:8000")};
}

Status missing(const char* option, Message what) {
  return Error{message("learn"), std::move(what), message("give %1", option)};
}

// What the options leave out is the newest cut's.
Result<learn::MapRequest> workOf(const WorkOptions& w, const std::vector<CutEvidence>& cuts, Metres& diameter) {
  learn::MapRequest work;
  const CutEvidence* newest = cuts.empty() ? nullptr : &cuts.back();
  work.teeth = w.teeth > 0 ? w.teeth : newest != nullptr ? newest->teeth : 0;
  diameter = w.diameterMm > 0.0 ? Metres(1e-3 * w.diameterMm) : newest != nullptr ? newest->diameter : Metres{};
  if (newest != nullptr) work.engagement = newest->engagement;
  if (w.immersion > 0.0) {
    work.engagement.offset.reset();
    work.engagement.radialImmersion = w.immersion;
  }
  if (!w.side.empty()) {
    work.engagement.side = w.side == "up" ? milling::MillingDirection::Up : milling::MillingDirection::Down;
  }
  if (work.teeth == 0) return missing("--teeth", message("the number of teeth is not known")).error();
  if (!(diameter.value > 0.0)) return missing("--diameter", message("the tool's diameter is not known")).error();
  if (newest == nullptr && w.immersion == 0.0) {
    return missing("--immersion", message("the radial immersion is not known")).error();
  }
  work.deepest = w.maxDepthMm > 0.0 ? Metres(1e-3 * w.maxDepthMm) : diameter;
  if (w.speeds.empty()) return missing("--speeds FROM:TO", message("which speeds are possible is not known")).error();
  if (Status read = readSpeeds(w.speeds, work); !read) return read.error();
  return work;
}

}  // namespace

void StoreOptions::add(CLI::App& command) {
  command.add_option("--store", store, "File that keeps the cuts; left out: your own");
}

Result<learn::EvidenceStore> StoreOptions::open() const {
  if (!store.empty()) return learn::EvidenceStore::open(store);
  const std::filesystem::path own = defaultCutStore();
  std::error_code failed;
  std::filesystem::create_directories(own.parent_path(), failed);
  if (failed) return Error{own.parent_path().string(), message("cannot be made"), foreign(failed.message())};
  return learn::EvidenceStore::open(own);
}

void AssemblyOptions::add(CLI::App& command) {
  command.add_option("--machine", machine, "The machine's name")->required();
  command.add_option("--tool", tool, "The tool's name")->required();
  command.add_option("--holder", holder, "Its holder");
  command.add_option("--stickout", stickOutMm, "From the holder's face to the tip [mm]")
      ->check(CLI::Range(0.0, 2000.0));
}

learn::EvidenceFilter AssemblyOptions::filter() const {
  learn::EvidenceFilter f{machine, tool, holder, {}};
  if (stickOutMm > 0.0) f.stickOut = Metres(1e-3 * stickOutMm);
  return f;
}

void WorkOptions::add(CLI::App& command) {
  command.add_option("--teeth", teeth, "Teeth of the tool; left out: the newest cut's")->check(CLI::Range(1, 200));
  command.add_option("--diameter", diameterMm, "Diameter of the tool [mm]; left out: the newest cut's")
      ->check(CLI::PositiveNumber);
  command.add_option("--immersion", immersion, "Width of the cut over the diameter; left out: the newest cut's")
      ->check(CLI::Range(0.001, 1.0));
  command.add_option("--side", side, "up or down; left out: the newest cut's")->check(CLI::IsMember({"up", "down"}));
  command
      .add_option("--material", material,
                  "Material of the part, as `materials` lists it or aluminium, steel, stainless, titanium, cast-iron, "
                  "brass; left out: the newest cut's")
      ->check([](const std::string& name) {
        const auto known = milling::materialNamed(name, "--material");
        return known ? std::string() : text(known.error().what) + " (" + text(known.error().why) + ')';
      });
  command.add_option("--speeds", speeds, "FROM:TO that the machine can run [rpm]");
  command.add_option("--max-depth", maxDepthMm, "Deepest cut looked at [mm]; left out: the diameter")
      ->check(CLI::PositiveNumber);
  command.add_option("--risk", risk, "Probability of chatter that advice may carry")->check(CLI::Range(0.01, 0.5));
  command.add_option("--modes", modes, "Modes that `modal` or `couple` wrote, to start from; once for each axis");
  command.add_flag("--coupled", coupled, "The modes were computed with `couple`: they are less sure");
  command.add_option("--coefficients", coefficients, "Cutting coefficients that `coefficients` wrote");
}

Result<Learned> learnFrom(const StoreOptions& store, const AssemblyOptions& assembly, const WorkOptions& w) {
  const auto opened = store.open();
  if (!opened) return opened.error();
  auto cuts = opened->cuts(assembly.filter());
  if (!cuts) return cuts.error();
  Metres diameter{};
  auto work = workOf(w, *cuts, diameter);
  if (!work) return work.error();
  const std::string material = w.material.empty() && !cuts->empty() ? cuts->back().material : w.material;
  auto prior = priorOf(w, diameter, material);
  if (!prior) return prior.error();
  learn::LobePosterior posterior(*prior, learn::rangeOf(*cuts, work->lowest, work->highest, work->deepest));
  for (const CutEvidence& cut : *cuts) {
    if (Status added = posterior.add(cut); !added) return added.error();
  }
  return Learned{std::move(*cuts), std::move(posterior), *work, prior->origin};
}

}  // namespace stillcut::app
