#include "tests/bench/real_cuts.h"

#include <fstream>
#include <sstream>

namespace stillcut::bench {
namespace {

using std::filesystem::path;

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

}  // namespace

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
  std::erase_if(all, [](const RealCut& cut) { return !std::filesystem::exists(cut.file); });
  for (RealCut& cut : all) cut.segments = segmentsOf(cut.file);
  return all;
}

}  // namespace stillcut::bench
