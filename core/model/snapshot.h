// Snapshot: everything a screen shows, as one immutable value. The worker publishes it at block boundaries; the screen
// pulls the newest at 25-30 Hz and replaces the one it had. Fixed size: publishing neither allocates nor locks.
#pragma once

#include <array>
#include <cstdint>

#include "core/model/event.h"
#include "core/model/machine_state.h"
#include "core/model/operator_input.h"
#include "core/model/override_command.h"
#include "core/model/override_request.h"
#include "core/model/sensor_status.h"
#include "core/model/speed_advice.h"
#include "core/model/verdict.h"

namespace stillcut {

inline constexpr int kMaxDetectors = 6;
inline constexpr int kSpectrumBins = 512;    // 0 .. rate/2 in equal steps
inline constexpr int kSpectrumColumns = 16;  // newest columns kept, so that a late screen loses none
inline constexpr int kEventsShown = 16;
inline constexpr int kInterventionsShown = 4;

// One column of the spectrogram of one channel, the first unless the screen has asked for another.
struct SpectrumColumn {
  std::uint64_t number = 0;                     // counts columns; consecutive numbers have no gap between them
  int channel = 0;                              // that it is of
  Instant time{};                               // middle of its window
  bool afterGap = false;                        // samples were lost before it
  Hertz spindle{};                              // in force then, for the tooth-passing ticks
  Hertz chatter{};                              // 0: no mark
  std::array<float, kSpectrumBins> level_dB{};  // dB re 1 SI unit rms
};

// Counters of the sample path, all since the start.
struct PathHealth {
  std::uint64_t blocks = 0;
  std::uint64_t droppedBlocks = 0;
  std::uint64_t gaps = 0;
  std::uint64_t overruns = 0;  // blocks whose processing took longer than their own length
  std::uint64_t detectorFaults = 0;
  std::uint64_t tapDropped = 0;     // items the recorder could not take in time
  std::uint64_t leasesExpired = 0;  // orders that the link thread took back because nothing renewed them
  std::uint64_t linkStalls = 0;     // times the link thread stood still, or the computer slept
  Seconds linkThreadAge{};          // since the link thread's last tick: old, it stands still, not the machine
  Seconds blockLength{};
  Seconds blockAge{};  // from the last sample to the decision, newest block
  Seconds worstBlockAge{};
  Seconds processing{};  // of the newest block
  Seconds worstProcessing{};
};

struct Snapshot {
  std::uint64_t number = 0;
  Instant time{};  // end of the newest block
  bool running = false;
  bool simulated = false;  // the machine is a simulated one

  int detectorCount = 0;
  int inCharge = 0;  // index into verdicts
  std::array<Verdict, kMaxDetectors> verdicts{};
  OverrideRequest request;
  bool adviceOpen = false;  // the request waits for accept or refuse
  std::uint32_t adviceNumber = 0;
  SpeedAdvice advice;  // of the present cut, whether or not anybody may follow it
  CommandRecord command;
  bool commanding = false;  // a command other than release is in force
  Authority authority = Authority::Off;
  Instant authoritySince{};
  bool autoAllowed = false;
  bool operatorHold = false;
  MachineState machine;
  double vibrationRms = 0.0;  // first channel, SI, last block
  Seconds cutTime{};          // total in the cut: neither air nor run-up
  Seconds judgedTime{};       // of it, judged (judged_cut.h)
  Seconds chatterTime{};      // total in chatter; an onset is not counted
  Metres chatterLength{};     // path cut meanwhile
  PathHealth health;
  SensorStatus sensors;  // live level, actual rate, and whether each channel can be believed

  std::uint64_t columnCount = 0;  // columns ever made; columns[(number) % kSpectrumColumns]
  Hertz spectrumTop{};            // frequency of the upper edge of the last bin
  std::array<SpectrumColumn, kSpectrumColumns> columns{};

  std::uint64_t eventCount = 0;  // events ever; events[(number) % kEventsShown]
  std::array<Event, kEventsShown> events{};
  std::uint64_t interventionCount = 0;
  std::array<Intervention, kInterventionsShown> interventions{};
};

}  // namespace stillcut
