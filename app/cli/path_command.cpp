// stillcut-cli path RECORDING: the model of an actuator's path from a recording of what was written and what a sensor
// read of it, as the active work-holder makes it of its own record.

#include <cstdio>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/json_line.h"
#include "app/cli/out_path.h"
#include "app/cli/reading_options.h"
#include "core/active/lms.h"
#include "core/active/stability_margin.h"
#include "core/session/open_recording.h"

namespace stillcut::app {
namespace {

using nlohmann::json;

struct PathCommand {
  std::string file, out;
  int output = 0, reading = 1;
  double rate = 0.0;
  std::string timeUnit;
  std::vector<double> quieten;
  active::PathRequest request;
  int taps = 35;
  bool asJson = false;
};

struct Signals {
  std::vector<double> output, reading;
  Hertz rate{};
};

Result<Signals> readSignals(const PathCommand& command) {
  record::ReadOptions options;
  options.channels = {command.output, command.reading};
  if (command.rate > 0.0) options.rate = Hertz(command.rate);
  options.secondsPerTime = secondsOfTimeUnit(command.timeUnit);
  auto reader = record::openRecording(command.file, options);
  if (!reader) return reader.error();
  const record::RecordingFormat& format = (*reader)->format();
  Signals signals{{}, {}, format.rate};
  SampleBlock block;
  constexpr int kAtOnce = 4096;
  block.allocate(static_cast<int>(format.channels.size()), std::max(kAtOnce, format.blockFrames));
  while (true) {
    const Result<bool> more = (*reader)->read(block);
    if (!more) return more.error();
    if (!*more) return signals;
    if (block.has(kBlockGap))
      return Error{command.file, message("has a gap"), message("a path is identified from a record without one")};
    for (const float v : block.channel(0)) signals.output.push_back(format.channels[0].info.scale * v);
    // The path is what is taken off the disturbance.
    for (const float v : block.channel(1)) signals.reading.push_back(-format.channels[1].info.scale * v);
  }
}

Status writeFit(const std::string& path, const active::PathReport& report) {
  std::ofstream file(path);
  file << "frequency_hz,measured_re,measured_im,modelled_re,modelled_im,coherence\n";
  for (std::size_t k = 0; k < report.frequency.size(); ++k) {
    file << report.frequency[k] << ',' << report.measured[k].real() << ',' << report.measured[k].imag() << ','
         << report.modelled[k].real() << ',' << report.modelled[k].imag() << ',' << report.coherence[k] << '\n';
  }
  return file.good() ? Status{Done{}} : Status{Error{path, message("cannot be written")}};
}

void print(const active::IdentifiedPath& path, const ActivePath& margin, const PathCommand& command) {
  constexpr double kDegrees = 360.0 / kTwoPi;
  if (command.asJson) {
    json answer = jsonObject("path", "answer");
    answer.update({{"recording", command.file},
                   {"path_residual", orNull(path.report.residual)},
                   {"loop_delay_ms", orNull(1e3 * margin.delay.value)},
                   {"phase_left_deg", orNull(kDegrees * margin.phaseMargin)},
                   {"worst_at_hz", orNull(margin.worstFrequency.value)},
                   {"delay_left_ms", orNull(1e3 * margin.delayMargin.value)},
                   {"promises_stable", margin.predictedStable},
                   {"delay_samples", path.model.delay},
                   {"forward", path.model.forward},
                   {"backward", path.model.backward}});
    printJson(answer);
    return;
  }
  std::printf("path known to %.1f %%, %.2f ms late, %zu and %zu taps\n", 100.0 * path.report.residual,
              1e3 * margin.delay.value, path.model.forward.size(), path.model.backward.size());
  if (margin.predictedStable) {
    std::printf("%.0f of 90 degrees left at %.0f Hz; the loop may become %.2f ms later\n",
                kDegrees * margin.phaseMargin, margin.worstFrequency.value, 1e3 * margin.delayMargin.value);
  } else {
    std::printf(
        "has no phase margin: its phase is off by 90 degrees or more, or the sensor measures nothing of the actuator "
        "there\n");
  }
}

int run(PathCommand command) {
  if (const Status usable = checkOutPath(command.out, command.file); !usable) return fail(usable.error());
  if (command.output == command.reading)
    return fail(Error{"--reading", message("is the channel that was written"), foreign("--output")});
  const auto signals = readSignals(command);
  if (!signals) return fail(signals.error());
  std::vector<Hertz> lines;
  for (const double line : command.quieten) {
    if (!(line > 0.0 && line < 0.5 * signals->rate.value)) {
      return fail(Error{"--quieten", message("must lie between 0 and half the rate")});
    }
    lines.emplace_back(line);
  }
  command.request.filter.forward = command.request.filter.backward = command.taps;
  const auto path =
      active::identifyPath(signals->output, signals->reading, signals->rate, command.request, command.file);
  if (!path) return fail(path.error());
  if (!command.out.empty()) {
    if (const Status written = writeFit(command.out, path->report); !written) return fail(written.error());
  }
  print(*path, active::stabilityMarginOf(*path, lines, signals->rate), command);
  return kExitDone;
}

}  // namespace

void addPath(CLI::App& app, int& exitCode) {
  auto c = std::make_shared<PathCommand>();
  CLI::App* sub = app.add_subcommand("path", "Identify an actuator's path to its sensor from a recording");
  sub->add_option("RECORDING", c->file, "What was written to the actuator and what the sensor read")->required();
  sub->add_option("--output", c->output, "Channel of what was written, from 0")->check(CLI::NonNegativeNumber);
  sub->add_option("--reading", c->reading, "Channel of the sensor, from 0")->check(CLI::NonNegativeNumber);
  sub->add_option("--rate", c->rate, "Sampling rate of a text file without times [Hz]")->check(CLI::PositiveNumber);
  addTimeUnit(*sub, c->timeUnit);
  sub->add_flag("--sweep", c->request.sweep, "A sweep was written, and no noise");
  sub->add_option("--taps", c->taps, "Taps of each part of the recursive model")
      ->check(CLI::Range(1, active::kMostTaps));
  sub->add_option("--quieten", c->quieten, "Lines that are to be quietened [Hz]: F[,F]; left out: all that is measured")
      ->delimiter(',');
  sub->add_option("--out", c->out, "Write measured and modelled response to FIT.csv");
  sub->add_flag("--json", c->asJson, "Print one JSON object, with the model");
  sub->callback([c, &exitCode] { exitCode = run(*c); });
}

}  // namespace stillcut::app
