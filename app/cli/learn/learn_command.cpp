// stillcut-cli learn add|list|show|next|export|import|merge|forget: lobes from judged cuts.

#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/learn/learn_answer.h"
#include "app/cli/learn/learn_options.h"
#include "app/cli/learn/margin_command.h"
#include "app/cli/learn/program_command.h"
#include "app/cli/out_path.h"
#include "core/base/json_schema.h"
#include "core/storage/atomic_file.h"

namespace stillcut::app {
namespace {

using nlohmann::json;

void print(const json& object) {
  std::printf("%s\n", object.dump(-1, ' ', false, json::error_handler_t::replace).c_str());
}

Result<std::string> readText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{path, message("cannot be read")};
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) return Error{path, message("cannot be read")};
  return text;
}

struct AddCommand {
  StoreOptions store;
  AssemblyOptions assembly;
  WorkOptions work;
  std::string outcome, answer;
  double speed = 0.0, depthMm = 0.0, frequency = 0.0, frequencySd = 0.0, doubt = -1.0;
  double time = -1.0;
  bool json = false;
};

json fieldOf(const json& object, const char* key) {
  const auto at = object.find(key);
  return object.is_object() && at != object.end() ? *at : json();
}

std::string textOf(const json& object, const char* key) {
  const json field = fieldOf(object, key);
  return field.is_string() ? field.get<std::string>() : std::string();
}

double numberOf(const json& object, const char* key) {
  const json field = fieldOf(object, key);
  return field.is_number() ? field.get<double>() : 0.0;
}

// What `analyze --json` said of a recording.
Status addAnswer(const std::string& path, learn::CutEvidence& cut) {
  const auto text = readText(path);
  if (!text) return text.error();
  const json answer = json::parse(*text, nullptr, false);
  const json said = fieldOf(answer, "answer");
  const std::string finding = textOf(said, "finding");
  if (textOf(answer, "schema") != kJsonSchema || finding.empty()) {
    return Error{path, message("is no answer of analyze"), message("one recording, as analyze --json prints it")};
  }
  if (finding == "not-judged") return Error{path, message("was not judged"), message("nothing is learned from it")};
  cut.outcome = finding == "chatter" ? learn::CutOutcome::Chatter : learn::CutOutcome::Stable;
  if (finding == "chatter") cut.frequency = Hertz(numberOf(said, "frequency_hz"));
  cut.source = textOf(answer, "recording");
  if (cut.speed.value == 0.0) cut.speed = Rpm(numberOf(fieldOf(said, "advice"), "present_rpm"));
  return Done{};
}

Result<learn::CutEvidence> cutOf(const AddCommand& c) {
  learn::CutEvidence cut;
  cut.assembly = {c.assembly.machine, c.assembly.tool, c.assembly.holder, Metres(1e-3 * c.assembly.stickOutMm)};
  cut.material = c.work.material;
  cut.teeth = c.work.teeth;
  cut.diameter = Metres(1e-3 * c.work.diameterMm);
  cut.engagement.radialImmersion = c.work.immersion;
  cut.engagement.side = c.work.side == "up" ? milling::MillingDirection::Up : milling::MillingDirection::Down;
  cut.speed = Rpm(c.speed);
  cut.depth = Metres(1e-3 * c.depthMm);
  cut.frequency = Hertz(c.frequency);
  cut.frequencySd = Hertz(c.frequencySd);
  cut.time_s = c.time >= 0.0 ? static_cast<std::int64_t>(c.time) : static_cast<std::int64_t>(std::time(nullptr));
  if (c.doubt >= 0.0) cut.doubt = c.doubt;
  if (c.outcome.empty() == c.answer.empty()) {
    return Error{message("learn add"), message("stable or chatter?"), message("give either --outcome or --answer")};
  }
  if (!c.answer.empty()) {
    if (Status read = addAnswer(c.answer, cut); !read) return read.error();
  } else {
    cut.outcome = c.outcome == "chatter" ? learn::CutOutcome::Chatter : learn::CutOutcome::Stable;
  }
  if (Status ok = check(cut, "learn add"); !ok) return ok.error();
  return cut;
}

int runAdd(const AddCommand& c) {
  auto cut = cutOf(c);
  if (!cut) return fail(cut.error());
  auto store = c.store.open();
  if (!store) return fail(store.error());
  const auto id = store->add(*cut);
  if (!id) return fail(id.error());
  cut->id = *id;
  if (c.json) {
    print({{"schema", kJsonSchema}, {"command", "learn add"}, {"cut", toJson(*cut)}});
  } else {
    std::printf("kept as %s: %s at %.0f rpm, %.3g mm\n", id->c_str(), std::string(name(cut->outcome)).c_str(),
                cut->speed.value, 1e3 * cut->depth.value);
  }
  return kExitDone;
}

