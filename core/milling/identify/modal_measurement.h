// From the files of a tap test to modes in one call: import, hammer analysis where the files hold hammer records, fit;
// for each axis by itself.
// Thread: any, set-up path.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/identify/hammer.h"
#include "core/milling/identify/import/measurement_import.h"
#include "core/milling/identify/modal_fit.h"

namespace stillcut::identify {

struct ModalRequest {
  ImportOptions import;  // as many axes as files: one each, in their order
  HammerOptions hammer;  // its flipResponse also inverts an imported frequency response
  ModalOptions fit;
  bool takesZ = false;                       // a response along z too: no lobes can be computed from it
  std::map<Axis, std::vector<int>> without;  // hits to leave out along an axis, instead of those of `hammer`
};

// What was found along one axis.
struct AxisModes {
  Axis axis = Axis::Unknown;  // neither the files nor the request said
  Frf frf;                    // as analysed, with its coherence
  ModalFit fit;
  bool fromHammer = false;
  std::vector<Hit> hits;             // of the hammer records
  std::vector<std::string> records;  // their files, by Hit::record
  std::vector<Message> remarks;      // of analysis and fit, one line each
};

struct ModalAnswer {
  std::vector<AxisModes> axes;   // rising, at least one
  std::vector<Message> remarks;  // of reading the files
};

// Hammer records of one axis are averaged over all files. Error: one line with file and cause.
Result<ModalAnswer> identifyModes(const std::vector<std::string>& paths, const ModalRequest& request);

// The frequency response along each axis, without a fit: for what is made of it elsewhere.
Result<ModalAnswer> measureResponses(const std::vector<std::string>& paths, const ModalRequest& request);

// Settles units that no file said by what is possible (response_unit.h), and remarks on it; else asks for them.
Status findUnits(ModalAnswer& answer, const ModalOptions& options);

// Modes have a direction in the plane of the cut: there is none for z.
Error measuredAlongZ(const std::string& source);

}  // namespace stillcut::identify
