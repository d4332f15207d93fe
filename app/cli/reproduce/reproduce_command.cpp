// stillcut-cli reproduce FIGURE...|all --out DIR [--json], or --list: figures of the five papers from our simulation,
// as SVG and CSV, with the paper's numbers beside ours.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/json_line.h"
#include "app/cli/reproduce/figure.h"
#include "app/compose/resource_folder.h"
#include "core/config/nearest_word.h"
#include "core/storage/atomic_file.h"

namespace stillcut::app {
namespace {

struct ReproduceOptions {
  std::vector<std::string> wanted;
  std::string out;
  bool list = false, json = false;
};

void printList() {
  for (const Figure& f : figures()) std::printf("%-14s %-26s %s\n", f.id.c_str(), f.paper.c_str(), f.shows.c_str());
}

Result<std::vector<const Figure*>> choose(const std::vector<std::string>& wanted) {
  std::vector<const Figure*> chosen;
  for (const std::string& id : wanted) {
    std::vector<std::string_view> known{"all"};
    bool found = false;
    for (const Figure& f : figures()) {
      known.push_back(f.id);
      if (id != "all" && id != f.id) continue;
      chosen.push_back(&f);
      found = true;
    }
    if (found) continue;
    const Message near = config::didYouMean(id, known);
    return Error{id, message("is no figure that can be made"), near.empty() ? message("see reproduce --list") : near};
  }
  return chosen;
}

std::string valueText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::isfinite(value) ? text : "-";
}

void print(const Figure& figure, const FigureResult& result) {
  std::printf("%s: %s\n", figure.paper.c_str(), figure.shows.c_str());
  for (const PaperNumber& n : result.numbers) {
    std::printf("  %-48s paper %10s  ours %10s %s%s%s\n", n.name.c_str(), valueText(n.paper).c_str(),
                valueText(n.ours).c_str(), n.unit.c_str(), n.remark.empty() ? "" : ": ", n.remark.c_str());
  }
  std::fflush(stdout);
}

nlohmann::json toJson(const Figure& figure, const FigureResult& result, const std::vector<std::string>& files) {
  nlohmann::json line = jsonObject("reproduce", "answer");
  line["figure"] = figure.id;
  line["paper"] = figure.paper;
  line["files"] = files;
  line["numbers"] = nlohmann::json::array();
  for (const PaperNumber& n : result.numbers) {
    line["numbers"].push_back({{"name", n.name},
                               {"unit", n.unit},
                               {"paper", orNull(n.paper)},
                               {"ours", orNull(n.ours)},
                               {"remark", n.remark}});
  }
  return line;
}

void printError(const Figure& figure, const Error& error) {
  nlohmann::json line = jsonObject("reproduce", "error");
  line["figure"] = figure.id;
  line["error"] = error.line();
  printJsonLine(line);
}

std::string numbersCsv(const FigureResult& result) {
  std::string text = "name,unit,paper,ours,remark\n";
  const auto quoted = [](const std::string& words) { return '"' + words + '"'; };
  for (const PaperNumber& n : result.numbers) {
    text += quoted(n.name) + "," + quoted(n.unit) + "," + (std::isfinite(n.paper) ? valueText(n.paper) : "") + "," +
            (std::isfinite(n.ours) ? valueText(n.ours) : "") + "," + quoted(n.remark) + "\n";
  }
  return text;
}

Result<std::vector<std::string>> write(const Figure& figure, const FigureResult& result, const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> files{{figure.id + ".svg", svgOf(result.picture)},
                                                         {figure.id + ".csv", csvOf(result.picture)}};
  if (!result.numbers.empty()) files.emplace_back(figure.id + "-numbers.csv", numbersCsv(result));
  for (const auto& [name, content] : result.tables) files.emplace_back(figure.id + "-" + name + ".csv", content);
  std::vector<std::string> written;
  for (const auto& [name, content] : files) {
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    if (const Status s = writeFileAtomically(path, content); !s) return s.error();
    written.push_back(path.string());
  }
  return written;
}

int reproduce(const ReproduceOptions& options) {
  if (options.list) {
    printList();
    return kExitDone;
  }
  if (options.wanted.empty())
    return fail({"reproduce", message("a figure is needed"), message("see reproduce --list")});
  if (options.out.empty()) return fail({"reproduce", message("--out is needed"), message("the folder to write to")});
  const auto chosen = choose(options.wanted);
  if (!chosen) return fail(chosen.error());
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (problem) return fail({options.out, message("cannot be made"), foreign(problem.message())});
  int code = kExitDone;
  for (const Figure* figure : *chosen) {
    const auto result = figure->make();
    if (!result) {  // the others can be made all the same
      if (options.json) printError(*figure, result.error());
      code = fail(result.error());
      continue;
    }
    const auto files = write(*figure, *result, options.out);
    if (!files) return fail(files.error());
    if (options.json) {
      printJsonLine(toJson(*figure, *result, *files));
    } else {
      print(*figure, *result);
    }
  }
  return code;
}

}  // namespace

const std::vector<Figure>& figures() {
  static const std::vector<Figure> list = [] {
    std::vector<Figure> all;
    addVanDijkFigures(all);
    addLiaoFigures(all);
    addCaliskanFigures(all);
    addXuFigures(all);
    addFordFigures(all);
    return all;
  }();
  return list;
}

Result<milling::Scenario> paperScenario(const std::string& name) {
  return milling::loadScenario(foundFile("scenarios/" + name + ".toml"));
}

void addReproduce(CLI::App& app, int& exitCode) {
  auto o = std::make_shared<ReproduceOptions>();
  CLI::App* command = app.add_subcommand("reproduce", "Make figures of the papers from simulated cuts");
  command->add_option("FIGURE", o->wanted, "Figures by their names, or all");
  command->add_option("--out", o->out, "Folder for FIGURE.svg, FIGURE.csv and FIGURE-numbers.csv; made where missing");
  command->add_flag("--list", o->list, "Tell which figures there are");
  command->add_flag("--json", o->json, "Print one JSON object a figure, each in a line");
  command->callback([o, &exitCode] { exitCode = reproduce(*o); });
}

}  // namespace stillcut::app
