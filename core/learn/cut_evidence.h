// One judged cut as evidence about the machine: what cut, how fast, how deep, and whether it chattered. Plain values:
// any thread. What is kept of every cut for good, so that fields are only ever added.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/milling/cut_model.h"

namespace stillcut::learn {

enum class CutOutcome : std::uint8_t { Stable, Chatter };
// "stable", "chatter"
std::string_view name(CutOutcome outcome);

// What was clamped in which machine: cuts with one of these share their dynamics.
struct Assembly {
  std::string machine;  // "Mill 3"
  std::string tool;     // "T12"
  std::string holder;   // "HSK63 ER32"; may be empty
  Metres stickOut{};    // from the holder's face to the tip; 0: not given

  friend bool operator==(const Assembly&, const Assembly&) = default;
};

// The same assembly as cuts were kept when a tool's name said how it was clamped, in the words of the page Set up; a
// name alone says all of it where nothing more is said here.
Assembly byNameAlone(const Assembly& assembly);

struct CutEvidence {
  std::string id;  // unique over all machines; the store makes one where it is empty
  Assembly assembly;
  std::string material;  // "aluminium"; may be empty
  int teeth = 0;
  Metres diameter{};
  Rpm speed{};
  Metres depth{};  // axial
  milling::Engagement engagement;
  CutOutcome outcome = CutOutcome::Stable;
  double doubt = 0.02;      // probability that the verdict is wrong, 0 .. 0.5
  Hertz frequency{};        // of the chatter; 0: none, or not given
  Hertz frequencySd{};      // one standard deviation; 0: not given
  std::int64_t time_s = 0;  // seconds since 1970 UTC
  std::string source;       // file or run it was judged in; may be empty
};

// One clear line for a speed, depth or frequency that is none.
Status check(const CutEvidence& cut, const std::string& where);

// 128 random bits in hexadecimal.
std::string newEvidenceId();

}  // namespace stillcut::learn
