#include <cmath>

#include "core/config/toml_reader.h"
#include "core/config/toml_writer.h"
#include "core/milling/identify/model_files.h"
#include "core/milling/model_toml.h"
#include "core/storage/atomic_file.h"
#include "core/units/number_text.h"

namespace stillcut::identify {
namespace {

using config::numberText;
using config::TomlReader;
using config::TomlTable;

std::string keyValue(std::string_view key, double value) {
  return std::string(key) + " = " + numberText(value) + "\n";
}

void readFit(const TomlTable& t, MaterialFile& file) {
  CuttingCoefficients& k = file.coefficients;
  file.source = t.textOr("source", "");
  k.feeds = t.integerOr("feeds", 0, 0, 1000000);
  k.misfit = t.numberOr("misfit", 0.0, 0.0, 1e9);
  k.axial.value = t.numberOr("axial_n_per_m2", 0.0);
  k.axialEdge.value = t.numberOr("axial_edge_n_per_m", 0.0);
  k.tangential.deviation = t.numberOr("tangential_sd_n_per_m2", 0.0, 0.0);
  k.radial.deviation = t.numberOr("radial_sd_n_per_m2", 0.0, 0.0);
  k.axial.deviation = t.numberOr("axial_sd_n_per_m2", 0.0, 0.0);
  k.tangentialEdge.deviation = t.numberOr("tangential_edge_sd_n_per_m", 0.0, 0.0);
  k.radialEdge.deviation = t.numberOr("radial_edge_sd_n_per_m", 0.0, 0.0);
  k.axialEdge.deviation = t.numberOr("axial_edge_sd_n_per_m", 0.0, 0.0);
  const std::vector<double> signs = t.numbersOr("signs", {1.0, 1.0, 1.0});
  if (signs.size() != 3) {
    t.refuse("signs", message("signs are three numbers, along the feed, across and up"));
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(signs[i]) != 1.0) t.refuse("signs", message("a sign is 1 or -1"));
    k.signs[i] = signs[i] < 0.0 ? -1 : 1;
  }
}

Result<MaterialFile> read(const TomlReader& in) {
  MaterialFile file;
  file.material = milling::readMaterial(in.root().table("material"));
  file.coefficients.tangential.value = file.material.tangential;
  file.coefficients.radial.value = file.material.radial;
  file.coefficients.tangentialEdge.value = file.material.tangentialEdge;
  file.coefficients.radialEdge.value = file.material.radialEdge;
  const TomlTable fit = in.root().tableOr("force_fit");
  if (fit.present()) readFit(fit, file);
  Status done = in.finish();
  if (!done) return done.error();
  return file;
}

}  // namespace

MaterialFile materialFile(const CuttingCoefficients& coefficients, const std::string& source) {
  return {coefficients.material(), coefficients, source};
}

std::string materialFileText(const MaterialFile& file) {
  const CuttingCoefficients& k = file.coefficients;
  std::string text = milling::materialText(file.material);
  config::TomlWriter fit;
  for (const std::string& remark : k.remarks) fit.comment(remark);
  fit.table("force_fit");
  fit.text("source", file.source);
  fit.integer("feeds", k.feeds);
  text += fit.content() + keyValue("misfit", k.misfit) + keyValue("axial_n_per_m2", k.axial.value) +
          keyValue("axial_edge_n_per_m", k.axialEdge.value) +
          keyValue("tangential_sd_n_per_m2", k.tangential.deviation) +
          keyValue("radial_sd_n_per_m2", k.radial.deviation) + keyValue("axial_sd_n_per_m2", k.axial.deviation) +
          keyValue("tangential_edge_sd_n_per_m", k.tangentialEdge.deviation) +
          keyValue("radial_edge_sd_n_per_m", k.radialEdge.deviation) +
          keyValue("axial_edge_sd_n_per_m", k.axialEdge.deviation) + "signs = [";
  for (std::size_t i = 0; i < 3; ++i) text += (i > 0 ? ", " : "") + std::to_string(k.signs[i]);
  return text + "]\n";
}

Status saveMaterial(const MaterialFile& file, const std::string& path) {
  return writeFileAtomically(path, materialFileText(file));
}

Result<MaterialFile> parseMaterial(std::string_view text, const std::string& where) {
  return read(TomlReader::text(text, where));
}

Result<MaterialFile> loadMaterial(const std::string& path) {
  return read(TomlReader::file(path));
}

}  // namespace stillcut::identify
