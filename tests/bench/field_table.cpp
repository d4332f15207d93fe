// bench_field [--from SEED] [--count N] [--kind TEXT] [--each] [--trace]: the default detector on cuts as users bring
// them, with speeds, frequencies and noise drawn at random: the kinds of tests/support/field_cases, other ones each
// time. Prints a line per kind: how many of them are right, and how many alarm falsely. --each: also a line per case
// that falls short.
// --trace: also a line per change of what the detector says.
// Detection is worked on with seeds below 1000; those from 1000 on are kept to judge it by.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "tests/support/field_cases/alarm_course.h"
#include "tests/support/field_cases/axis_drive.h"
#include "tests/support/field_cases/mains_hum.h"
#include "tests/support/field_cases/memory_reader.h"
#include "tests/support/field_cases/overloaded_sensor.h"
#include "tests/support/field_cases/second_channel.h"
#include "tests/support/field_cases/slot_chatter.h"

namespace stillcut::bench {
namespace {

using field::ChatterBegin;
using field::FieldCase;
using field::SecondChannel;

struct SeriesWords {
  explicit SeriesWords(const detect::SeriesLook& l) {
    std::snprintf(text, sizeof text, "%.2f Hz, certainty %.2f, off %.2f, all %.2f at %.1f Hz %+.3f x%d%s%s%s",
                  l.spindle.value, l.certainty, l.free.share, l.joint, l.free.line.value, l.free.offset, l.free.members,
                  l.whole ? "" : " part", l.steady ? "" : " moves", l.teethHeard ? " teeth" : "");
  }
  char text[160];
};

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed), seed_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }
  double ratio(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  template <class T>
  T oneOf(std::initializer_list<T> of) {
    return of.begin()[std::uniform_int_distribution<std::size_t>(0, of.size() - 1)(random_)];
  }
  std::uint64_t seed() const { return seed_; }

 private:
  std::mt19937 random_;
  unsigned seed_;
};

struct Made {
  FieldCase cut;
  std::string what;
};

std::string words(const char* form, double a, double b, double c) {
  char text[96];
  std::snprintf(text, sizeof text, form, a, b, c);
  return text;
}

// Chatter at least 0.05 orders off the spindle's harmonics, as the nearest of the fixed cases.
Made slot(Draw& draw, ChatterBegin begin) {
  field::SlotChatter s{.speed = draw.ratio(2500.0, 20000.0), .begin = begin, .seed = draw.seed()};
  const double nearest = std::round(draw.ratio(800.0, 2400.0) / (s.speed / 60.0));
  s.order = std::max(2.0, nearest) + draw.oneOf({-1.0, 1.0}) * draw.between(0.05, 0.5);
  if (begin == ChatterBegin::Never) s.length = 13.0;
  return {slotChatter(s), words("%.0f rpm, order %.3f (%.1f Hz)", s.speed, s.order, s.order * s.speed / 60.0)};
}

field::FourFluteSound fourFlutes(Draw& draw) {
  field::FourFluteSound s{.speed = draw.ratio(2500.0, 16000.0), .seed = draw.seed()};
  const double spindle = s.speed / 60.0;
  s.chatter = (std::round(draw.ratio(500.0, 3000.0) / spindle) + draw.between(-0.45, -0.08)) * spindle;
  return s;
}

std::string told(const field::FourFluteSound& s) {
  return words("%.0f rpm, %.1f Hz, order %.3f", s.speed, s.chatter, s.chatter / (s.speed / 60.0));
}

struct Kind {
  std::string name;
  std::function<Made(Draw&)> make;
};