struct AskCommand {
  StoreOptions store;
  AssemblyOptions assembly;
  WorkOptions work;
  double mostChatter = 0.6;
  int series = 1;
  bool json = false;
};

int runShow(const AskCommand& c) {
  auto learned = learnFrom(c.store, c.assembly, c.work);
  if (!learned) return fail(learned.error());
  c.json ? print(postureJson(*learned, c.work.risk)) : printPosture(*learned, c.work.risk);
  return kExitDone;
}

void printNext(const learn::NextCut& next) {
  std::printf("next: %.0f rpm, %.2f mm; stable with %.0f %%, tells %.1f bits\n", next.speed.value,
              1e3 * next.depth.value, 100.0 * next.probabilityStable, next.bits);
  const auto best = [](const char* when, const learn::LearnedAdvice& a) {
    if (a.removal > 0.0) std::printf("%s %.0f rpm and %.2f mm\n", when, a.speed.value, 1e3 * a.depth.value);
  };
  best("best cut as of now:", next.now);
  best("if it is stable:   ", next.ifStable);
  best("if it chatters:    ", next.ifChatter);
  std::printf("removal expected to change by %+.0f %%\n", 100.0 * (next.removalExpected / next.removalNow - 1.0));
}

int runNext(const AskCommand& c) {
  auto learned = learnFrom(c.store, c.assembly, c.work);
  if (!learned) return fail(learned.error());
  const learn::MapRequest& w = learned->work;
  learn::TrialLimits limits{w.engagement, w.teeth,     w.lowest,      w.highest,
                            w.deepest,    c.work.risk, c.mostChatter, c.series};
  const auto next = nextCut(learned->posterior, limits);
  if (!next) return fail(next.error());
  if (c.json) {
    json object = toJson(*next);
    object.update({{"schema", kJsonSchema}, {"command", "learn next"}});
    print(object);
  } else {
    printNext(*next);
  }
  return kExitDone;
}

struct FileCommand {
  StoreOptions store;
  std::string file;
  bool json = false;
};

int runList(const FileCommand& c) {
  const auto store = c.store.open();
  if (!store) return fail(store.error());
  const auto found = store->assemblies();
  if (!found) return fail(found.error());
  json rows = json::array();
  for (const learn::AssemblyCount& a : *found) {
    if (!c.json) {
      std::printf("%s, %s, %s, stick-out %.4g mm: %d stable, %d with chatter\n", a.assembly.machine.c_str(),
                  a.assembly.tool.c_str(), a.assembly.holder.empty() ? "-" : a.assembly.holder.c_str(),
                  1e3 * a.assembly.stickOut.value, a.stable, a.chatter);
    }
    rows.push_back({{"machine", a.assembly.machine},
                    {"tool", a.assembly.tool},
                    {"holder", a.assembly.holder},
                    {"stick_out_mm", 1e3 * a.assembly.stickOut.value},
                    {"stable", a.stable},
                    {"chatter", a.chatter}});
  }
  if (c.json) print({{"schema", kJsonSchema}, {"command", "learn list"}, {"assemblies", rows}});
  return kExitDone;
}

int runExport(const FileCommand& c) {
  if (const Status usable = checkOutPath(c.file, c.store.store); !usable) return fail(usable.error());
  const auto store = c.store.open();
  if (!store) return fail(store.error());
  const auto lines = store->exportLines();
  if (!lines) return fail(lines.error());
  if (const Status saved = writeFileAtomically(c.file, *lines); !saved) return fail(saved.error());
  return kExitDone;
}

int tell(const FileCommand& c, const char* command, const Result<learn::MergeCount>& count) {
  if (!count) return fail(count.error());
  if (c.json) {
    print({{"schema", kJsonSchema}, {"command", command}, {"added", count->added}, {"known", count->known}});
  } else {
    std::printf("%d cuts added, %d were known\n", count->added, count->known);
  }
  return kExitDone;
}

int runImport(const FileCommand& c) {
  const auto text = readText(c.file);
  if (!text) return fail(text.error());
  auto store = c.store.open();
  if (!store) return fail(store.error());
  return tell(c, "learn import", store->importLines(*text, c.file));
}

int runMerge(const FileCommand& c) {
  auto store = c.store.open();
  if (!store) return fail(store.error());
  return tell(c, "learn merge", store->merge(c.file));
}

int runForget(const FileCommand& c) {
  auto store = c.store.open();
  if (!store) return fail(store.error());
  if (const Status gone = store->remove(c.file); !gone) return fail(gone.error());
  return kExitDone;
}

