// A cut that somebody enters on the Lobes page: tool, modes, material and engagement, from nothing or from a file. It
// needs no run and no device. app/session implements the controller. GUI thread; every function returns at once.
#pragma once

#include <QString>
#include <array>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "ui/facade/lobe_service.h"

namespace stillcut::ui {

struct EnteredMode {
  Hertz frequency{};
  double damping = 0.0;                       // ratio
  double stiffness = 0.0;                     // modal, at the tool tip [N/m]
  std::array<double, 2> direction{1.0, 0.0};  // of x (along the feed) and y
  bool operator==(const EnteredMode&) const = default;
};

struct EnteredMaterial {
  QString id, what;                       // "7075-T6"; in words, in English
  double tangential = 0.0, radial = 0.0;  // [N/m2]; 0: its force does not grow straight with the chip
};

struct EnteredCut {
  QString file;  // that it began as; empty: none
  std::vector<EnteredMode> modes;
  int teeth = 2;
  Metres diameter{0.012};
  double helix = 0.0;                     // [rad]
  QString material;                       // of the table; empty: the two coefficients, or the file's
  double tangential = 0.0, radial = 0.0;  // [N/m2]; 0: the file's
  double immersion = 0.5;                 // width of cut over diameter, 0 .. 1
  bool upMilling = false;
  Metres feedPerTooth{};  // 0: not known, nothing is said of removal and forced vibration
  Metres depth{2e-3};
  Metres deepest{10e-3};    // that the diagram looks down to
  Rpm lowest{}, highest{};  // of the machine; both 0: a range that suits the modes
  bool operator==(const EnteredCut&) const = default;
};

class LobeEntryController {
 public:
  virtual ~LobeEntryController() = default;

  virtual const std::vector<EnteredMaterial>& materials() const = 0;
  // What a file says of a cut: a whole cut, a scenario, a profile with its model; or modes alone, which take the place
  // of those of `cut`. What the fields do not hold (pitch, runout, force exponent ...) stays with the file's cut.
  virtual Result<EnteredCut> read(const EnteredCut& cut, const QString& file) const = 0;
  // What service() computes from now on. An error, one line, leaves it as it was.
  virtual Status enter(const EnteredCut& cut) = 0;
  // Null: nothing has been entered.
  virtual LobeService* service() = 0;
};

}  // namespace stillcut::ui
