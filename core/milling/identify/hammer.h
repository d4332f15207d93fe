// From hammer records to the frequency response function: one or several hits in one or several files, H1 or H2
// estimate, coherence, and the checks a tap test needs (double hit, overload, direction of the force).
// Source: H1 = S_fx / S_ff (noise on the response averages out), H2 = S_xx / S_xf (noise on the force does), coherence
// |S_fx|^2 / (S_ff S_xx); D. Ewins, Modal Testing, 2nd ed., sections 3.8 to 3.10.
// Thread: any, set-up path.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/identify/frf.h"

namespace stillcut::identify {

struct HammerRecord {
  double rate = 0.0;                                // [Hz]
  std::vector<double> force;                        // [N], positive while the hammer pushes
  std::vector<double> response;                     // [m/s^2, m/s or m], positive along the force
  FrfQuantity quantity = FrfQuantity::Accelerance;  // what the response over the force is
  Axis axis = Axis::Unknown;                        // of both
  std::string source;
};

enum class FrfEstimate { H1, H2 };

struct HammerOptions {
  double trigger = 0.15;        // a hit: force above this fraction of the record's largest force
  double separation = 0.25;     // pulses further apart are hits of their own, nearer ones a double hit [s]
  double doubleHit = 0.04;      // a second pulse above this fraction of the first is a double hit
  double duration = 0.0;        // analysed after each hit [s]; 0: up to the next hit or the record's end
  double forceWindow = 0.0;     // force set to zero (tapered) later than this after its peak [s]; 0: off
  double exponentialEnd = 1.0;  // fraction of amplitude the exponential window leaves at the end; 1: off
  double overload = 0.0;        // force or response at or beyond this size is overloaded [own unit each]; 0: by shape
  bool useDoubleHits = false;   // keep hits that failed the check
  bool flipForce = false;       // the force channel counts a push as negative
  bool flipResponse = false;    // the accelerometer points against the force
  FrfEstimate estimate = FrfEstimate::H1;
  std::vector<int> without;     // hits to leave out, counted from 1 over all records
  std::vector<int> alongOther;  // and those that went along another axis than the response
};

struct Hit {
  double time = 0.0;       // of the force peak, from the record's start [s]
  double peakForce = 0.0;  // [N]
  double width = 0.0;      // of the pulse at half height [s]
  double response = 0.0;   // rms of the response after it, without its offset [its unit]
  bool doubleHit = false;
  bool forceOverload = false;
  bool responseOverload = false;
  bool begun = false;     // when the record begins: part of the pulse is missing
  bool unwanted = false;  // one of HammerOptions::without
  bool alongOther = false;
  bool used = false;
  std::size_t record = 0;  // which of the records, from 0
};

struct HammerResult {
  Frf frf;                       // of the records' quantity
  std::vector<Hit> hits;         // all that were found, in the order of the records
  int averages = 0;              // hits used
  std::vector<Message> remarks;  // one line each: what was left out, what was inverted, what is uncertain
};

// Records of one axis, all with one sampling rate. A force whose pulses are negative is turned, and so is the response
// of a record that takes power out of the structure, which a driving point cannot do; both are said. A constant offset
// of either channel is taken off.
// Error when there is no hit, or none that passes the checks, or a record is no record (rate, lengths, NaN).
Result<HammerResult> analyseHammer(const std::vector<HammerRecord>& records, const HammerOptions& options);

}  // namespace stillcut::identify