void addAdding(CLI::App& learn, int& exitCode) {
  auto c = std::make_shared<AddCommand>();
  CLI::App* sub = learn.add_subcommand("add", "Keep a judged cut");
  c->store.add(*sub);
  c->assembly.add(*sub);
  sub->add_option("--teeth", c->work.teeth, "Teeth of the tool")->required()->check(CLI::Range(1, 200));
  sub->add_option("--diameter", c->work.diameterMm, "Diameter of the tool [mm]")
      ->required()
      ->check(CLI::PositiveNumber);
  sub->add_option("--immersion", c->work.immersion, "Width of the cut over the diameter")
      ->required()
      ->check(CLI::Range(0.001, 1.0));
  sub->add_option("--side", c->work.side, "up or down")->check(CLI::IsMember({"up", "down"}));
  sub->add_option("--material", c->work.material, "Material of the part");
  sub->add_option("--speed", c->speed, "Spindle speed [rpm]; may be left out where the answer says it");
  sub->add_option("--depth", c->depthMm, "Axial depth [mm]")->required()->check(CLI::PositiveNumber);
  sub->add_option("--outcome", c->outcome, "stable or chatter")->check(CLI::IsMember({"stable", "chatter"}));
  sub->add_option("--answer", c->answer, "What analyze --json said of the cut's recording, instead of --outcome");
  sub->add_option("--frequency", c->frequency, "Of the chatter [Hz]")->check(CLI::PositiveNumber);
  sub->add_option("--frequency-sd", c->frequencySd, "Its standard deviation [Hz]")->check(CLI::PositiveNumber);
  sub->add_option("--doubt", c->doubt, "Probability that the verdict is wrong; 0.02 unless given")
      ->check(CLI::Range(0.0, 0.5));
  sub->add_option("--time", c->time, "Seconds since 1970 UTC; left out: now");
  sub->add_flag("--json", c->json, "Print JSON");
  sub->callback([c, &exitCode] { exitCode = runAdd(*c); });
}

void addAsking(CLI::App& learn, int& exitCode) {
  auto show = std::make_shared<AskCommand>();
  CLI::App* sub = learn.add_subcommand("show", "What is known of a tool: modes, limits, the best cut");
  auto next = std::make_shared<AskCommand>();
  CLI::App* trial = learn.add_subcommand("next", "The next most useful cut, and what it would tell");
  for (const auto& [command, c] : {std::pair{sub, show.get()}, std::pair{trial, next.get()}}) {
    c->store.add(*command);
    c->assembly.add(*command);
    c->work.add(*command);
    command->add_flag("--json", c->json, "Print JSON");
  }
  trial->add_option("--most-chatter", next->mostChatter, "Probability of chatter that the trial may have")
      ->check(CLI::Range(0.05, 0.95));
  trial->add_option("--left", next->series, "Cuts left in a guided series, this one included")
      ->check(CLI::Range(1, 50));
  sub->callback([show, &exitCode] { exitCode = runShow(*show); });
  trial->callback([next, &exitCode] { exitCode = runNext(*next); });
}

void addFiles(CLI::App& learn, int& exitCode) {
  struct Way {
    const char *name, *says, *argument, *argumentSays;
    int (*run)(const FileCommand&);
  };
  constexpr Way kWays[] = {
      {"list", "Which tools have cuts", nullptr, nullptr, runList},
      {"export", "All cuts as JSON lines", "OUT", "File to write", runExport},
      {"import", "Add cuts from JSON lines; all or none", "IN", "File that export wrote", runImport},
      {"merge", "Add the cuts of another store", "OTHER", "The other store", runMerge},
      {"forget", "Take a cut out again", "ID", "Its id, as export shows it", runForget},
  };
  for (const Way& way : kWays) {
    auto c = std::make_shared<FileCommand>();
    CLI::App* sub = learn.add_subcommand(way.name, way.says);
    c->store.add(*sub);
    if (way.argument != nullptr) sub->add_option(way.argument, c->file, way.argumentSays)->required();
    sub->add_flag("--json", c->json, "Print JSON");
    sub->callback([c, &exitCode, run = way.run] { exitCode = run(*c); });
  }
}

}  // namespace

void addLearn(CLI::App& app, int& exitCode) {
  CLI::App* learn = app.add_subcommand("learn", "Lobes learned from judged cuts");
  learn->require_subcommand(1);
  addAdding(*learn, exitCode);
  addAsking(*learn, exitCode);
  addFiles(*learn, exitCode);
  addMargin(*learn, exitCode);
  addTrialProgram(*learn, exitCode);
}

}  // namespace stillcut::app
