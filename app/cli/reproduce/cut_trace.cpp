#include "app/cli/reproduce/cut_trace.h"

#include <algorithm>
#include <cmath>

#include "app/compose/scenario_rig.h"
#include "core/config/profile.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {
namespace {

class Tracer {
 public:
  Tracer(CutTrace& trace, const Rig& rig, const milling::SimulatedCut& plant)
      : trace_(trace), rig_(rig), plant_(plant) {
    trace.rate = rig.setup().rate;
    trace.teeth = std::max(1, rig.setup().teeth);
    trace.channels = rig.setup().channels;
    trace.samples.resize(trace.channels.size());
    for (const auto& detector : rig.chain().parts().detectors) trace.detectors.push_back(detector->describe());
  }

  void observe(const StepInput& input, const StepOutput& output) {
    const SampleBlock& block = input.block;
    for (std::size_t c = 0; c < trace_.samples.size(); ++c) {
      const double scale = trace_.channels[c].scale;
      for (const float v : block.channel(static_cast<int>(c)))
        trace_.samples[c].push_back(scale * static_cast<double>(v));
    }
    if (output.hasCommand) factor_ = output.command.kind == CommandKind::Set ? output.command.speed.value : 1.0;
    const MachineState& m = input.machine;
    if (plant_.cutting()) path_ += 1e3 * m.actualFeed.value * block.frames / block.rate.value;
    TraceRow row;
    row.t = plant_.time().value;
    row.path_mm = path_;
    row.depth_mm = 1e3 * plant_.depth().value;
    row.speed_rpm = m.actualSpeed.value;
    row.feed_mm_min = toMmPerMin(m.actualFeed);
    row.asked_rpm = factor_ * m.programmedSpeed.value;
    row.vibration = plant_.truth().vibration();
    row.chatterRatio = plant_.truth().chatterRatio();
    row.cutting = plant_.cutting();
    row.verdicts.assign(output.verdicts.begin(), output.verdicts.begin() + static_cast<long>(trace_.detectors.size()));
    trace_.rows.push_back(std::move(row));
    trace_.history.observe(input, output, plant_);
  }

  void finish() {
    trace_.history.finish(plant_);
    trace_.chatterHz = plant_.truth().chatterFrequency().value;
    trace_.onset20_s = plant_.truth().onset().at20;
    RuleTables rules;
    if (rig_.chain().parts().strategy->readRules(rules)) trace_.rules = rules;
  }

 private:
  CutTrace& trace_;
  const Rig& rig_;
  const milling::SimulatedCut& plant_;
  double path_ = 0.0, factor_ = 1.0;
};

}  // namespace

int CutTrace::detector(std::string_view id) const {
  const auto found = std::find_if(detectors.begin(), detectors.end(), [id](const auto& d) { return d.id == id; });
  return found == detectors.end() ? -1 : static_cast<int>(found - detectors.begin());
}

int CutTrace::indicator(int which, std::string_view id) const {
  const auto names = detectors[static_cast<std::size_t>(which)].indicators;
  const auto found = std::find(names.begin(), names.end(), id);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

const TraceRow* CutTrace::firstAlarm() const {
  const auto found = std::find_if(rows.begin(), rows.end(), [](const TraceRow& r) { return r.verdicts[0].alarming(); });
  return found == rows.end() ? nullptr : &*found;
}

Result<CutTrace> traceCut(milling::Scenario scenario, const TraceRequest& request) {
  scenario.grantsAuto = true;
  ScenarioOptions options;
  options.methods.strategy = request.strategy;
  if (!request.detectors.empty()) options.methods.detectors = request.detectors;
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  for (const std::string& setting : request.settings) {
    if (const Status set = config::applySetting(options.params, catalog, setting); !set) return set.error();
  }
  auto built = buildScenarioRig(scenario, options);
  if (!built) return built.error();
  Rig& rig = *built->rig;
  CutTrace trace;
  trace.name = request.strategy == "monitor" ? "left alone" : request.strategy;
  Tracer tracer(trace, rig, built->source->plant());
  rig.send({OperatorAction::GrantBySimulation, Authority::Auto});
  rig.runToEnd([&](const StepInput& input, const StepOutput& output) { tracer.observe(input, output); });
  tracer.finish();
  return trace;
}

}  // namespace stillcut::app
