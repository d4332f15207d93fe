// From a hammer record to the frequency response function: one or several hits, H1 estimate, coherence, and the checks
// a tap test needs (double hit, overload).
// Source: H1 = S_fx / S_ff (response over force, noise on the response averages out), coherence
// |S_fx|^2 / (S_ff S_xx); D. Ewins, Modal Testing, 2nd ed., sections 3.8 to 3.10.
// Thread: any, set-up path.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/milling/identify/frf.h"

namespace stillcut::identify {

struct HammerRecord {
  double rate = 0.0;             // [Hz]
  std::vector<double> force;     // [N], positive while the hammer pushes
  std::vector<double> response;  // acceleration [m/s^2], positive along the force
  std::string source;
};

struct HammerOptions {
  double trigger = 0.15;        // a hit: force above this share of the record's largest force
  double separation = 0.25;     // pulses further apart are hits of their own, nearer ones a double hit [s]
  double doubleHit = 0.04;      // a second pulse above this share of the first is a double hit
  double duration = 0.0;        // analysed after each hit [s]; 0: up to the next hit or the record's end
  double forceWindow = 0.0;     // force set to zero (tapered) later than this after its peak [s]; 0: off
  double exponentialEnd = 1.0;  // share of amplitude the exponential window leaves at the end; 1: off
  double overload = 0.0;        // force or response at or beyond this size is overloaded [own unit each]; 0: by shape
  bool useDoubleHits = false;   // keep hits that failed the check
  bool flipForce = false;       // the force channel counts a push as negative
  bool flipResponse = false;    // the accelerometer points against the force
};

struct Hit {
  double time = 0.0;       // of the force peak, from the record's start [s]
  double peakForce = 0.0;  // [N]
  double width = 0.0;      // of the pulse at half height [s]
  bool doubleHit = false;
  bool overload = false;
  bool used = false;
};

struct HammerResult {
  Frf frf;                           // accelerance
  std::vector<Hit> hits;             // all that were found
  int averages = 0;                  // hits used
  std::vector<std::string> remarks;  // one line each: what was left out, what to doubt
};

// Error when there is no hit, or none that passes the checks, or the record is no record (rate, lengths, NaN).
Result<HammerResult> analyseHammer(const HammerRecord& record, const HammerOptions& options);

}  // namespace stillcut::identify
