#include "app/cli/learn/program_command.h"

#include <cstdio>
#include <map>
#include <memory>

#include "app/cli/out_path.h"
#include "core/learn/trial_program.h"
#include "core/storage/atomic_file.h"

namespace stillcut::app {
namespace {

using learn::Controller;
using learn::TrialKind;

struct ProgramCommand {
  learn::TrialProgram trial;
  std::string kind = "cut", controller = "linuxcnc", out;
  double diameterMm = 0.0, feedMm = 0.0, speed = 0.0, lastSpeed = 0.0, depthMm = 0.0, lastDepthMm = 0.0, lengthMm = 0.0,
         clearanceMm = 5.0;
};

int run(const ProgramCommand& c) {
  static const std::map<std::string, TrialKind> kKinds{
      {"cut", TrialKind::Cut}, {"sweep", TrialKind::SpeedSweep}, {"incline", TrialKind::Incline}};
  learn::TrialProgram trial = c.trial;
  trial.kind = kKinds.at(c.kind);
  trial.controller = c.controller == "grbl" ? Controller::Grbl : Controller::LinuxCnc;
  trial.diameter = Metres(1e-3 * c.diameterMm);
  trial.feedPerTooth = Metres(1e-3 * c.feedMm);
  trial.speed = Rpm(c.speed);
  trial.lastSpeed = Rpm(c.lastSpeed);
  trial.depth = Metres(1e-3 * c.depthMm);
  trial.lastDepth = Metres(1e-3 * c.lastDepthMm);
  trial.length = Metres(1e-3 * c.lengthMm);
  trial.clearance = Metres(1e-3 * c.clearanceMm);
  if (const Status usable = checkOutPath(c.out); !usable) return fail(usable.error());
  const auto text = trialGCode(trial);
  if (!text) return fail(text.error());
  if (c.out.empty()) {
    std::fputs(text->c_str(), stdout);
  } else if (const Status saved = writeFileAtomically(c.out, *text); !saved) {
    return fail(saved.error());
  }
  return kExitDone;
}

}  // namespace

void addTrialProgram(CLI::App& learn, int& exitCode) {
  auto c = std::make_shared<ProgramCommand>();
  CLI::App* sub = learn.add_subcommand("program", "G-code of a trial: one cut, a sweep of the speed, an inclined cut");
  sub->add_option("--kind", c->kind, "cut, sweep or incline")->check(CLI::IsMember({"cut", "sweep", "incline"}));
  sub->add_option("--controller", c->controller, "linuxcnc or grbl")->check(CLI::IsMember({"linuxcnc", "grbl"}));
  sub->add_option("--teeth", c->trial.teeth, "Teeth of the tool")->required()->check(CLI::Range(1, 200));
  sub->add_option("--diameter", c->diameterMm, "Diameter of the tool [mm]")->required()->check(CLI::PositiveNumber);
  sub->add_option("--feed", c->feedMm, "Feed per tooth [mm]")->required()->check(CLI::PositiveNumber);
  sub->add_option("--speed", c->speed, "Spindle speed, of a sweep the first [rpm]")->required();
  sub->add_option("--to-speed", c->lastSpeed, "Last speed of a sweep [rpm]");
  sub->add_option("--depth", c->depthMm, "Axial depth, of an incline the first [mm]")->required();
  sub->add_option("--to-depth", c->lastDepthMm, "Last depth of an incline [mm]");
  sub->add_option("--length", c->lengthMm, "Length of material along X [mm]")->required();
  sub->add_option("--clearance", c->clearanceMm, "Between tool and material: above, before and behind [mm]");
  sub->add_option("--rate", c->trial.sweepPerSecond, "Change of speed of a sweep, 0.03 is 3 % a second");
  sub->add_option("--out", c->out, "Write the program to a file instead of printing it");
  sub->callback([c, &exitCode] { exitCode = run(*c); });
}

}  // namespace stillcut::app
