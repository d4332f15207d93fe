#include <algorithm>
#include <cmath>
#include <functional>

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

std::string rounded(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string percent(double ratio) {
  return rounded(100.0 * ratio, 3) + " %";
}

void describe(config::TomlWriter& out, const IdentifiedMode& m) {
  out.comment(rounded(m.mode.frequency.value, 6) + " +- " + rounded(m.frequencySd, 2) + " Hz, damping " +
              rounded(m.mode.damping, 3) + " +- " + rounded(m.dampingSd, 2) + ", stiffness " +
              rounded(m.mode.stiffness, 3) + " +- " + rounded(m.stiffnessSd, 2) + " N/m, " + percent(m.share) +
              " of the response");
  if (!m.caveat.empty()) out.comment("doubt: " + m.caveat);
}

using Member = std::function<double&(IdentifiedMode&)>;

// Columns of [modal_fit], one number per mode.
struct Column {
  std::string_view key;
  Member member;
};

const std::vector<Column>& columns() {
  static const std::vector<Column> kColumns = {
      {"frequency_sd_hz", [](IdentifiedMode& m) -> double& { return m.frequencySd; }},
      {"damping_sd", [](IdentifiedMode& m) -> double& { return m.dampingSd; }},
      {"stiffness_sd_n_per_m", [](IdentifiedMode& m) -> double& { return m.stiffnessSd; }},
      {"share", [](IdentifiedMode& m) -> double& { return m.share; }},
      {"stability", [](IdentifiedMode& m) -> double& { return m.stability; }},
      {"phase_rad", [](IdentifiedMode& m) -> double& { return m.phase; }},
  };
  return kColumns;
}

// One row an axis: direction, upper, lower (real and imaginary part), the frequency of the lower one.
constexpr std::size_t kResidualNumbers = 7;

void readResiduals(const TomlTable& t, ModesFile& file) {
  if (!t.has("residuals")) return;
  const std::vector<double> v = t.numbers("residuals");
  if (v.empty() || v.size() % kResidualNumbers != 0) {
    t.refuse("residuals", message("needs %1 numbers an axis", kResidualNumbers));
    return;
  }
  for (std::size_t i = 0; i < v.size(); i += kResidualNumbers) {
    file.residuals.push_back({{v[i + 2], v[i + 3]}, {v[i + 4], v[i + 5]}, v[i + 6], {v[i], v[i + 1]}});
  }
}

std::string residualsText(const std::vector<Residual>& residuals) {
  if (residuals.empty()) return {};
  config::TomlWriter notes;
  notes.comment("an axis: x, y of its direction; of modes above the band re, im; of those below re, im at Hz [m/N]");
  std::string text = notes.content() + "residuals = [";
  bool first = true;
  for (const Residual& r : residuals) {
    for (const double v :
         {r.direction[0], r.direction[1], r.upper.real(), r.upper.imag(), r.lower.real(), r.lower.imag(), r.at}) {
      text += (first ? "" : ", ") + numberText(v);
      first = false;
    }
  }
  return text + "]\n";
}

void readFit(const TomlTable& t, ModesFile& file) {
  file.source = t.textOr("source", "");
  file.from = t.numberOr("from_hz", 0.0, 0.0, 1e9);
  file.to = t.numberOr("to_hz", 0.0, 0.0, 1e9);
  file.misfit = t.numberOr("misfit", 0.0, 0.0, 1e9);
  file.realMisfit = t.numberOr("real_misfit", 0.0, 0.0, 1e9);
  file.writtenMisfit = t.numberOr("written_misfit", 0.0, 0.0, 1e9);
  for (const Column& column : columns()) {
    if (!t.has(column.key)) continue;
    const std::vector<double> values = t.numbers(column.key);
    if (values.size() != file.modes.size()) {
      t.refuse(column.key, message("needs one number per mode, %1", std::to_string(file.modes.size())));
      continue;
    }
    for (std::size_t i = 0; i < values.size(); ++i) column.member(file.modes[i]) = values[i];
  }
  readResiduals(t, file);
  if (!t.has("doubt")) return;
  const std::vector<std::string> doubts = t.texts("doubt");
  if (doubts.size() != file.modes.size()) {
    t.refuse("doubt", message("needs one text per mode, %1", std::to_string(file.modes.size())));
    return;
  }
  for (std::size_t i = 0; i < doubts.size(); ++i) file.modes[i].caveat = doubts[i];
}

Result<ModesFile> read(const TomlReader& in) {
  ModesFile file;
  for (const milling::Mode& mode : milling::readModes(in.root())) {
    file.modes.emplace_back();
    file.modes.back().mode = mode;
  }
  const TomlTable fit = in.root().tableOr("modal_fit");
  if (fit.present()) readFit(fit, file);
  Status done = in.finish();
  if (!done) return done.error();
  if (file.modes.empty()) return Error{in.root().place(), message("holds no [[mode]]")};
  return file;
}

}  // namespace

