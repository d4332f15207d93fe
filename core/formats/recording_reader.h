// RecordingReader: a recording on disk, read front to back as blocks. One interface for sound files, text files and
// Stillcut's own session files; openRecording() (open_recording.h) finds the right one by content.
// Thread: one at a time, not real-time (file access). How columns are chosen: resources/manual/recordings.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/model/channel.h"
#include "core/model/cut_setup.h"
#include "core/model/sample_block.h"
#include "core/model/step_record.h"

namespace stillcut::record {

// What the person who opens a recording knows better than the file.
struct ReadOptions {
  std::optional<Hertz> rate;               // text without a usable time column; ignored where the file has its own
  std::optional<double> secondsPerTime;    // of times in numbers, instead of the unit that the file says or does not
  std::optional<SensorQuantity> quantity;  // of every channel
  std::vector<int> channels;               // which ones, counted from 0; empty: all
  std::optional<double> scale;             // SI units per unit of the file, instead of what its header says
};

struct RecordedChannel {
  ChannelInfo info;            // info.scale turns the file's numbers into SI
  std::string unit;            // as the file spells it; empty: not said
  bool quantityKnown = false;  // false: info.quantity is a guess
};

struct RecordingFormat {
  std::string kind;  // "WAV", "text", "Stillcut session"
  Hertz rate{};
  std::int64_t frames = 0;  // per channel, without missing ones
  std::int64_t blocks = 0;  // recorded blocks, 0: not recorded in blocks
  int blockFrames = 0;      // largest recorded block, 0: not recorded in blocks
  std::vector<RecordedChannel> channels;
  std::vector<std::string> skipped;  // columns that are no channel: "CI Value"
  std::vector<Message> skippedWhy;   // of each of them; fewer: not told of the last
  std::vector<Message> notes;        // what was damaged or missing in the file, and was read all the same
  std::optional<CutSetup> setup;     // sessions only
  std::string configuration;         // sessions only: the whole text in force
  std::string programVersion;        // sessions only
  std::string operatorName, job;     // sessions only; empty: not told
  std::int64_t started_ns = 0;       // of the first sample, ns since 1970 UTC; 0: not told
  bool simulated = false;            // sessions only
  bool closedCleanly = true;         // sessions only: false after a crash, or while still being written
  Seconds length() const { return Seconds(rate.value > 0.0 ? static_cast<double>(frames) / rate.value : 0.0); }
};

class RecordingReader {
 public:
  virtual ~RecordingReader() = default;
  virtual const RecordingFormat& format() const = 0;  // known from the opening on, the same to the end
  // Fills `block` (allocated for the channels of format()) with the next frames, at most its capacity, and sets every
  // other field. Sessions come back in their recorded blocks, which needs a capacity of format().blockFrames; others in
  // full blocks, cut short only before missing samples and at the end. Time counts from 0 at the first sample unless
  // recorded. The last block carries kBlockEnd. False: nothing is left. Error: one line, nothing more can be read.
  virtual Result<bool> read(SampleBlock& block) = 0;
  // The next read() gives the block that holds `time`, or the first after it, as if all before had been read. False:
  // this recording can only be read from its beginning.
  virtual Result<bool> seek(Instant /*time*/) { return false; }
  // The complete step recorded with the block last read (machine state, operator inputs, and what the program made of
  // it); null where the recording has none. Valid until the next read().
  virtual const StepRecord* recordedStep() const { return nullptr; }
};

// A column that is no channel, and why.
void leaveOut(RecordingFormat& format, std::string name, Message why);

// Keeps the wanted channels, in the wanted order; an error names the one that does not exist.
Result<std::vector<RecordedChannel>> keepChannels(const std::vector<RecordedChannel>& all,
                                                  const std::vector<int>& wanted, const std::string& where);
// Applies quantity and scale of the options to every channel.
Status applyOptions(std::vector<RecordedChannel>& channels, const ReadOptions& options);

}  // namespace stillcut::record
