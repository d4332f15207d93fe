// MODES.toml and MATERIAL.toml: identified models as files, with how well they are known.
//
// The tables [[mode]] and [material] are those of every cut file (frequency_hz, damping, stiffness_n_per_m, direction;
// tangential_n_per_m2 ...) and can be pasted into one. [modal_fit] and [force_fit] hold misfit and deviations; they may
// be missing in a file written by hand. Saved whole or not at all.
// Thread: set-up. Errors: one line with file, line and cause.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/milling/identify/coefficients.h"
#include "core/milling/identify/modal_fit.h"

namespace stillcut::identify {

struct ModesFile {
  std::vector<IdentifiedMode> modes;  // at least one
  std::string source;                 // the measurement
  double from = 0.0;                  // band fitted [Hz]
  double to = 0.0;
  double misfit = 0.0;              // relative, complex constants
  double realMisfit = 0.0;          // relative, real modes and residuals
  double writtenMisfit = 0.0;       // relative, the modes as they stand in the file
  std::vector<Residual> residuals;  // one an axis, beside those modes; may be missing
};

struct MaterialFile {
  milling::Material material;        // what cuts are computed with
  CuttingCoefficients coefficients;  // the same with deviations and the axial ones; feeds is 0 when not measured
  std::string source;
};

// The fit as a file's content; `direction` is where the hammer hit in x and y.
ModesFile modesFile(const ModalFit& fit, const std::string& source, std::array<double, 2> direction);
// The modes of both; band and misfits are the wider and the larger ones.
ModesFile joined(ModesFile first, const ModesFile& second);
MaterialFile materialFile(const CuttingCoefficients& coefficients, const std::string& source);

std::string modesFileText(const ModesFile& file);
std::string materialFileText(const MaterialFile& file);
Status saveModes(const ModesFile& file, const std::string& path);
Status saveMaterial(const MaterialFile& file, const std::string& path);

// parse: from a text, `where` names it in errors; load: from a file.
Result<ModesFile> parseModes(std::string_view text, const std::string& where);
Result<MaterialFile> parseMaterial(std::string_view text, const std::string& where);
Result<ModesFile> loadModes(const std::string& path);
Result<MaterialFile> loadMaterial(const std::string& path);

}  // namespace stillcut::identify
