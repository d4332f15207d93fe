#include "core/pipeline/catalog.h"

#include "core/active/active_params.h"
#include "core/control/registry.h"
#include "core/detect/registry.h"
#include "core/safety/gate_limits.h"
#include "core/sensing/conditioner.h"
#include "core/session/record_params.h"

namespace stillcut::pipeline {

config::ParamCatalog fullCatalog() {
  config::ParamCatalog catalog;
  catalog.add(detect::conditionerParams());
  for (const auto& entry : detect::detectorTable()) catalog.add(entry.params());
  for (const auto& entry : control::strategyTable()) catalog.add(entry.params);
  catalog.add(safety::gateParams());
  catalog.add(record::recordParams());
  catalog.add(active::activeParams());
  return catalog;
}

}  // namespace stillcut::pipeline
