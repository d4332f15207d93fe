#include "tests/support/real_cuts.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "core/detect/registry.h"
#include "core/sensing/conditioner.h"
#include "core/session/open_recording.h"

namespace stillcut::bench {
namespace {

using std::filesystem::path;

constexpr double kBlockSeconds = 0.005;

// file,t0_s,t1_s,label,...: the first four cells never hold a comma.
std::vector<TruthSegment> segmentsOf(const path& file) {
  std::vector<TruthSegment> found;
  std::ifstream truth(file.parent_path() / "TRUTH.csv");
  std::string line;
  while (std::getline(truth, line)) {
    std::istringstream cells(line);
    std::string name;
    std::string from;
    std::string to;
    TruthSegment segment;
    std::getline(cells, name, ',');
    std::getline(cells, from, ',');
    std::getline(cells, to, ',');
    std::getline(cells, segment.label, ',');
    if (name != file.filename().string()) continue;
    segment.from = std::stod(from);
    segment.to = std::stod(to);
    found.push_back(segment);
  }
  return found;
}

std::vector<Tally> tallies(const std::vector<std::string>& wanted, const CutSetup& setup) {
  config::ParamCatalog catalog;
  catalog.add(detect::conditionerParams());
  std::vector<Tally> all;
  for (const detect::DetectorRow& row : detect::detectorTable()) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), row.id) == wanted.end()) continue;
    Tally t;
    t.detector = row.make();
    t.id = row.id;
    t.detector->prepare(setup, {});
    all.push_back(std::move(t));
  }
  return all;
}

void count(Tally& t, const Verdict& v, const RealCut& cut, double time, double length) {
  const TruthSegment* inside = nullptr;
  for (const TruthSegment& s : cut.segments) {
    if (time >= s.from && time < s.to) inside = &s;
  }
  if (!v.valid) t.invalid += length;
  if (inside != nullptr && inside->chatter()) {
    if (!v.alarming()) return;
    if (t.delay < 0.0) t.delay = time - inside->from;
    t.alarm += length;
    if (v.state == CutState::Chatter) t.chatter += length;
    return;
  }
  // What is not labelled beside a chatter segment is neither: it begins and ends somewhere there.
  const bool beside = std::any_of(cut.segments.begin(), cut.segments.end(), [&](const TruthSegment& s) {
    return s.chatter() && time > s.from - 0.5 && time < s.to + 0.6;
  });
  if (!v.alarming() || (inside == nullptr && beside)) return;
  t.falseAlarm += length;
  const bool promised = inside == nullptr ? cut.segments.empty() : inside->silent();
  if (promised) t.falseInSegment += length;
  if (t.firstFalse < 0.0) t.firstFalse = time;
}

std::vector<RealCut> thoseThatAreThere(std::vector<RealCut> all) {
  std::erase_if(all, [](const RealCut& cut) { return !std::filesystem::exists(cut.file); });
  for (RealCut& cut : all) cut.segments = segmentsOf(cut.file);
  return all;
}

}  // namespace

double chatterLength(const RealCut& cut) {
  double sum = 0.0;
  for (const TruthSegment& s : cut.segments) sum += s.chatter() ? s.to - s.from : 0.0;
  return sum;
}

Result<std::vector<Tally>> judgeRealCut(const RealCut& cut, const std::vector<int>& channels, double error,
                                        const std::vector<std::string>& wanted, double begin,
                                        const std::function<void(const detect::ConditionedBlock&)>& observe) {
  record::ReadOptions options;
  options.quantity = cut.quantity;
  options.channels = channels;
  if (cut.rate > 0.0) options.rate = Hertz(cut.rate);
  auto reader = record::openRecording(cut.file.string(), options);
  if (!reader) return reader.error();
  const record::RecordingFormat& format = (*reader)->format();
  CutSetup setup;
  setup.teeth = cut.teeth;
  setup.nominalSpeed = Rpm(error <= -1.0 ? 0.0 : cut.rpm * (1.0 + error));
  setup.rate = format.rate;
  setup.blockFrames = std::max(1, static_cast<int>(format.rate.value * kBlockSeconds));
  for (const record::RecordedChannel& c : format.channels) setup.channels.push_back(c.info);
  detect::Conditioner conditioner;
  conditioner.prepare(setup, {});
  std::vector<Tally> all = tallies(wanted, setup);
  SampleBlock block;
  block.allocate(static_cast<int>(setup.channels.size()), setup.blockFrames);
  for (;;) {
    const Result<bool> more = (*reader)->read(block);
    if (!more || !*more) break;
    const double time = sinceEpoch(block.end()).value;
    if (time < begin) continue;
    const detect::ConditionedBlock& conditioned = conditioner.process(block, {});
    if (observe) observe(conditioned);
    for (Tally& t : all) count(t, t.detector->process(conditioned), cut, time, block.frames / setup.rate.value);
  }
  return all;
}

