// Finds the spindle frequency on two spectra: of the vibration and of its square. Forced vibration puts its lines on a
// comb in both. A chatter line, which need not lie on the comb, disappears from the square: what is left there are the
// differences between lines, and the side lines of chatter are whole spindle orders apart (methods.md section 4).
// Each comb is judged by the part of the power that lies on it, and the two parts are added.
//
// Evidence: a face mill chattering at 898.5 Hz at 27.58 Hz fits 33 x 27.23 and 32 x 28.08 Hz; the comb on the vibration
// alone takes those in 95 % of its windows, the square alone finds 27.59 Hz in 95 to 100 %. An end mill chattering at
// 275 Hz is the other way round: vibration alone 100 %, square alone 36 %.
// Thread: worker; search() is real-time.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/base/units.h"
#include "core/dsp/spectrum.h"
#include "core/spindle/speed_finder.h"

namespace stillcut::detect {

struct SpeedCandidate {
  // A comb that carries half of all power needs no other proof; a weaker one must stand out of all other combs. In air
  // and on machine noise the contrast stays below 2, on cuts it is 3 to 80.
  static constexpr double kClearPart = 0.5;
  static constexpr double kLeastPart = 0.1;
  static constexpr double kContrast = 3.0;

  Hertz spindle{};         // 0: nothing found
  Hertz sd{};              // resolution of the search
  double part = 0.0;       // power on the comb, mean of both spectra, 0..1
  double contrast = 0.0;   // part over the median part of all combs tried
  double toothPart = 0.0;  // part of the vibration's power on tooth-passing harmonics (0 without teeth)
  bool atEdge = false;     // the best comb is the last one tried: no peak

  // Is this comb the spindle's, if another window says so too?
  bool stands() const noexcept { return !atEdge && (part > kClearPart || (part > kLeastPart && contrast > kContrast)); }
};

class SpeedSearch {
 public:
  static constexpr double kOnComb = 0.15;  // orders from a harmonic, within which a line may be on the comb
  // A speed of which nobody measures anything may have run away since it was told; so far it is looked for, past what
  // the told speed may be off.
  static constexpr double kRunAway = 0.05;

  // window: samples per channel that search() gets.
  void prepare(int window, Hertz rate, int teeth);
  int window() const { return spectrum_.segment(); }

  // Adds one channel to the evidence. Call begin() first, then add() per channel, then search().
  // drift: of the speed, relative, per second. The samples are read as if the spindle had turned evenly at the speed
  // of the window's middle, so that its lines are as sharp as if it did.
  void begin(double drift = 0.0) noexcept;
  void add(std::span<const double> samples) noexcept;
  // notForced: a line that is known not to be forced (0: none); combs that it lies on are left out, and it and what it
  // leaves in the square are in no other. So is the strongest line, where the best comb has no more than that, and what
  // else there is makes another comb: it is chatter, or an order that is folded down.
  SpeedCandidate search(Hertz low, Hertz high, Hertz notForced = Hertz(0.0)) noexcept;
  // In a range too wide for search(), by the lines of the vibration alone (speed_finder.h).
  FoundSpeed find(Hertz low, Hertz high) noexcept;
  // The strongest line of the vibration and the part of the power in its lobe.
  struct Line {
    Hertz frequency{};
    double part = 0.0;
  };
  Line strongest() const noexcept;
  // Power of each spectrum on the comb of one frequency.
  struct Parts {
    double vibration = 0.0;
    double square = 0.0;
  };
  Parts partsAt(Hertz spindle) const noexcept;
  // The same without the strongest line of the vibration, and without twice its frequency in the square: a comb that
  // has moved takes all of its lines along, while one that was fitted to a chatter line has little else.
  Parts restAt(Hertz spindle) const noexcept { return restAt(spindle, strongest()); }
  // ... of the vibration, as a part of all that is not in that line.
  double restPartAt(Hertz spindle) const noexcept;
  // Chatter leaves the forced vibration where it was; a spindle that moves takes it along. Do both spectra hold less
  // than this part of the comb of `to` at `from`?
  bool hasMoved(Hertz from, Hertz to, double least) const noexcept;
  // May this line of the vibration be forced at some speed in low..high: a tooth passing, or one of a comb of lines?
  bool mayBeForced(Hertz line, Hertz low, Hertz high) const noexcept;
  // ... at this one, if at any?
  bool mayBeForcedAt(Hertz line, Hertz spindle) const noexcept;
  // ... or one line among others on a comb of low..high?
  bool mayBeAmongOthers(Hertz line, Hertz low, Hertz high) const noexcept;

 private:
  static constexpr int kMostTrials = 4096;

  SpeedCandidate searchCombs(Hertz low, Hertz high, Hertz notForced) noexcept;
  std::span<const double> evened(std::span<const double> samples) noexcept;
  void addSpectrum(std::span<const double> samples, std::vector<double>& power) noexcept;
  double lobeAt(const std::vector<double>& power, std::size_t middle) const noexcept;
  Line lineAt(std::size_t peak) const noexcept;
  // Where a line stands in the square, folded back if it has to be.
  double doubled(double frequency) const noexcept { return std::min(2.0 * frequency, rate_ - 2.0 * frequency); }
  Parts restAt(Hertz spindle, const Line& without) const noexcept;
  // Do other lines stand with this one on the comb of `spindle`, in the square of the vibration? What the line itself
  // leaves there at twice its frequency lies on every comb that the line lies on, and does not count.
  bool sharesComb(Hertz line, Hertz spindle) const noexcept;
  static double at(const std::vector<double>& power, double position) noexcept;
  void addBoth(Hertz notForced) noexcept;
  void tryCombs(double low, double step, int harmonics, std::size_t count) noexcept;
  Parts parts(double spindle, int harmonics, double leaveOut) const noexcept;
  int harmonicsOf(Hertz spindle) const noexcept;
  double toothPart(double spindle) const noexcept;

  dsp::kernels::Kernels kernels_;
  dsp::Spectrum spectrum_;
  SpeedFinder finder_;
  double rate_ = 0.0;
  int teeth_ = 0;
  int added_ = 0;
  double drift_ = 0.0;
  std::vector<double> power_;   // of the vibration, each channel normalised to sum 1
  std::vector<double> square_;  // of its square, the same
  std::vector<double> powers_;  // of one transform; both spectra together in a search
  std::vector<double> scratch_;
  std::vector<double> evened_;
  std::vector<double> trials_;
};

}  // namespace stillcut::detect
