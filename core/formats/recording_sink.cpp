#include "core/formats/recording_sink.h"

#include <array>
#include <filesystem>
#include <string_view>

namespace stillcut::record {
namespace {

struct SinkKind {
  std::string_view suffix;
  bool needsLook;
  GapStyle gaps;
  Result<std::unique_ptr<RecordingSink>> (*create)(const std::string& path, const ExportPlan& plan);
};

constexpr std::array<SinkKind, 8> kSinks{{
    {".wav", false, GapStyle::Listed, createSoundSink},
    {".flac", true, GapStyle::Listed, createSoundSink},
    {".csv", false, GapStyle::Times, createCsvSink},
    {".mat", true, GapStyle::NotANumber, createMatSink},
    {".uff", true, GapStyle::Listed, createUffSink},
    {".unv", true, GapStyle::Listed, createUffSink},
    {".h5", true, GapStyle::NotANumber, createHdf5Sink},
    {".hdf5", true, GapStyle::NotANumber, createHdf5Sink},
}};

const SinkKind* kindOf(const std::string& path) {
  const std::string suffix = std::filesystem::path(path).extension().string();
  for (const SinkKind& kind : kSinks) {
    if (kind.suffix == suffix) return &kind;
  }
  return nullptr;
}

}  // namespace

Result<std::unique_ptr<RecordingSink>> createSink(const std::string& path, const ExportPlan& plan) {
  const SinkKind* kind = kindOf(path);
  if (kind != nullptr) return kind->create(path, plan);
  const std::string suffix = std::filesystem::path(path).extension().string();
  if (suffix == ".pdf" || suffix == ".png" || suffix == ".svg") {
    return Error{path, message("cannot be written here"),
                 message("stillcut --report IN OUT makes reports and pictures")};
  }
  std::string all;
  for (const SinkKind& known : kSinks) all += (all.empty() ? "" : " ") + std::string(known.suffix);
  return Error{path, message("cannot be written"), message("the suffix must be one of %1", all)};
}

bool sinkNeedsLook(const std::string& path) {
  const SinkKind* kind = kindOf(path);
  return kind != nullptr && kind->needsLook;
}

GapStyle sinkGapStyle(const std::string& path) {
  const SinkKind* kind = kindOf(path);
  return kind != nullptr ? kind->gaps : GapStyle::Times;
}

// A number that nobody has calibrated gets no unit.
std::string exportUnit(const RecordedChannel& channel) {
  const bool calibrated = channel.quantityKnown || channel.info.scale != 1.0;
  return calibrated ? std::string(siUnit(channel.info.quantity)) : "";
}
std::string plainUnit(const RecordedChannel& channel) {
  const std::string unit = exportUnit(channel);
  return unit == siUnit(SensorQuantity::Acceleration) ? "m/s^2" : unit;
}

}  // namespace stillcut::record
