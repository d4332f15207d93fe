// What `lobes` and `advise` are told about the cut: its file, what replaces parts of it, and its engagement.
// Thread: one; set-up.
#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/compose/cut/cut_file.h"
#include "core/milling/identify/import/import_options.h"
#include "core/milling/stability/limit_band.h"

namespace stillcut::app {

struct CutOptions {
  std::string file, material, engagement;
  std::vector<std::string> modes;
  std::vector<std::string> responses, responseAxes;  // files of frequency responses, and their axes
  std::string crossResponse, crossUnit;
  identify::ImportOptions import;  // of both: units and columns that the files do not say
  bool flip = false;               // the responses point against the force
  double feedMm = 0.0;             // per tooth; 0: the file's
  double offsetMm = 0.0;
  bool offsetGiven = false;
};

// Standard deviations in percent as --spread gives them; none are no doubt at all.
Result<milling::ModelSpread> spreadOf(const std::vector<double>& percent, const milling::Material& material);
CLI::Option* addSpread(CLI::App& command, std::vector<double>& percent, const std::string& what);
void addCutOptions(CLI::App& command, CutOptions& options);
// The cut as file and options make it; warnings of the files go to stderr.
Result<CutFile> readCut(const CutOptions& options);

}  // namespace stillcut::app
