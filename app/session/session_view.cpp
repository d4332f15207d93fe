#include "app/session/session_view.h"

#include <cmath>
#include <utility>

#include "core/detect/caliskan/energy_ratio.h"
#include "core/detect/xu/coherence.h"
#include "core/sensing/conditioner.h"

namespace stillcut::app {

QString viewText(std::string_view s) {
  return QString::fromUtf8(s.data(), static_cast<qsizetype>(s.size()));
}

ui::SessionInfo sessionInfo(const Rig& rig) {
  ui::SessionInfo info;
  info.setup = rig.setup();
  for (const auto& detector : rig.chain().parts().detectors) {
    const detect::DetectorInfo d = detector->describe();
    ui::DetectorLabel shown{viewText(d.id), viewText(d.label), {}};
    for (std::string_view indicator : d.indicators) shown.indicators.push_back(viewText(indicator));
    info.detectors.push_back(std::move(shown));
  }
  if (rig.hasLink()) {
    const cnc::LinkInfo link = rig.linkInfo();
    info.linkLabel = viewText(link.label);
    info.simulatedMachine = link.simulated;
    info.machineWatchdog = link.machineWatchdog;
    info.kept = link.kept;
  }
  const config::ParamSet& params = rig.params();
  info.limits.energyRatio = params.real(detect::kErChatter);
  info.limits.coherence = params.real(detect::kCohGammaRef);
  if (!params.isAutomatic(detect::kVibrationLimit)) info.limits.vibration = params.real(detect::kVibrationLimit);
  const CutSetup& cut = info.setup;
  if (cut.teeth > 0 && cut.nominalSpeed.value > 0.0) {
    info.feedPerTooth = Metres(cut.nominalFeed.value / toothPassing(cut.nominalSpeed, cut.teeth).value);
  }
  return info;
}

void takeLimit(ui::LimitMarks& limits, const config::ParamDecl& decl, double value) {
  if (decl.key == detect::kErChatter.key) limits.energyRatio = value;
  if (decl.key == detect::kCohGammaRef.key) limits.coherence = value;
}

void takeOwnLimits(ui::LimitMarks& limits, const Rig& rig) {
  for (const auto& detector : rig.chain().parts().detectors) {
    const detect::AutoValueTable table = detector->autoValues();
    for (std::size_t i = 0; i < table.size(); ++i) {
      if (table[i].key != "energy-ratio.full") continue;
      const double own = detector->own(i).value;
      if (std::isfinite(own) && own > 0.0) limits.energyRatio = own;
    }
  }
}

}  // namespace stillcut::app
