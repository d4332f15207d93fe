// stillcut-cli parameters: every parameter there is, made from the declarations. With --markdown the chapter
// resources/manual/parameters.md, which a test holds against this output.

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/config/nearest_word.h"
#include "core/pipeline/catalog.h"
#include "core/units/number_text.h"

namespace stillcut::app {
namespace {

using config::ParamDecl;
using config::ParamKind;

std::string_view partOf(const ParamDecl& decl) {
  return decl.key.substr(0, decl.key.find('.'));
}

std::string rangeText(const ParamDecl& decl) {
  if (decl.kind == ParamKind::Boolean) return "true, false";
  if (decl.kind == ParamKind::Choice) {
    std::string words;
    for (const std::string_view choice : decl.choices) words.append(words.empty() ? "" : ", ").append(choice);
    return words;
  }
  return config::numberText(decl.lowest) + " to " + config::numberText(decl.highest) +
         (decl.unit.empty() ? "" : " " + std::string(decl.unit));
}

// Declarations that follow each other and mean the same are the cells of a table: one line from the first to the last.
struct Run {
  const ParamDecl* first;
  const ParamDecl* last;
  bool table() const { return first != last; }
  std::string defaults() const { return table() ? "as printed" : config::ParamSet().text(*first); }
};

std::vector<Run> runsOf(const std::vector<const ParamDecl*>& decls) {
  std::vector<Run> runs;
  for (const ParamDecl* decl : decls) {
    const bool goesOn = !runs.empty() && runs.back().last->meaning == decl->meaning;
    if (goesOn) {
      runs.back().last = decl;
    } else {
      runs.push_back({decl, decl});
    }
  }
  return runs;
}

void printPlain(const Run& run) {
  const ParamDecl& decl = *run.first;
  const std::string upTo = run.table() ? " .. " + std::string(run.last->key) : "";
  std::printf("%.*s%s = %s\n    %.*s (%s%s)\n", static_cast<int>(decl.key.size()), decl.key.data(), upTo.c_str(),
              run.defaults().c_str(), static_cast<int>(decl.meaning.size()), decl.meaning.data(),
              rangeText(decl).c_str(), decl.lockedWhileRunning ? "; locked while a cut runs" : "");
}

// A bar would end the cell.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped.append(c == '|' ? "\\|" : std::string(1, c));
  return escaped;
}

void printRow(const Run& run) {
  const ParamDecl& decl = *run.first;
  const std::string upTo = run.table() ? " .. `" + std::string(run.last->key) + "`" : "";
  std::printf("| `%.*s`%s | %s | %s%s | %s |\n", static_cast<int>(decl.key.size()), decl.key.data(), upTo.c_str(),
              run.defaults().c_str(), cell(rangeText(decl)).c_str(), decl.lockedWhileRunning ? ", locked" : "",
              cell(decl.meaning).c_str());
}

void printChapter(const std::vector<const ParamDecl*>& decls) {
  std::puts("# Parameters\n\n*English only. Nur auf Englisch. 仅有英文。*\n");
  std::puts(
      "Every parameter, its default, its range and its meaning. `auto`: the program finds the value itself and says");
  std::puts(
      "what it found. Locked: not while a cut runs. A parameter file or a profile sets them ([files](files.md)).");
  std::puts("This chapter is made by `stillcut-cli parameters --markdown`.");
  std::string_view part;
  for (const Run& run : runsOf(decls)) {
    if (partOf(*run.first) != part) {
      part = partOf(*run.first);
      std::printf("\n## %.*s\n\n| key | default | range | meaning |\n|---|---|---|---|\n",
                  static_cast<int>(part.size()), part.data());
    }
    printRow(run);
  }
}

Status print(const std::string& wanted, bool markdown) {
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  std::vector<const ParamDecl*> chosen;
  std::vector<std::string_view> parts;
  for (const ParamDecl* decl : catalog.all()) {
    if (parts.empty() || parts.back() != partOf(*decl)) parts.push_back(partOf(*decl));
    if (wanted.empty() || partOf(*decl) == wanted) chosen.push_back(decl);
  }
  if (chosen.empty())
    return Error{message("parameters"), message("'%1' has none", wanted), config::didYouMean(wanted, parts)};
  if (markdown) {
    printChapter(chosen);
  } else {
    for (const Run& run : runsOf(chosen)) printPlain(run);
  }
  return Done{};
}

struct Options {
  std::string part;
  bool markdown = false;
};

}  // namespace

void addParameters(CLI::App& app, int& exitCode) {
  CLI::App* command = app.add_subcommand("parameters", "List the parameters of detectors, strategies and the gate");
  auto options = std::make_shared<Options>();
  command->add_option("PART", options->part, "Only those of one part: energy-ratio, stable-pocket, gate ...");
  command->add_flag("--markdown", options->markdown, "As the chapter of the manual");
  command->callback([&exitCode, options] {
    const Status printed = print(options->part, options->markdown);
    exitCode = printed ? kExitDone : fail(printed.error());
  });
}

}  // namespace stillcut::app
