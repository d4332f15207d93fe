#include "app/compose/run_text.h"

#include <sstream>
#include <utility>

#include "core/config/profile.h"
#include "core/config/toml_reader.h"
#include "core/config/toml_writer.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {

namespace {

constexpr std::string_view kMadeFrom = "Made from:";
constexpr std::string_view kComment = "# ";  // as TomlWriter::comment() begins a line

}  // namespace

std::string runText(const RunText& run, std::string_view origin) {
  std::string detectors;
  for (const std::string& id : run.methods.detectors) detectors += (detectors.empty() ? "" : " ") + id;
  config::TomlWriter out;
  out.table("methods");
  out.text("detectors", detectors);
  if (!run.methods.fallback.empty()) out.text("fallback", run.methods.fallback);
  out.text("strategy", run.methods.strategy);
  out.boolean("allow_auto", run.autoAllowed);
  config::writeParameters(out, run.params, pipeline::fullCatalog());
  if (!origin.empty()) {
    out.comment("");
    out.comment(kMadeFrom);
    std::istringstream lines{std::string(origin)};
    for (std::string line; std::getline(lines, line);) out.comment(line);
  }
  return out.content();
}

std::string runOrigin(std::string_view content) {
  std::istringstream lines{std::string(content)};
  std::string origin;
  bool found = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(kComment)) continue;
    line.erase(0, kComment.size());
    if (found) origin += line + '\n';
    found = found || line == kMadeFrom;
  }
  return origin;
}

Result<RunText> parseRunText(std::string_view content, const std::string& name) {
  const config::TomlReader in = config::TomlReader::text(content, name);
  if (const auto unreadable = in.error()) return *unreadable;
  RunText run;
  const config::TomlTable methods = in.root().table("methods");
  std::istringstream detectors(methods.text("detectors"));
  run.methods.detectors.clear();
  for (std::string id; detectors >> id;) run.methods.detectors.push_back(id);
  run.methods.fallback = methods.textOr("fallback", "");
  run.methods.strategy = methods.text("strategy");
  run.autoAllowed = methods.boolean("allow_auto");
  auto params = config::readParameters(in.root().tableOr("parameters"), pipeline::fullCatalog());
  if (const Status finished = in.finish(); !finished) return finished.error();
  if (!params) return params.error();
  run.params = std::move(params).value();
  return run;
}

}  // namespace stillcut::app
