// stillcut-cli modal FILE.. --out MODES.toml

#include <cstdio>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/modes_text.h"
#include "app/cli/out_path.h"
#include "app/cli/tap_options.h"

namespace stillcut::app {
namespace {

using namespace identify;

struct ModalCommand {
  std::vector<std::string> files;
  std::string out;
  TapOptions tap;
};

void printHits(const AxisModes& axis, const HammerOptions& hammer) {
  for (std::size_t i = 0; i < axis.hits.size(); ++i) {
    const Hit& h = axis.hits[i];
    const std::string in = axis.records.size() > 1 ? " of " + axis.records[h.record] : "";
    std::printf("hit %zu at %.4f s%s: %.0f N, %.2f ms wide%s\n", i + 1, h.time, in.c_str(), h.peakForce, 1e3 * h.width,
                h.used ? "" : ", left out");
  }
  const std::string force = hammer.forceWindow > 0.0
                                ? "force window " + std::to_string(std::lround(1e3 * hammer.forceWindow)) + " ms"
                                : "no force window";
  if (axis.frf.addedDecay > 0.0) {
    std::printf("%s, %s, exponential window to %.3g at the end (its %.3g 1/s are taken off the damping)\n",
                hammer.estimate == FrfEstimate::H2 ? "H2" : "H1", force.c_str(), hammer.exponentialEnd,
                axis.frf.addedDecay);
  } else {
    std::printf("%s, %s, no exponential window\n", hammer.estimate == FrfEstimate::H2 ? "H2" : "H1", force.c_str());
  }
}

std::string joinedNames(const std::vector<std::string>& files) {
  std::string names;
  for (const std::string& file : files) names += (names.empty() ? "" : ", ") + file;
  return names;
}

int run(const ModalCommand& command) {
  for (const std::string& file : command.files) {
    if (const Status usable = checkOutPath(command.out, file); !usable) return fail(usable.error());
  }
  auto request = command.tap.understand();
  if (!request) return fail(request.error());
  request->takesZ = command.out.empty();  // to be looked at only
  auto answer = identifyModes(command.files, *request);
  if (!answer) return fail(answer.error());
  for (const Message& remark : answer->remarks) std::printf("%s\n", text(remark).c_str());
  for (AxisModes& axis : answer->axes) {
    if (axis.axis == Axis::Unknown) {
      axis.axis = Axis::X;
      std::printf("the file does not say along which axis: x (--axis says otherwise)\n");
    }
  }
  if (!command.out.empty()) {
    const Status saved = saveAxes(answer->axes, joinedNames(command.files), command.out);
    if (!saved) return fail(saved.error());
  }
  for (const AxisModes& axis : answer->axes) {
    if (axis.fromHammer) {
      printHits(axis, request->hammer);
      std::printf("the hit reaches up to %.0f Hz\n", axis.frf.usableTo);
    }
    printModes(axis);
  }
  return kExitDone;
}

}  // namespace

void addModal(CLI::App& app, int& exitCode) {
  auto c = std::make_shared<ModalCommand>();
  CLI::App* sub = app.add_subcommand("modal", "Identify modes from a tap test");
  sub->add_option("FILE", c->files, "Frequency response (text, UFF 58, MATLAB) or hammer records (any recording)")
      ->required();
  sub->add_option("--out", c->out, "Write the modes to MODES.toml");
  c->tap.add(*sub);
  sub->callback([c, &exitCode] { exitCode = run(*c); });
}

}  // namespace stillcut::app