ModesFile modesFile(const ModalFit& fit, const std::string& source, std::array<double, 2> direction) {
  ModesFile file{fit.modes, source, fit.from, fit.to, fit.misfit, fit.realMisfit, fit.writtenMisfit, {}};
  if (fit.residual.at > 0.0) file.residuals = {fit.residual};
  for (Residual& residual : file.residuals) residual.direction = direction;
  for (IdentifiedMode& m : file.modes) m.mode.direction = direction;
  return file;
}

ModesFile joined(ModesFile first, const ModesFile& second) {
  first.modes.insert(first.modes.end(), second.modes.begin(), second.modes.end());
  first.residuals.insert(first.residuals.end(), second.residuals.begin(), second.residuals.end());
  if (first.source != second.source) first.source += ", " + second.source;
  first.from = std::min(first.from, second.from);
  first.to = std::max(first.to, second.to);
  first.misfit = std::max(first.misfit, second.misfit);
  first.realMisfit = std::max(first.realMisfit, second.realMisfit);
  first.writtenMisfit = std::max(first.writtenMisfit, second.writtenMisfit);
  return first;
}

std::string modesFileText(const ModesFile& file) {
  std::string text;
  for (const IdentifiedMode& m : file.modes) {
    config::TomlWriter notes;
    describe(notes, m);
    text += notes.content() + milling::modesText({m.mode});
  }
  config::TomlWriter fit;
  fit.comment("misfit of these modes: " + percent(file.writtenMisfit) + " of the response; with residuals " +
              percent(file.realMisfit) + ", with complex shapes too " + percent(file.misfit));
  fit.table("modal_fit");
  fit.text("source", file.source);
  fit.number("from_hz", file.from);
  fit.number("to_hz", file.to);
  fit.number("misfit", file.misfit);
  fit.number("real_misfit", file.realMisfit);
  fit.number("written_misfit", file.writtenMisfit);
  text += fit.content();
  std::vector<IdentifiedMode> modes = file.modes;
  for (const Column& column : columns()) {
    text += std::string(column.key) + " = [";
    for (std::size_t i = 0; i < modes.size(); ++i) text += (i > 0 ? ", " : "") + numberText(column.member(modes[i]));
    text += "]\n";
  }
  text += residualsText(file.residuals);
  // Caveats are our own sentences: nothing in them needs escaping.
  text += "doubt = [";
  for (std::size_t i = 0; i < modes.size(); ++i) text += (i > 0 ? ", \"" : "\"") + modes[i].caveat + "\"";
  return text + "]\n";
}

Status saveModes(const ModesFile& file, const std::string& path) {
  return writeFileAtomically(path, modesFileText(file));
}

Result<ModesFile> parseModes(std::string_view text, const std::string& where) {
  return read(TomlReader::text(text, where));
}

Result<ModesFile> loadModes(const std::string& path) {
  return read(TomlReader::file(path));
}

}  // namespace stillcut::identify
