// The shared reference cases: a cut, and its limits as two independent programs computed them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/milling/cut_model.h"

namespace stillcut::milling {

struct ReferenceRow {
  int crossing = 0;
  double depth = 0.0;  // [m]
  int before = 0, after = 0;
  std::string kind;
  double angle = 0.0;     // [rad]
  double sdmDepth = 0.0;  // first-order semi-discretization, k = 40; 0: not given [m]
};

struct ReferenceCase {
  CutModel model;
  double maxAxialDepth = 0.0;                        // [m]
  std::map<double, std::vector<ReferenceRow>> rows;  // by speed [rpm]; empty: no limit below maxAxialDepth
  std::map<double, double> zoa;                      // limit by speed [m]
};

inline const char* const kReferenceNames[] = {"ins1dof_aD1_slot", "ins1dof_aD0.1_down", "ins2dof_aD0.5_up",
                                              "lk_4mode_N2_half_down"};

std::filesystem::path referenceFile(const std::string& name);  // name with its suffix
bool referencePresent();
ReferenceCase loadReference(const std::string& name);

// One mode along x, cutting data of the shared cases, slot: the textbook cut of the semi-discretization papers.
CutModel textbookSlot();
// The same with an equal mode along y and half immersion, up milling.
CutModel textbookHalf();

}  // namespace stillcut::milling

#define STILLCUT_NEEDS_REFERENCE() \
  if (!stillcut::milling::referencePresent()) GTEST_SKIP() << "reference lobes are not here: " << STILLCUT_SHARED_DIR
