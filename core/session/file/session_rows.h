// One row of every table of a session file, flat, in the order of the file, and the way from and to the plain values of
// the model. What a field means is said there; units are part of the names in the file (session_rows.cpp).
// Plain values: any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/model/step_record.h"

namespace stillcut::record {

enum class FieldType : std::uint8_t { U8, U16, U32, I32, U64, I64, F64, Text };

struct RowField {
  const char* name;
  std::size_t offset;
  FieldType type;
  std::size_t count = 1;  // over 1: a small array; for Text its length in bytes
  bool later = false;     // added since the oldest version that is read: where a file lacks it, it is 0
};

struct ReasonRow {
  std::uint16_t code = 0;
  std::array<double, 4> n{};
};

struct BlockRow {
  std::uint64_t sequence = 0;
  std::int64_t firstSample = 0;
  double rate = 0.0;
  std::uint64_t lostFrames = 0;
  std::uint64_t offset = 0;  // of its first frame in the samples
  std::uint32_t source = 0;
  std::int32_t frames = 0;
  std::uint32_t flags = 0;
};

struct MachineRow {
  std::int64_t time = 0;
  std::uint8_t valid = 0, linkUp = 0, programRunning = 0, feedHold = 0, atSpeed = 0, overridesEnabled = 0,
               controlOurs = 0, block = 0;
  double programmedSpeed = 0, programmedFeed = 0, operatorSpeed = 0, operatorFeed = 0, speedOverride = 0,
         feedOverride = 0, actualSpeed = 0, actualFeed = 0;
  std::uint64_t endedEngagement = 0;
  std::int64_t commanded = 0, acknowledged = 0, overridesRead = 0, speedRead = 0, feedRead = 0, programRead = 0;
  double roundTrip = 0, effectDelay = 0;
};

struct DecisionRow {
  std::int64_t time = 0;
  std::uint8_t kind = 0, claimsSpeed = 0, claimsFeed = 0, authority = 0;
  std::int32_t inCharge = 0;
  double speed = 0, feed = 0;
  ReasonRow reason;
};

struct InputRow {
  std::uint64_t step = 0;
  std::uint8_t action = 0, authority = 0;
  std::uint32_t advice = 0, parameter = 0;
  double value = 0;
};

struct VerdictRow {
  std::uint64_t step = 0;
  std::int32_t detector = 0;
  std::int64_t time = 0;
  std::uint64_t blockSequence = 0;
  std::uint8_t state = 0, phase = 0, kind = 0, valid = 0, earlyWarning = 0;
  ReasonRow reason;
  double frequency = 0, frequencySd = 0, severity = 0, spindle = 0, sinceOnset = 0, feedSinceOnset = 0;
  std::array<double, kMaxIndicators> indicators{};
};

struct CommandRow {
  std::uint64_t step = 0;
  std::int64_t time = 0;
  std::uint64_t sequence = 0;
  std::uint8_t kind = 0;
  double speed = 0, feed = 0;
  std::int64_t lease = 0;
  std::uint64_t engagement = 0;
  ReasonRow reason;
};

struct EventRow {
  std::uint64_t step = 0;
  std::int64_t time = 0;
  std::uint64_t number = 0;
  std::uint8_t level = 0;
  ReasonRow reason;
};

inline constexpr std::size_t kTruthNameSize = 48;

// Known only of simulated cuts.
struct TruthRow {
  std::array<char, kTruthNameSize> name{};
  double value = 0.0;
};
struct TruthSampleRow {
  std::array<char, kTruthNameSize> name{};
  std::int64_t time = 0;
  double value = 0.0;
};

// Steps without a gap between them: where a time is looked up. A new one begins after a gap and wherever the clock of
// the samples has left the rate by more than kSegmentDrift.
struct SegmentRow {
  std::uint64_t step = 0;    // the first
  std::uint64_t offset = 0;  // of its first frame in the samples
  std::int64_t firstSample = 0;
  double rate = 0.0;
};
inline constexpr Duration kSegmentDrift = std::chrono::milliseconds(1);

inline constexpr std::size_t kMarkerLabelSize = 32;
inline constexpr std::size_t kMarkerAuthorSize = 64;
inline constexpr std::size_t kMarkerNoteSize = 512;

// A later row of the same number replaces the one before.
struct MarkerRow {
  std::uint64_t number = 0;
  std::int64_t begin = 0, end = 0, made = 0;
  std::uint8_t removed = 0;
  std::array<char, kMarkerLabelSize> label{};
  std::array<char, kMarkerAuthorSize> author{};
  std::array<char, kMarkerNoteSize> note{};
};

template <class Row>
std::span<const RowField> columnsOf();

// Reason codes are numbers of one version of the program; a file lists their identifiers, and reading goes by those.
std::string reasonIdentifiers();  // one a line, in the order of the numbers
class ReasonCodes {
 public:
  explicit ReasonCodes(const std::string& identifiers);
  // The code of this program for what a file holds; None when this program does not know it.
  ReasonCode fromFile(ReasonCode stored) const;

 private:
  std::vector<ReasonCode> codes_;
};

BlockRow toRow(const SampleBlock& block, std::uint64_t offset);
MachineRow toRow(const MachineState& machine);
DecisionRow toRow(const StepOutput& output);
InputRow toRow(const OperatorInput& input, std::uint64_t step);
VerdictRow toRow(const Verdict& verdict, int detector, std::uint64_t step);
CommandRow toRow(const CommandRecord& command, std::uint64_t step);
EventRow toRow(const Event& event, std::uint64_t step);

// The way back. False: a value that this program never writes.
void fromRow(const BlockRow& row, SampleBlock& block);  // all but the samples
void fromRow(const MachineRow& row, MachineState& machine);
bool fromRow(const DecisionRow& row, StepOutput& output);
bool fromRow(const InputRow& row, OperatorInput& input);
bool fromRow(const VerdictRow& row, Verdict& verdict);
void fromRow(const CommandRow& row, CommandRecord& command);
void fromRow(const EventRow& row, Event& event);

}  // namespace stillcut::record