std::vector<Kind> kinds() {
  const auto second = [](SecondChannel which) {
    return [which](Draw& d) {
      const auto s = fourFlutes(d);
      return Made{besideSecondChannel(s, which), told(s)};
    };
  };
  return {
      {"slot chatter from the entry", [](Draw& d) { return slot(d, ChatterBegin::Entry); }},
      {"slot chatter after 3 s", [](Draw& d) { return slot(d, ChatterBegin::Late); }},
      {"slot stable", [](Draw& d) { return slot(d, ChatterBegin::Never); }},
      {"four flutes",
       [](Draw& d) {
         const auto s = fourFlutes(d);
         return Made{fourFluteSound(s), told(s)};
       }},
      {"second channel silent", second(SecondChannel::Silent)},
      {"second channel dies", second(SecondChannel::Dies)},
      {"second channel hums", second(SecondChannel::Hums)},
      {"overloaded",
       [](Draw& d) {
         const auto s = fourFlutes(d);
         return Made{overloadedSensor(s, d.between(3.0, 8.0)), told(s)};
       }},
      {"mains hum",
       [](Draw& d) {
         field::MainsHum s{.hum = d.between(0.05, 0.6), .mains = d.oneOf({50.0, 60.0}), .seed = d.seed()};
         s.speed = d.ratio(2500.0, 12000.0);
         const double spindle = s.speed / 60.0;
         s.chatter = (std::round(d.ratio(400.0, 1500.0) / spindle) + d.between(-0.45, -0.08)) * spindle;
         return Made{mainsHum(s), words("%.0f rpm, %.1f Hz, hum %.2f", s.speed, s.chatter, s.hum) +
                                      (s.mains > 55.0 ? " of 60 Hz" : " of 50 Hz")};
       }},
      {"axis drive",
       [](Draw& d) {
         field::AxisDrive s{.amplitude = d.ratio(0.1, 1.5), .seed = d.seed()};
         s.highest = d.between(300.0, 1500.0);
         s.move = d.between(1.0, 4.0);
         s.speed = d.ratio(3000.0, 14000.0);
         return Made{axisDrive(s), words("%.0f rpm, to %.0f Hz, amplitude %.2f", s.speed, s.highest, s.amplitude)};
       }},
  };
}

void trace(const Verdict& v, const detect::ConditionedBlock& block) {
  static Verdict last;
  if (v.state == last.state && v.phase == last.phase && v.valid == last.valid && v.reason.code == last.reason.code)
    return;
  last = v;
  const SeriesWords words(block.series);
  std::printf("    %7.3f s %-6s %-7s%s spindle %.2f Hz, line %.1f Hz, severity %.2f, %s; series: %s\n",
              sinceEpoch(v.time).value, std::string(name(v.phase)).c_str(), std::string(name(v.state)).c_str(),
              v.valid ? "" : " not judged", block.spindle.value, v.frequency.value, v.severity.value,
              sentence(v.reason).c_str(), words.text);
}

void run(const Kind& kind, unsigned from, unsigned count, bool each, bool traced) {
  unsigned right = 0;
  unsigned falsely = 0;
  for (unsigned seed = from; seed < from + count; ++seed) {
    Draw draw(seed);
    const Made made = kind.make(draw);
    field::MemoryReader reader(made.cut.signal);
    const auto course =
        alarmCourse(reader, made.cut.teeth, made.cut.speed, traced ? field::Observe(trace) : field::Observe());
    const std::string found = shortfall(made.cut.truth, course);
    right += found.empty();
    const double begin = made.cut.truth.chatter ? made.cut.truth.begin : 1e9;
    falsely += !course.alarms.empty() && course.alarms.front().from < begin;
    if (each && !found.empty()) std::printf("  %u: %s: %s\n", seed, made.what.c_str(), found.c_str());
  }
  std::printf("| %-28s | %u of %u | %u |\n", kind.name.c_str(), right, count, falsely);
  std::fflush(stdout);
}

}  // namespace
}  // namespace stillcut::bench

int main(int argc, char** argv) {
  unsigned from = 1;
  unsigned count = 20;
  std::string only;
  bool each = false;
  bool traced = false;
  for (int i = 1; i < argc; ++i) {
    const auto value = [&](const char* name) {
      return !std::strcmp(argv[i], name) && i + 1 < argc ? argv[++i] : nullptr;
    };
    if (!std::strcmp(argv[i], "--each")) {
      each = true;
    } else if (!std::strcmp(argv[i], "--trace")) {
      traced = each = true;
    } else if (const char* first = value("--from")) {
      from = static_cast<unsigned>(std::atoi(first));
    } else if (const char* many = value("--count")) {
      count = static_cast<unsigned>(std::atoi(many));
    } else if (const char* text = value("--kind")) {
      only = text;
    } else {
      std::fprintf(stderr, "bench_field: %s is no option of it: --from SEED --count N --kind TEXT --each --trace\n",
                   argv[i]);
      return 2;
    }
  }
  std::printf("| kind | right | false alarm |\n|---|---|---|\n");
  for (const auto& kind : stillcut::bench::kinds()) {
    if (kind.name.find(only) != std::string::npos) stillcut::bench::run(kind, from, count, each, traced);
  }
  return 0;
}
