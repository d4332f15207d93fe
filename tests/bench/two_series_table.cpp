// bench_two_series: what the two line series of a cut (core/spindle/two_series.h) say of every labelled segment of the
// shared real recordings, told speed exact, 2 % high, 2 % low: part of the line power off the spindle's orders, and how
// far the speed believed in is from the labelled one.
#include <algorithm>
#include <cstdio>
#include <map>
#include <vector>

#include "core/dsp/fft.h"
#include "core/dsp/spectrum.h"
#include "core/session/open_recording.h"
#include "core/spindle/speed_belief.h"
#include "tests/support/real_cuts.h"

namespace stillcut::bench {
namespace {

constexpr double kTurns = 16.0, kShortest = 0.4, kLongest = 2.0;

struct Signal {
  double rate = 0.0;
  std::vector<std::vector<double>> channels;
};

Signal load(const RealCut& cut) {
  Signal all;
  record::ReadOptions options;
  options.quantity = cut.quantity;
  if (cut.rate > 0.0) options.rate = Hertz(cut.rate);
  auto reader = record::openRecording(cut.file.string(), options);
  if (!reader) return all;
  const auto& format = (*reader)->format();
  all.rate = format.rate.value;
  all.channels.resize(format.channels.size());
  SampleBlock block;
  block.allocate(static_cast<int>(format.channels.size()), 4096);
  for (;;) {
    const Result<bool> more = (*reader)->read(block);
    if (!more || !*more) break;
    for (std::size_t c = 0; c < all.channels.size(); ++c) {
      for (const float x : block.channel(static_cast<int>(c))) all.channels[c].push_back(x);
    }
  }
  return all;
}

double quantile(std::vector<double> v, double q) {
  if (v.empty()) return 0.0;
  std::sort(v.begin(), v.end());
  return v[static_cast<std::size_t>(q * static_cast<double>(v.size() - 1))];
}

void judge(const RealCut& cut, const Signal& signal, double error, bool each) {
  const double told = cut.rpm / 60.0 * (1.0 + error);
  const double seconds = std::clamp(kTurns / told, kShortest, kLongest);
  const int window = dsp::fastFftSize(static_cast<int>(seconds * signal.rate));
  dsp::Spectrum spectrum;
  spectrum.prepare(window, Hertz(signal.rate), dsp::WindowKind::Hann);
  std::vector<double> powers(static_cast<std::size_t>(spectrum.bins()));
  std::vector<detect::LineList> lists(signal.channels.size());
  for (auto& l : lists) l.prepare(spectrum.bins(), Hertz(spectrum.binWidth()));
  detect::TwoSeries series;
  detect::SpeedBelief belief;
  belief.prepare(0.036);
  belief.begin(0.01);
  const auto hop = static_cast<std::size_t>(window / 4);
  struct Rows {
    std::vector<double> share, off, certain, members, least;
  };
  std::map<const TruthSegment*, Rows> rows;
  const Hertz low(0.5 * told), high(std::min(6000.0, 0.45 * signal.rate));
  bool was = false;
  for (std::size_t end = static_cast<std::size_t>(window); end <= signal.channels[0].size(); end += hop) {
    series.begin(Hertz(0.5 * spectrum.binWidth()));
    for (std::size_t c = 0; c < lists.size(); ++c) {
      spectrum.transform(std::span(signal.channels[c])
                             .subspan(end - static_cast<std::size_t>(window), static_cast<std::size_t>(window)));
      spectrum.powers(powers);
      lists[c].find(powers, low, high);
      series.add(lists[c].lines());
    }
    bool cutting = cut.segments.empty();
    for (const auto& s : cut.segments) {
      const bool air = s.label == "idle" || s.label.starts_with("spindle");
      const double at = static_cast<double>(end) / signal.rate;
      if (!air && at >= s.from && at <= s.to) cutting = true;
    }
    if (cutting && !was) belief.begin(0.01);
    was = cutting;
    belief.look(series, Hertz(told), Seconds(static_cast<double>(hop) / signal.rate));
    const Hertz spindle(told * belief.ratio());
    detect::FreeFamily worst;
    for (auto& l : lists) {
      const auto f = series.freeOf(l.lines(), spindle, belief.sd());
      if (f.share > worst.share) worst = f;
    }
    double least = 0.0;
    for (auto& l : lists) {
      double of = 1.0;
      for (std::size_t i = 0; i < belief.cells(); ++i) {
        if (belief.plausible(i))
          of = std::min(of, series.freeOf(l.lines(), Hertz(told * belief.ratioAt(i)), 1e-4).share);
      }
      least = std::max(least, of);
    }
    const double time = static_cast<double>(end) / signal.rate;
    const TruthSegment* inside = nullptr;
    for (const auto& s : cut.segments)
      if (time - 0.5 * seconds >= s.from && time <= s.to) inside = &s;
    if (each)
      std::printf(
          "%7.2f s %-10s share %.2f least %.2f %8.1f rpm sd %.4f certain %.2f other %8.1f  line %7.1f off %+.3f "
          "members %d lines %d\n",
          time, inside ? inside->label.c_str() : "", worst.share, least, spindle.value * 60, belief.sd(),
          belief.certainty(), told * 60 * belief.other(), worst.line.value, worst.offset, worst.members,
          series.lines());
    if (!inside && !cut.segments.empty()) continue;
    Rows& r = rows[inside];
    r.share.push_back(worst.share);
    r.off.push_back(100.0 * (spindle.value * 60.0 / cut.rpm - 1.0));
    r.certain.push_back(belief.certain());
    r.least.push_back(least);
    r.members.push_back(worst.members);
  }
  for (auto& [s, r] : rows) {
    std::printf(
        "%-36.36s %-12.12s %+2.0f %%  share %.2f %.2f %.2f %.2f %.2f  speed off %% %+.2f %+.2f %+.2f  certain %.2f  "
        "members %.0f %.0f  LEAST %.2f %.2f %.2f %.2f %.2f\n",
        cut.file.filename().c_str(), s ? s->label.c_str() : "all", 100 * error, quantile(r.share, 0),
        quantile(r.share, 0.1), quantile(r.share, 0.5), quantile(r.share, 0.9), quantile(r.share, 1),
        quantile(r.off, 0), quantile(r.off, 0.5), quantile(r.off, 1), quantile(r.certain, 0.5), quantile(r.members, .1),
        quantile(r.members, .5), quantile(r.least, 0), quantile(r.least, 0.1), quantile(r.least, 0.5),
        quantile(r.least, 0.9), quantile(r.least, 1));
  }
  std::fflush(stdout);
}

}  // namespace
}  // namespace stillcut::bench

int main(int argc, char** argv) {
  using namespace stillcut::bench;
  const std::string only = argc > 1 ? argv[1] : "";
  const std::filesystem::path recordings = std::filesystem::path(STILLCUT_SHARED_DIR) / "recordings";
  std::vector<RealCut> cuts = realCuts(recordings);
  for (const RealCut& later : laterCuts(recordings)) cuts.push_back(later);
  for (const RealCut& cut : cuts) {
    if (cut.file.string().find(only) == std::string::npos) continue;
    const Signal signal = load(cut);
    if (signal.channels.empty()) continue;
    for (const double error : {0.0, 0.02, -0.02}) judge(cut, signal, error, argc > 2);
  }
}
