// What session files cost: the share of a core that writing takes, how long it takes to open ten hours and go to any
// time in them, and how fast all detectors go through a recording.
//   bench_session [HOURS]      of the long file, 10 unless told (8 GB in the folder for temporary files); 0: only how
//                              fast the detectors are, on a longer cut (for a profile)

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <random>

#include "app/compose/recording_rig.h"
#include "app/compose/run_text.h"
#include "app/compose/scenario_rig.h"
#include "core/detect/registry.h"
#include "core/evaluate/session_summary_builder.h"
#include "core/session/file/session_markers.h"
#include "core/session/open_recording.h"
#include "core/session/recorder.h"
#include "core/session/session_overview.h"
#include "tests/support/demo_cut.h"
#include "tests/support/temp_folder.h"

namespace stillcut::bench {
namespace {

double seconds(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

record::SessionHeader header(int channels, double rate_Hz, int blockFrames) {
  record::SessionHeader h;
  h.setup.rate = Hertz(rate_Hz);
  h.setup.blockFrames = blockFrames;
  h.configuration = app::runText({}, "");
  for (int c = 0; c < channels; ++c) {
    h.setup.channels.push_back({std::string(1, static_cast<char>('a' + c)), SensorQuantity::Acceleration, 1.0, "x"});
  }
  return h;
}

// Noise, one block of it per channel, again and again.
StepRecord noise(const record::SessionHeader& h) {
  StepRecord step;
  SampleBlock& block = step.input.block;
  block.allocate(static_cast<int>(h.setup.channels.size()), h.setup.blockFrames);
  block.frames = h.setup.blockFrames;
  block.rate = h.setup.rate;
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  for (float& s : block.samples) s = normal(random);
  step.output.verdictCount = 1;
  step.output.verdicts[0].valid = true;
  return step;
}

void advance(StepRecord& step, std::uint64_t number) {
  SampleBlock& block = step.input.block;
  block.sequence = number;
  const double begin = static_cast<double>(number) * block.frames / block.rate.value;
  block.firstSample = instantFromNs(0) + toDuration(Seconds(begin));
  step.output.verdicts[0].time = block.end();
}

bool writing(const record::TempFolder& folder, bool toDisk) {
  constexpr double kLength = 60.0;
  const record::SessionHeader h = header(8, 102400.0, 512);
  record::SessionWriterOptions options;
  options.powerSafe = toDisk;
  auto writer = record::SessionWriter::create(folder / "wide.h5", h, options);
  if (!writer) return false;
  StepRecord step = noise(h);
  const auto steps = static_cast<std::uint64_t>(kLength * 102400.0 / 512.0);
  const double began = seconds(CLOCK_THREAD_CPUTIME_ID);
  for (std::uint64_t i = 0; i < steps; ++i) {
    advance(step, i);
    if (!(*writer)->add(step.input, step.output)) return false;
  }
  if (!(*writer)->close()) return false;
  const double cpu = seconds(CLOCK_THREAD_CPUTIME_ID) - began;
  std::printf("writing 8 x 102.4 kHz%s: %.1f %% of a core (asked: 15 %%)\n", toDisk ? ", synced" : "",
              100.0 * cpu / kLength);
  std::filesystem::remove(folder / "wide.h5");
  return true;
}

bool makeLong(const std::string& path, double hours) {
  const record::SessionHeader h = header(2, 25600.0, 256);
  auto writer = record::SessionWriter::create(path, h);
  if (!writer) return false;
  StepRecord step = noise(h);
  const auto steps = static_cast<std::uint64_t>(hours * 3600.0 * 100.0);
  for (std::uint64_t i = 0; i < steps; ++i) {
    advance(step, i);
    if (!(*writer)->add(step.input, step.output)) return false;
  }
  return (*writer)->close().ok();
}

void forget(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY);
  if (file < 0) return;
  (void)fdatasync(file);
  (void)posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
  close(file);
}

double milliseconds(const std::function<bool()>& work) {
  const double began = seconds(CLOCK_MONOTONIC);
  if (!work()) std::printf("  failed\n");
  return (seconds(CLOCK_MONOTONIC) - began) * 1e3;
}

bool goingAnywhere(const record::TempFolder& folder, double hours) {
  const std::string path = folder / "long.h5";
  if (!makeLong(path, hours)) return false;
  std::printf("%.1f h of 2 x 25.6 kHz: %.2f GB\n", hours, static_cast<double>(std::filesystem::file_size(path)) * 1e-9);
  std::mt19937 random(1);
  std::vector<double> times;
  for (int round = 0; round < 20; ++round) {
    forget(path);
    const double at = std::uniform_real_distribution<double>(0.0, hours * 3600.0 - 10.0)(random);
    const double span =
        std::min(hours * 3600.0 - at, std::pow(10.0, std::uniform_real_distribution<double>(-1.0, 4.5)(random)));
    times.push_back(milliseconds([&] {
      auto overview = record::SessionOverview::open(path);
      auto reader = record::openRecording(path);
      if (!overview || !reader) return false;
      const Instant from = (*overview)->begin() + toDuration(Seconds(at));
      SampleBlock block;
      block.allocate(2, 256);
      return (*overview)->overview(0, (*overview)->begin(), (*overview)->end(), 1600).ok() &&
             (*overview)->overview(0, from, from + toDuration(Seconds(span)), 1600).ok() &&
             (*reader)->seek(from).ok() && (*reader)->read(block).ok();
    }));
  }
  forget(path);
  const double opening = milliseconds([&] {
    return evaluate::glimpseOf(path).ok() && record::readMarkers(path).ok() && app::buildReplayRig(path).ok();
  });
  std::printf("opening it on the Sessions page: %.0f ms (asked: 300)\n", opening);
  std::sort(times.begin(), times.end());
  std::printf(
      "opening it, drawing all of it and a span anywhere, reading there: %.0f ms median, %.0f ms worst (asked: 300)\n",
      times[times.size() / 2], times.back());
  std::filesystem::remove(path);
  return true;
}

bool analysing(const record::TempFolder& folder, double length) {
  const std::string path = folder / "cut.h5";
  auto made = app::buildScenarioRig(test::demoCut(length),
                                    {.methods = app::Methods{}, .params = {}, .live = false, .watched = false});
  if (!made || !made->rig->recordTo(path, "")) return false;
  made->rig->runToEnd({});
  if (!made->rig->recorder()->finish()) return false;
  app::RecordingOptions options;
  options.methods.detectors.clear();
  for (const auto& row : detect::detectorTable()) options.methods.detectors.emplace_back(row.id);
  auto built = app::buildRecordingRig(path, options);
  if (!built) return false;
  const double began = seconds(CLOCK_THREAD_CPUTIME_ID);
  built->rig->runToEnd({});
  const double cpu = seconds(CLOCK_THREAD_CPUTIME_ID) - began;
  std::printf(
      "an hour of 2 x 25.6 kHz, most of it chatter, by %zu detectors: %.0f s of one core (asked: 60), %.0f times real "
      "time, %.0f ns a sample and channel\n",
      options.methods.detectors.size(), cpu * 3600.0 / length, length / cpu, cpu * 1e9 / (length * 2.0 * 25600.0));
  return true;
}

}  // namespace
}  // namespace stillcut::bench

int main(int argc, char** argv) {
  using namespace stillcut;
  const double hours = argc > 1 ? std::atof(argv[1]) : 10.0;
  const record::TempFolder folder;
  if (hours <= 0.0) return bench::analysing(folder, 300.0) ? 0 : 1;
  const bool done = bench::writing(folder, false) && bench::writing(folder, true) && bench::analysing(folder, 30.0) &&
                    bench::goingAnywhere(folder, hours);
  return done ? 0 : 1;
}
