// From a tap test's file to modes in one call: import, hammer analysis where the file holds a hammer record, fit.
// Thread: any, set-up path.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/identify/hammer.h"
#include "core/milling/identify/measurement_import.h"
#include "core/milling/identify/modal_fit.h"

namespace stillcut::identify {

struct ModalRequest {
  ImportOptions import;
  HammerOptions hammer;  // its flipResponse also turns an imported frequency response
  ModalOptions fit;
};

struct ModalAnswer {
  ModalFit fit;
  bool fromHammer = false;
  std::vector<Hit> hits;             // of a hammer record
  std::vector<std::string> remarks;  // of all three steps, one line each
};

Result<ModalAnswer> identifyModes(const std::string& path, const ModalRequest& request);

}  // namespace stillcut::identify
