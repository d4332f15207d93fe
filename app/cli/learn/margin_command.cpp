#include "app/cli/learn/margin_command.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "app/cli/learn/learn_options.h"
#include "app/compose/measure_samples.h"
#include "app/compose/recording_rig.h"
#include "core/base/json_schema.h"
#include "core/learn/stable_margin.h"

namespace stillcut::app {
namespace {

using nlohmann::json;

struct MarginCommand {
  StoreOptions store;
  AssemblyOptions assembly;
  WorkOptions work;
  std::string recording;
  double speed = 0.0, depthMm = 0.0, from_s = 0.0, to_s = 0.0;  // to_s 0: to the end
  bool json = false;
};

// The stretch that was asked about, of every channel.
learn::DecayAnswer slowest(const daq::MeasuredSamples& heard, const MarginCommand& c) {
  std::vector<std::vector<double>> channels;
  for (const std::vector<float>& channel : heard.samples) {
    const auto at = [&](double seconds) {
      return std::min(channel.size(), static_cast<std::size_t>(std::max(0.0, seconds) * heard.rate.value));
    };
    const std::size_t end = c.to_s > 0.0 ? at(c.to_s) : channel.size();
    const std::size_t begin = std::min(at(c.from_s), end);
    channels.emplace_back(channel.begin() + static_cast<std::ptrdiff_t>(begin),
                          channel.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return learn::slowestDecay(channels, heard.rate, Rpm(c.speed));
}

// Empty: a stable cut, which alone has a margin. The detector of `analyze` says it, of the stretch that was asked
// about.
Result<Message> whyNone(const MarginCommand& c, int teeth) {
  RecordingOptions options;
  options.teeth = teeth;
  options.speed = Rpm(c.speed);
  auto built = buildRecordingRig(c.recording, options);
  if (!built) return built.error();
  std::optional<Instant> begin;
  bool chatters = false;
  bool stable = false;
  built->rig->runToEnd([&](const StepInput& in, const StepOutput& out) {
    if (!begin) begin = in.block.firstSample;
    const Verdict& verdict = out.verdicts.front();
    const double now = secondsBetween(*begin, verdict.time).value;
    if (now < c.from_s || (c.to_s > 0.0 && now > c.to_s)) return;
    chatters = chatters || verdict.alarming();
    stable = stable || (verdict.valid && verdict.phase == CutPhase::Steady && verdict.state == CutState::Stable);
  });
  if (chatters) return message("the cut chatters");
  return stable ? Message() : message("the cut was not judged");
}

void print(const MarginCommand& c, const learn::DecayAnswer& decay, const learn::MarginAnswer& margin) {
  if (decay.decay) {
    std::printf("free vibration at %.0f Hz, decays with %.0f +- %.0f 1/s\n", decay.decay->frequency.value,
                decay.decay->rate, decay.decay->rateSd);
  }
  if (margin.margin) {
    std::printf("at %.3g mm the depth could rise by about %.2g mm (%.2g to %.2g)\n", c.depthMm,
                1e3 * margin.margin->rise.value, 1e3 * margin.margin->low.value, 1e3 * margin.margin->high.value);
  } else {
    std::printf("nothing can be said of the margin: %s\n", text(margin.why).c_str());
  }
}

json toJson(const learn::DecayAnswer& decay, const learn::MarginAnswer& margin) {
  json object{{"schema", kJsonSchema},
              {"command", "learn margin"},
              {"decay", json()},
              {"rise_mm", json()},
              {"reason", margin.why.empty() ? json() : json(text(margin.why))}};
  if (decay.decay) {
    object["decay"] = {{"frequency_hz", decay.decay->frequency.value},
                       {"rate_per_s", decay.decay->rate},
                       {"rate_sd_per_s", decay.decay->rateSd}};
  }
  if (margin.margin) {
    object["rise_mm"] = {{"median", 1e3 * margin.margin->rise.value},
                         {"low", 1e3 * margin.margin->low.value},
                         {"high", 1e3 * margin.margin->high.value}};
  }
  return object;
}

int run(const MarginCommand& c) {
  const auto heard = measureRecording(c.recording, {});
  if (!heard) return fail(heard.error());
  auto learned = learnFrom(c.store, c.assembly, c.work);
  if (!learned) return fail(learned.error());
  const auto none = whyNone(c, learned->work.teeth);
  if (!none) return fail(none.error());
  const learn::DecayAnswer decay = none->empty() ? slowest(*heard, c) : learn::DecayAnswer{std::nullopt, *none};
  learn::MarginAnswer margin{std::nullopt, decay.why};
  if (decay.decay) {
    const learn::StableCut cut{learned->work.engagement, learned->work.teeth, Rpm(c.speed), Metres(1e-3 * c.depthMm)};
    margin = stableMargin(learned->posterior, cut, *decay.decay);
  }
  if (c.json) {
    std::printf("%s\n", toJson(decay, margin).dump(-1, ' ', false, json::error_handler_t::replace).c_str());
  } else {
    print(c, decay, margin);
  }
  return kExitDone;
}

}  // namespace

void addMargin(CLI::App& learn, int& exitCode) {
  auto c = std::make_shared<MarginCommand>();
  CLI::App* sub = learn.add_subcommand("margin", "How far a recorded stable cut is from chatter");
  sub->add_option("RECORDING", c->recording, "The cut: steady and without chatter")->required();
  c->store.add(*sub);
  c->assembly.add(*sub);
  c->work.add(*sub);
  sub->add_option("--speed", c->speed, "Spindle speed, as exact as it is known [rpm]")
      ->required()
      ->check(CLI::PositiveNumber);
  sub->add_option("--depth", c->depthMm, "Axial depth [mm]")->required()->check(CLI::PositiveNumber);
  sub->add_option("--from", c->from_s, "Where the steady cut begins [s]")->check(CLI::NonNegativeNumber);
  sub->add_option("--to", c->to_s, "Where it ends [s]; left out: with the recording")->check(CLI::PositiveNumber);
  sub->add_flag("--json", c->json, "Print JSON");
  sub->callback([c, &exitCode] { exitCode = run(*c); });
}

}  // namespace stillcut::app
