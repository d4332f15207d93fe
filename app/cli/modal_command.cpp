// stillcut-cli modal FRF|HAMMER --out MODES.toml

#include <cstdio>
#include <map>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/out_path.h"
#include "core/milling/identify/modal_measurement.h"
#include "core/milling/identify/model_files.h"

namespace stillcut::app {
namespace {

using namespace identify;

struct ModalCommand {
  std::string file, out, band;
  std::string axis = "x";
  MeasurementKind kind = MeasurementKind::Automatic;
  double scale = 0.0;  // 0: the file's
  std::string quantity;
  double forceWindowMs = 0.0;
  bool flip = false;
  ModalRequest request;
};

// "600:3100", either end may be left out.
Status readBand(const std::string& text, ModalOptions& fit) {
  if (text.empty()) return Done{};
  const Error bad{"--band", message("'%1' is no band", text), message("FROM:TO in Hz, as 600:3100")};
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return bad;
  const auto number = [](const std::string& s, double& value) {
    return s.empty() || (CLI::detail::lexical_cast(s, value) && value >= 0.0);
  };
  if (!number(text.substr(0, colon), fit.from) || !number(text.substr(colon + 1), fit.to)) return bad;
  return Done{};
}

void print(const ModalAnswer& answer) {
  const ModalFit& fit = answer.fit;
  for (std::size_t i = 0; i < answer.hits.size(); ++i) {
    const Hit& h = answer.hits[i];
    std::printf("hit %zu at %.4f s: %.0f N, %.2f ms wide%s\n", i + 1, h.time, h.peakForce, 1e3 * h.width,
                h.used ? "" : ", left out");
  }
  std::printf("band %.0f to %.0f Hz, misfit %.1f %%, with real modes %.1f %%\n", fit.from, fit.to, 100.0 * fit.misfit,
              100.0 * fit.realMisfit);
  std::printf("%14s %18s %24s %7s  %s\n", "frequency/Hz", "damping", "stiffness/(N/m)", "share", "doubt");
  for (const IdentifiedMode& m : fit.modes) {
    std::printf("%8.1f +-%4.1f %8.4f +-%7.4f %12.3e +-%9.1e %5.0f %%  %s\n", m.mode.frequency.value, m.frequencySd,
                m.mode.damping, m.dampingSd, m.mode.stiffness, m.stiffnessSd, 100.0 * m.share, m.caveat.c_str());
  }
  for (const std::string& remark : answer.remarks) std::printf("%s\n", remark.c_str());
}

int run(ModalCommand command) {
  if (const Status usable = checkOutPath(command.out, command.file); !usable) return fail(usable.error());
  if (const Status band = readBand(command.band, command.request.fit); !band) return fail(band.error());
  ModalRequest& request = command.request;
  request.import.kind = command.kind;
  if (command.scale != 0.0) request.import.scale = command.scale;
  if (command.quantity == "compliance") request.import.quantity = FrfQuantity::Compliance;
  if (command.quantity == "mobility") request.import.quantity = FrfQuantity::Mobility;
  if (command.quantity == "accelerance") request.import.quantity = FrfQuantity::Accelerance;
  request.hammer.forceWindow = 1e-3 * command.forceWindowMs;
  request.hammer.flipResponse = command.flip;
  const auto answer = identifyModes(command.file, request);
  if (!answer) return fail(answer.error());
  if (!command.out.empty()) {
    const std::array<double, 2> direction =
        command.axis == "y" ? std::array<double, 2>{0.0, 1.0} : std::array<double, 2>{1.0, 0.0};
    const Status saved = saveModes(modesFile(answer->fit, command.file, direction), command.out);
    if (!saved) return fail(saved.error());
  }
  print(*answer);
  return kExitDone;
}

}  // namespace

void addModal(CLI::App& app, int& exitCode) {
  auto c = std::make_shared<ModalCommand>();
  CLI::App* sub = app.add_subcommand("modal", "Identify modes from a tap test");
  sub->add_option("FILE", c->file, "Frequency response (text, CSV, UFF 58) or hammer record")->required();
  sub->add_option("--out", c->out, "Write the modes to MODES.toml");
  sub->add_option("--axis", c->axis, "Direction of the hit: x (along the feed) or y")->check(CLI::IsMember({"x", "y"}));
  sub->add_option("--band", c->band, "FROM:TO in Hz; left out: found from the resonances");
  sub->add_option("--modes", c->request.fit.modes, "Number of modes; left out: as many as the measurement calls for");
  sub->add_option("--order", c->request.fit.highestOrder, "Highest model order of the stabilisation");
  const std::map<std::string, MeasurementKind> kinds = {
      {"auto", MeasurementKind::Automatic}, {"frf", MeasurementKind::Frf}, {"hammer", MeasurementKind::Hammer}};
  sub->add_option("--kind", c->kind, "What the file holds: auto, frf, hammer")
      ->transform(CLI::CheckedTransformer(kinds));
  sub->add_option("--quantity", c->quantity, "compliance, mobility or accelerance, instead of what the file says")
      ->check(CLI::IsMember({"compliance", "mobility", "accelerance"}));
  sub->add_option("--scale", c->scale, "SI units of the response per unit of the file");
  sub->add_option("--dataset", c->request.import.dataset, "Which frequency response of a UFF file, from 0");
  sub->add_flag("--flip", c->flip, "The accelerometer points against the force");
  sub->add_flag("--flip-force", c->request.hammer.flipForce, "The force channel counts a push as negative");
  sub->add_option("--force-window", c->forceWindowMs, "Zero the force this long after its peak [ms]");
  sub->add_option("--exponential", c->request.hammer.exponentialEnd,
                  "Share of amplitude an exponential window leaves at the end; its damping is taken off again");
  sub->add_option("--overload", c->request.hammer.overload, "Size at which force or response is overloaded");
  sub->add_flag("--use-double-hits", c->request.hammer.useDoubleHits, "Keep double hits");
  sub->callback([c, &exitCode] { exitCode = run(*c); });
}

}  // namespace stillcut::app