std::vector<RealCut> realCuts(const path& recordings) {
  const path mill = recordings / "hurco_end_mill";
  const path face = recordings / "face_mill_audio";
  const path force = recordings / "slot_force";
  const path lmas = recordings / "lmas_milling_audio";
  const SensorQuantity sound = SensorQuantity::Sound;
  std::vector<RealCut> all{
      {mill / "EBI_F20IN_T100_D0p125IN_4000RPM.csv", 4, 4000.0, SensorQuantity::Acceleration, 0.0, {}, {}},
      {mill / "EBI_F20IN_T75_D0p125IN_4000RPM.csv", 4, 4000.0, SensorQuantity::Acceleration, 0.0, {}, {}},
      {mill / "EBI_T50_0p25IN_6900RPM.csv", 4, 6900.0, SensorQuantity::Acceleration, 0.0, {}, {}},
      {mill / "EBI_T25_0p25IN_6900RPM.csv", 4, 6900.0, SensorQuantity::Acceleration, 0.0, {}, {}},
      {mill / "EBI_T100_0p375IN_7000RPMto6000RPM.csv", 3, 7000.0, SensorQuantity::Acceleration, 0.0, {}, {}},
      {face / "Chatter.wav", 6, 1655.0, sound, 0.0, {0}, {}},  // both channels are the same
      {face / "Stable.wav", 6, 4489.0, sound, 0.0, {0}, {}},
      {face / "Idle Sound.wav", 6, 1655.0, sound, 0.0, {0}, {}},
      {lmas / "audio_T2503", 0, 3120.0, sound, 8000.0, {}, {}},
      {lmas / "accel_T2503", 0, 3120.0, SensorQuantity::Acceleration, 1000.0, {}, {}},
      {force / "6-n6000f300ap3ae25.csv", 2, 6000.0, SensorQuantity::Force, 0.0, {}, {}},
      {force / "6-n6000f900ap3ae25.csv", 2, 6000.0, SensorQuantity::Force, 0.0, {}, {}},
      {recordings / "turning_force_lvm" / "f416_a100.lvm", 0, 1060.0, SensorQuantity::Force, 0.0, {}, {}},
  };
  return thoseThatAreThere(std::move(all));
}

std::vector<RealCut> laterCuts(const path& recordings) {
  const path slots = recordings / "chiron_slot_audio";
  const path mill = recordings / "hurco_end_mill_2";
  const path ubc = recordings / "ubc_milling_audio";
  const SensorQuantity sound = SensorQuantity::Sound;
  return thoseThatAreThere({
      {slots / "2_10100.wav", 2, 10100.0, sound, 0.0, {}, {}},
      {slots / "2_5600.wav", 2, 5600.0, sound, 0.0, {}, {}},
      {slots / "2_7100.wav", 2, 7100.0, sound, 0.0, {}, {}},
      {slots / "2_9300t.wav", 2, 9300.0, sound, 0.0, {}, {}},
      {slots / "3_400.wav", 2, 10100.0, sound, 0.0, {}, {}},
      {slots / "3_550.wav", 2, 10100.0, sound, 0.0, {}, {}},
      {slots / "4_325.wav", 2, 9100.0, sound, 0.0, {}, {}},
      {slots / "4_450.wav", 2, 9100.0, sound, 0.0, {}, {}},
      {mill / "EBI_T100_0p25IN_6900RPM.csv", 4, 6900.0, SensorQuantity::Acceleration, 0.0, {}, {}},
      {mill / "SKF_UltiFlank_40pct.csv", 3, 7000.0, SensorQuantity::Acceleration, 0.0, {}, {}},
      {ubc / "combined_chatter6567.mp3", 2, 6462.0, sound, 0.0, {}, {}},
  });
}

}  // namespace stillcut::bench
