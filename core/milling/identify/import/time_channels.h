// A whole recording of a tap test in memory: its channels with what the file says about each.
// Thread: any, set-up path. Memory: 8 bytes a sample and channel, at most kMostSamples of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/formats/recording_reader.h"
#include "core/milling/identify/axis.h"
#include "core/milling/identify/frf.h"

namespace stillcut::identify {

inline constexpr std::int64_t kMostSamples = 100'000'000;

struct TimeChannel {
  std::string name;
  std::string unit;                     // as the file spells it; empty: not said
  std::string sensitivity;              // "2.25 mV/N", where name or unit say it
  std::optional<double> toSi;           // where the file's reader knows the factor
  bool force = false;                   // said by quantity or name
  std::optional<FrfQuantity> response;  // said by quantity, unit or name: what its response over force would be
  Axis axis = Axis::Unknown;
  double sign = 1.0;  // -1: the channel counts against its axis
  std::vector<double> samples;
};

struct TimeChannels {
  double rate = 0.0;  // [Hz]
  std::vector<TimeChannel> channels;
  std::string source;
};

// Reads all of it. Error: what the reader says, samples that are missing, channels too long for a tap test.
Result<TimeChannels> readTimeChannels(record::RecordingReader& reader, const std::string& where);

}  // namespace stillcut::identify
