#include "tests/support/recording_runner.h"

#include <sndfile.h>

#include <algorithm>
#include <numeric>

#include "core/detect/registry.h"
#include "core/session/open_recording.h"

namespace stillcut::detect::testing {

Recording readWav(const std::filesystem::path& path) {
  Recording r;
  SF_INFO info{};
  SNDFILE* file = sf_open(path.c_str(), SFM_READ, &info);
  if (file == nullptr) {
    ADD_FAILURE() << "cannot read " << path << ": " << sf_strerror(nullptr);
    return r;
  }
  std::vector<float> all(static_cast<std::size_t>(info.frames) * static_cast<std::size_t>(info.channels));
  const auto frames = static_cast<std::size_t>(sf_readf_float(file, all.data(), info.frames));
  sf_close(file);
  r.rate = info.samplerate;
  const auto count = static_cast<std::size_t>(info.channels);
  r.channels.assign(count, std::vector<float>(frames));
  for (std::size_t f = 0; f < frames; ++f) {
    for (std::size_t c = 0; c < count; ++c) r.channels[c][f] = all[f * count + c];
  }
  return r;
}

Recording readTable(const std::filesystem::path& path) {
  Recording r;
  auto reader = record::openRecording(path.string());
  if (!reader) {
    ADD_FAILURE() << reader.error().line();
    return r;
  }
  const record::RecordingFormat& format = (*reader)->format();
  r.rate = format.rate.value;
  r.channels.resize(format.channels.size());
  SampleBlock block;
  block.allocate(static_cast<int>(r.channels.size()), 256);
  for (Result<bool> more = (*reader)->read(block); more && *more; more = (*reader)->read(block)) {
    for (std::size_t c = 0; c < r.channels.size(); ++c) {
      for (const float x : std::as_const(block).channel(static_cast<int>(c))) {
        r.channels[c].push_back(static_cast<float>(format.channels[c].info.scale * static_cast<double>(x)));
      }
    }
  }
  return r;
}

namespace {

std::vector<int> chosen(const Recording& recording, const RunOptions& options) {
  if (!options.channels.empty()) return options.channels;
  std::vector<int> all(recording.channels.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

CutSetup setupFor(const Recording& recording, const RunOptions& options) {
  CutSetup setup;
  setup.teeth = options.teeth;
  setup.nominalSpeed = Rpm(options.rpm);
  setup.nominalFeed = MetresPerSecond(0.01);
  setup.rate = Hertz(recording.rate);
  setup.blockFrames = options.blockFrames;
  for (std::size_t c = 0; c < chosen(recording, options).size(); ++c) {
    setup.channels.push_back({"ch" + std::to_string(c), options.quantity, 1.0, ""});
  }
  return setup;
}

RunResult run(const Recording& recording, const RunOptions& options, Detector& detector) {
  const std::vector<int> use = chosen(recording, options);
  const CutSetup setup = setupFor(recording, options);
  config::ParamCatalog catalog;
  catalog.add(conditionerParams());
  for (const DetectorRow& row : detectorTable()) catalog.add(row.params());
  config::ParamSet params;
  for (const auto& [key, value] : options.params) {
    const Status set = params.set(*catalog.find(key), value, "test");
    EXPECT_TRUE(set.ok());
  }
  Conditioner conditioner;
  conditioner.prepare(setup, params);
  detector.prepare(setup, params);
  SampleBlock block;
  block.allocate(static_cast<int>(use.size()), options.blockFrames);
  block.rate = setup.rate;
  RunResult result;
  const std::size_t total = recording.frames();
  for (std::size_t from = 0; from < total; from += static_cast<std::size_t>(options.blockFrames)) {
    block.frames = static_cast<int>(std::min<std::size_t>(total - from, static_cast<std::size_t>(options.blockFrames)));
    block.firstSample = Instant{} + toDuration(Seconds(static_cast<double>(from) / recording.rate));
    for (std::size_t c = 0; c < use.size(); ++c) {
      const auto& source = recording.channels[static_cast<std::size_t>(use[c])];
      std::copy_n(source.begin() + static_cast<std::ptrdiff_t>(from), block.frames,
                  block.channel(static_cast<int>(c)).begin());
    }
    const MachineState machine = options.machine ? options.machine(sinceEpoch(block.end()).value) : MachineState{};
    const ConditionedBlock& conditioned = conditioner.process(block, machine);
    const Verdict v = detector.process(conditioned);
    if (options.onBlock) options.onBlock(conditioned, v);
    if (v.alarming()) {
      if (result.firstAlarm < 0.0) result.firstAlarm = sinceEpoch(v.time).value;
      result.alarmTime += block.frames / recording.rate;
    }
    result.verdicts.push_back(v);
    ++block.sequence;
  }
  return result;
}

RunResult run(const Recording& recording, const RunOptions& options, const std::string& detector) {
  auto made = makeDetector(detector);
  if (!made) {
    ADD_FAILURE() << made.error().line();
    return {};
  }
  return run(recording, options, **made);
}

const Verdict& RunResult::at(double t) const {
  const auto it =
      std::find_if(verdicts.begin(), verdicts.end(), [t](const Verdict& v) { return sinceEpoch(v.time).value >= t; });
  return it == verdicts.end() ? verdicts.back() : *it;
}

double RunResult::alarmTimeIn(double t0, double t1) const {
  double sum = 0.0;
  double before = 0.0;
  for (const Verdict& v : verdicts) {
    const double t = sinceEpoch(v.time).value;
    if (t > t0 && t <= t1 && v.alarming()) sum += t - before;
    before = t;
  }
  return sum;
}

double RunResult::firstAlarmAfter(double t0) const {
  for (const Verdict& v : verdicts) {
    const double t = sinceEpoch(v.time).value;
    if (t >= t0 && v.alarming()) return t;
  }
  return -1.0;
}

}  // namespace stillcut::detect::testing
