// Writes the words that core declares once and the screens translate into a file where lupdate finds them:
//   core_texts FILE
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "app/io/find_machines.h"
#include "app/session/machine_setup.h"
#include "app/session/tap/tap_materials.h"
#include "core/cnc/link_trial.h"
#include "core/cnc/registry.h"
#include "core/control/registry.h"
#include "core/daq/axis_knock.h"
#include "core/daq/registry.h"
#include "core/detect/registry.h"
#include "core/pipeline/catalog.h"
#include "core/sensing/conditioner.h"
#include "tests/support/reason_codes.h"

namespace {

using namespace stillcut;

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

class Lines {
 public:
  void add(const std::string& context, std::string_view text) {
    if (text.empty() || !seen_.insert(context + '\n' + std::string(text)).second) return;
    out_ << "    QT_TRANSLATE_NOOP(\"" << context << "\", " << quoted(text) << "),\n";
  }
  std::string text() const { return out_.str(); }

 private:
  std::set<std::string> seen_;
  std::ostringstream out_;
};

// Names and choices of what a device or a link asks for; some questions follow from the answer to another.
using Settings = std::map<std::string, std::string>;
void addSettings(Lines& lines, const std::function<std::vector<config::SettingDecl>(const Settings&)>& ask) {
  const auto add = [&](const std::vector<config::SettingDecl>& asked) {
    for (const config::SettingDecl& setting : asked) {
      lines.add("Core", config::settingName(setting.key).words);
      for (const std::string& word : setting.words) lines.add("Core", word);
    }
  };
  const auto first = ask({});
  add(first);
  for (const config::SettingDecl& setting : first) {
    if (setting.kind == config::SettingDecl::Kind::Flag) add(ask({{setting.key, "true"}}));
    for (const std::string& word : setting.words) add(ask({{setting.key, word}}));
  }
}

void addPart(Lines& lines, const std::string& link, const std::string& source) {
  addSettings(lines, [&](const Settings& given) {
    config::Profile profile;
    profile.link = {link, given};
    profile.source = {source, given};
    profile.cut.channels.resize(1);
    const app::MachineSetup controller;
    return link.empty() ? controller.sourceSettings(profile) : controller.linkSettings(profile);
  });
}

void addOwnValues(Lines& lines, detect::AutoValueTable table) {
  for (const detect::AutoValueDecl& decl : table) {
    lines.add("Core", decl.label);
    for (const std::string_view why : decl.whys) lines.add("Core", why);
  }
}

std::string fileText() {
  Lines lines;
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  for (const config::ParamDecl* decl : catalog.all()) {
    lines.add("Core", decl->label);
    lines.add("Core", decl->meaning);
    for (const std::string_view choice : decl->choices) lines.add("Core", choice);
  }
  for (const auto& entry : detect::detectorTable())
    lines.add("Core", detect::makeDetector(entry.id).value()->describe().label);
  addOwnValues(lines, detect::Conditioner::autoValues());
  for (const auto& entry : detect::detectorTable()) addOwnValues(lines, entry.make()->autoValues());
  for (const auto& entry : control::strategyTable())
    lines.add("Core", control::makeStrategy(entry.id).value()->describe().label);
  for (const auto& entry : cnc::linkTable()) lines.add("Core", entry.description);
  for (const auto& entry : daq::sourceTable()) lines.add("Core", entry.description);
  for (const char* const step : cnc::LinkTrial::kNames) lines.add("Core", step);
  for (const char* const word : cnc::LinkTrial::words()) lines.add("Core", word);
  for (const char* const word : daq::knockWords()) lines.add("Core", word);
  for (const auto& material : app::tapMaterials()) lines.add("Core", material.name);
  for (const std::string_view what : app::foundSentences()) lines.add("Core", what);
  for (const auto& entry : cnc::linkTable()) addPart(lines, std::string(entry.id), {});
  for (const auto& entry : daq::sourceTable()) addPart(lines, {}, std::string(entry.id));
  for (int k = 0; k <= static_cast<int>(SensorQuantity::SpindleSpeed); ++k) {
    lines.add("Core", name(static_cast<SensorQuantity>(k)));
  }
  for (int code = 1; test::isReason(code); ++code) {
    lines.add("Reason", pattern(static_cast<ReasonCode>(code)));
  }
  return "// Made by core_texts (tests/ui) for lupdate; not compiled.\n// clang-format off\nconst char* const "
         "kCoreTexts[] = {\n" +
         lines.text() + "};\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  return (std::ofstream(argv[1]) << fileText()).good() ? 0 : 2;
}
