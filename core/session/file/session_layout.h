// Names and limits of session files that writer and reader share. Constants, any thread. See resources/manual/files.md.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

namespace stillcut::record {

inline constexpr const char* kSessionFormat = "stillcut-session";
// 1: a history of features, steps without their samples. Files without it are not.
inline constexpr const char* kFeaturesOnly = "features_only";
inline constexpr const char* kBlocksPath = "steps/blocks";
inline constexpr const char* kMachinePath = "steps/machine";
inline constexpr const char* kDecisionsPath = "steps/decisions";
inline constexpr const char* kInputsPath = "operator_inputs";
inline constexpr const char* kVerdictsPath = "verdicts";
inline constexpr const char* kCommandsPath = "commands";
inline constexpr const char* kEventsPath = "events";
inline constexpr const char* kSegmentsPath = "steps/segments";
inline constexpr const char* kMarkersPath = "markers";
inline constexpr const char* kTruthPath = "truth/values";
inline constexpr const char* kTruthSeriesPath = "truth/series";

inline constexpr int kMostChannels = 64;
inline constexpr int kMostBlockFrames = 1 << 20;
inline constexpr std::uint64_t kSampleChunk = 16384;  // frames in a chunk of a channel

inline std::string samplesPath(int channel) {
  char text[32];
  std::snprintf(text, sizeof text, "samples/%02d", channel);
  return text;
}

}  // namespace stillcut::record
