// stillcut-cli coefficients FORCES... --out MATERIAL.toml

#include <cstdio>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/force_file.h"
#include "app/cli/out_path.h"
#include "core/milling/identify/coefficients.h"
#include "core/milling/identify/model_files.h"

namespace stillcut::app {
namespace {

using namespace identify;

struct CoefficientsCommand {
  std::vector<std::string> files;
  std::string out, signs;
  std::string side = "up";
  std::string feedAxis = "x";
  std::vector<double> feedsMmPerMin, feedsPerToothMm;
  std::vector<int> channels;
  double speed = 0.0;  // [rev/min]
  int teeth = 0;
  double depthMm = 0.0;
  double immersion = 1.0;
};

// Feed per tooth of each file [m].
Result<std::vector<double>> feedsOf(const CoefficientsCommand& c) {
  const bool perTooth = !c.feedsPerToothMm.empty();
  const std::vector<double>& given = perTooth ? c.feedsPerToothMm : c.feedsMmPerMin;
  const std::string option = perTooth ? "--feed-per-tooth" : "--feed";
  if (given.size() != c.files.size()) {
    return Error{option,
                 message("gives %1 feeds for %2 files", std::to_string(given.size()), std::to_string(c.files.size())),
                 message("one for each, in their order, as --feed 300,900")};
  }
  std::vector<double> feeds;
  feeds.reserve(given.size());
  for (const double f : given) feeds.push_back(perTooth ? 1e-3 * f : 1e-3 * f / (c.speed * c.teeth));
  return feeds;
}

// "+--": signs along the feed, across it and up.
Status readSigns(const std::string& text, ForceAxes& axes) {
  if (text.empty() || text == "auto") return Done{};
  if (text.size() != 3 || text.find_first_not_of("+-") != std::string::npos) {
    return Error{"--signs", message("'%1' is not three signs", text), message("as --signs=--+ or auto")};
  }
  std::array<int, 3> signs{};
  for (std::size_t i = 0; i < 3; ++i) signs[i] = text[i] == '+' ? 1 : -1;
  axes.signs = signs;
  return Done{};
}

void print(const ForceTest& test, const CoefficientsCommand& c, const CuttingCoefficients& k) {
  for (std::size_t i = 0; i < test.means.size(); ++i) {
    const MeanForce& m = test.means[i];
    std::printf("%s: %.4f mm per tooth, mean %.1f +-%.1f, %.1f +-%.1f, %.1f +-%.1f N\n", c.files[i].c_str(),
                1e3 * m.feedPerTooth, m.mean[0], m.standardError[0], m.mean[1], m.standardError[1], m.mean[2],
                m.standardError[2]);
  }
  const auto line = [](const char* name, const Coefficient& v, double unit, const char* label) {
    std::printf("%-5s %9.1f +- %6.1f %s\n", name, v.value / unit, v.deviation / unit, label);
  };
  line("K_t", k.tangential, 1e6, "N/mm2");
  line("K_r", k.radial, 1e6, "N/mm2");
  line("K_a", k.axial, 1e6, "N/mm2");
  line("K_te", k.tangentialEdge, 1e3, "N/mm");
  line("K_re", k.radialEdge, 1e3, "N/mm");
  line("K_ae", k.axialEdge, 1e3, "N/mm");
  for (const std::string& remark : k.remarks) std::printf("%s\n", remark.c_str());
}

int run(const CoefficientsCommand& c) {
  if (const Status usable = checkOutPath(c.out); !usable) return fail(usable.error());
  const auto feeds = feedsOf(c);
  if (!feeds) return fail(feeds.error());
  ForceTest test;
  test.teeth = c.teeth;
  test.depth = 1e-3 * c.depthMm;
  test.engagement = {c.immersion, c.side == "up" ? milling::MillingDirection::Up : milling::MillingDirection::Down};
  test.axes.feed = c.feedAxis == "x" ? FeedAxis::X : FeedAxis::Y;
  if (const Status signs = readSigns(c.signs, test.axes); !signs) return fail(signs.error());
  for (std::size_t i = 0; i < c.files.size(); ++i) {
    test.source += (i > 0 ? ", " : "") + c.files[i];
    const auto file = readForces(c.files[i], c.channels);
    if (!file) return fail(file.error());
    const auto mean = meanOverRevolutions({file->force[0], file->force[1], file->force[2]}, file->rate.value,
                                          Rpm(c.speed), (*feeds)[i], c.files[i]);
    if (!mean) return fail(mean.error());
    test.means.push_back(*mean);
  }
  const auto found = identifyCoefficients(test);
  if (!found) return fail(found.error());
  if (!c.out.empty()) {
    const Status saved = saveMaterial(materialFile(*found, test.source), c.out);
    if (!saved) return fail(saved.error());
  }
  print(test, c, *found);
  return kExitDone;
}

}  // namespace

void addCoefficients(CLI::App& app, int& exitCode) {
  auto c = std::make_shared<CoefficientsCommand>();
  CLI::App* sub = app.add_subcommand("coefficients", "Identify cutting coefficients from forces at several feeds");
  sub->add_option("FORCES", c->files, "Recordings of the three forces, one per feed, at least two")->required();
  sub->add_option("--out", c->out, "Write the coefficients to MATERIAL.toml");
  sub->add_option("--speed", c->speed, "Spindle speed [rpm]")->required()->check(CLI::PositiveNumber);
  sub->add_option("--teeth", c->teeth, "Number of teeth")->required()->check(CLI::Range(1, milling::kMostTeeth));
  sub->add_option("--depth", c->depthMm, "Axial depth [mm]")->required()->check(CLI::PositiveNumber);
  auto* feed = sub->add_option("--feed", c->feedsMmPerMin, "Feed of each file [mm/min], as 300,900")->delimiter(',');
  sub->add_option("--feed-per-tooth", c->feedsPerToothMm, "Feed per tooth of each file [mm] instead")
      ->delimiter(',')
      ->excludes(feed);
  sub->add_option("--immersion", c->immersion, "Radial immersion a_e/D; left out: 1, a slot")
      ->check(CLI::Range(0.0, 1.0));
  sub->add_option("--side", c->side, "up or down milling")->check(CLI::IsMember({"up", "down"}));
  sub->add_option("--feed-axis", c->feedAxis, "Dynamometer axis along the feed, x or y")
      ->check(CLI::IsMember({"x", "y"}));
  sub->add_option("--signs", c->signs,
                  "Signs that make the axes along, left of and above the feed the force on the tool, as --signs=--+");
  sub->add_option("--channel", c->channels, "The three force channels, counted from 0, as 0,1,2")->delimiter(',');
  sub->callback([c, &exitCode] { exitCode = run(*c); });
}

}  // namespace stillcut::app
