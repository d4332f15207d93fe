#include "core/milling/identify/modal_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/milling/identify/lscf.h"
#include "core/milling/identify/modal_band.h"
#include "core/milling/identify/modal_model.h"
#include "core/milling/identify/modal_quality.h"

namespace stillcut::identify {
namespace {

constexpr std::size_t kMostLines = 3000;
constexpr std::size_t kMostCandidates = 16;
constexpr int kIterations = 25;
constexpr double kRiseThatCounts = 1.5;    // of the misfit
constexpr double kShareThatCounts = 0.05;  // of the response
constexpr double kMisfitFloor = 0.003;     // below this the misfit is as good as none
constexpr double kLargestPhase = 1.05;     // 60 degrees
constexpr double kDoubtfulPhase = 0.52;    // 30 degrees
constexpr double kLargestDamping = 0.3;
constexpr double kPoorCoherence = 0.8;

Status checkOptions(const Frf& frf, const ModalOptions& o) {
  const auto bad = [&](Message what) { return Error{frf.source, std::move(what)}; };
  if (!std::isfinite(o.from) || !std::isfinite(o.to) || o.from < 0.0 || o.to < 0.0)
    return bad(message("the band is no band"));
  if (o.from > 0.0 && o.to > 0.0 && o.to <= o.from) return bad(message("the band ends before it begins"));
  if (o.modes < 0 || o.modes > 16) return bad(message("the number of modes must be 1 to 16, or 0 for automatic"));
  if (o.highestOrder < 4 || o.highestOrder > 60) return bad(message("the highest model order must be 4 to 60"));
  if (frf.frequency.size() != frf.value.size()) return bad(message("frequencies and values differ in number"));
  return Done{};
}

// A free end is that of the resonances on its side; where there are none, that of the measurement.
Result<Band> chooseBand(const Frf& compliance, const std::vector<Resonance>& resonances, const ModalOptions& options) {
  const Band given{options.from, options.to};
  if (given.from > 0.0 && given.to > 0.0) return given;
  auto found = resonantBand(compliance, resonances, given);
  if (given.from <= 0.0 && given.to <= 0.0) return found;
  const double last = compliance.usableTo > 0.0 ? compliance.usableTo : compliance.frequency.back();
  Band band = found ? *found : Band{compliance.frequency.front(), last};
  if (given.from > 0.0) band.from = given.from;
  if (given.to > 0.0) band.to = given.to;
  if (band.to <= band.from) return Error{compliance.source, message("ends before the band given")};
  return band;
}

Result<ModalLines> linesIn(const Frf& compliance, const Band& band) {
  const auto& f = compliance.frequency;
  const auto first = static_cast<std::size_t>(std::lower_bound(f.begin(), f.end(), band.from) - f.begin());
  const auto end = static_cast<std::size_t>(std::upper_bound(f.begin(), f.end(), band.to) - f.begin());
  const std::size_t count = end > first ? end - first : 0;
  if (count < 16) {
    return Error{compliance.source, message("has only %1 lines in the band", std::to_string(count)),
                 message("16 are needed")};
  }
  const std::size_t stride = (count + kMostLines - 1) / kMostLines;
  ModalLines lines;
  const auto kept = static_cast<Eigen::Index>((count + stride - 1) / stride);
  lines.frequency.resize(kept);
  lines.value.resize(kept);
  for (Eigen::Index i = 0; i < kept; ++i) {
    const std::size_t at = first + static_cast<std::size_t>(i) * stride;
    lines.frequency[i] = f[at];
    lines.value[i] = compliance.value[at];
  }
  lines.from = lines.frequency[0];
  lines.to = lines.frequency[kept - 1];
  if (!lines.value.allFinite() || !lines.frequency.allFinite()) {
    return Error{compliance.source, message("holds a value that is not finite")};
  }
  // A driving point takes power in: the imaginary part of its compliance is negative.
  const double imaginary = lines.value.imag().sum();
  if (imaginary > 0.25 * lines.value.imag().cwiseAbs().sum()) {
    return Error{compliance.source, message("force and response point against each other"),
                 message("if the sensor sat on the other side, turn the response with --flip")};
  }
  if (lines.value.cwiseAbs().maxCoeff() <= 0.0) return Error{compliance.source, message("is zero in the band")};
  return lines;
}

// The search for the smallest sufficient set of modes.
class Selection {
 public:
  Selection(const ModalLines& lines, std::vector<ModalPole> poles, int wanted)
      : lines_(lines), poles_(std::move(poles)), wanted_(wanted) {}

  void run() {
    if (poles_.empty()) return;  // nothing resonates steadily, as in a recording of a cut
    misfit_ = refinePoles(lines_, poles_, kIterations);
    while (!poles_.empty()) {
      const int unphysical = findUnphysical();
      if (unphysical >= 0) {
        without(unphysical);
        continue;
      }
      const int size = static_cast<int>(poles_.size());
      if (size == 1 || (wanted_ > 0 && size <= wanted_)) return;
      std::vector<ModalPole> fewer = poles_;
      fewer.erase(fewer.begin() + leastNeeded());
      const double misfit = refinePoles(lines_, fewer, kIterations);
      if (wanted_ == 0 && counts(misfit)) return;
      poles_ = std::move(fewer);
      misfit_ = misfit;
    }
  }

  const std::vector<ModalPole>& poles() const { return poles_; }
  double misfit() const { return misfit_; }

  // Misfit when mode i is left out and all else stays, poles included.
  double misfitWithout(std::size_t i) const {
    std::vector<ModalPole> fewer = poles_;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    return fitConstants(lines_, fewer, ModalConstants::Complex).misfit;
  }

 private:
  bool counts(double misfitOfFewer) const {
    const double share = std::sqrt(std::max(0.0, misfitOfFewer * misfitOfFewer - misfit_ * misfit_));
    return share > kShareThatCounts || misfitOfFewer > kRiseThatCounts * std::max(misfit_, kMisfitFloor);
  }

  std::ptrdiff_t leastNeeded() const {
    std::size_t least = 0;
    double lowest = misfitWithout(0);
    for (std::size_t i = 1; i < poles_.size(); ++i) {
      const double misfit = misfitWithout(i);
      if (misfit < lowest) {
        lowest = misfit;
        least = i;
      }
    }
    return static_cast<std::ptrdiff_t>(least);
  }

  // The mode furthest from what a driving point can have, -1 when all can be.
  int findUnphysical() const {
    const ConstantsFit fit = fitConstants(lines_, poles_, ModalConstants::Complex);
    int worst = -1;
    double worstPhase = kLargestPhase;
    for (int i = 0; i < static_cast<int>(poles_.size()); ++i) {
      const ModalPole& pole = poles_[static_cast<std::size_t>(i)];
      const Eigen::Index at = 2 * static_cast<Eigen::Index>(i);
      const double phase = std::abs(std::atan2(fit.constants[at + 1], fit.constants[at]));
      const bool outside = pole.frequency < 0.97 * lines_.from || pole.frequency > 1.03 * lines_.to;
      if (outside || pole.damping > kLargestDamping) return i;
      if (phase > worstPhase) {
        worstPhase = phase;
        worst = i;
      }
    }
    return worst;
  }

  void without(int i) {
    poles_.erase(poles_.begin() + i);
    if (!poles_.empty()) misfit_ = refinePoles(lines_, poles_, kIterations);
  }

  const ModalLines& lines_;
  std::vector<ModalPole> poles_;
  int wanted_;
  double misfit_ = 1.0;
};

std::vector<ModalPole> candidates(const std::vector<StablePole>& stable, const ModalLines& lines, int wanted) {
  std::vector<ModalPole> out;
  for (const StablePole& s : stable) {
    if (out.size() >= std::max(kMostCandidates, static_cast<std::size_t>(wanted))) break;
    if (s.seen < 4 && out.size() >= static_cast<std::size_t>(std::max(wanted, 1))) break;
    if (s.pole.frequency < lines.from || s.pole.frequency > lines.to) continue;
    out.push_back(s.pole);
  }
  return out;
}

double stabilityOf(const ModalPole& pole, const std::vector<std::vector<ModalPole>>& diagram) {
  int seen = 0;
  for (const auto& order : diagram) {
    seen += std::any_of(order.begin(), order.end(), [&](const ModalPole& p) {
      return std::abs(p.frequency - pole.frequency) < 0.02 * pole.frequency && p.damping > 0.3 * pole.damping &&
             p.damping < 3.0 * pole.damping;
    });
  }
  return diagram.empty() ? 0.0 : static_cast<double>(seen) / static_cast<double>(diagram.size());
}

std::string doubtAbout(const IdentifiedMode& m, const ModalFit& fit) {
  const auto degrees = static_cast<int>(std::lround(std::abs(m.phase) * 57.29578));
  if (std::abs(m.phase) > kDoubtfulPhase) {
    return "shape " + std::to_string(degrees) + " degrees off real: its stiffness is approximate";
  }
  if (m.stability < 0.3) return "its pole is seldom stable";
  if (m.dampingSd > 0.2 * m.mode.damping) return "its damping is uncertain";
  if (m.coherence > 0.0 && m.coherence < kPoorCoherence) return "its coherence is poor: hit more evenly, or more often";
  const double f = m.mode.frequency.value;
  const double bandwidth = 2.0 * m.mode.damping * f;
  if (f - bandwidth < fit.from || f + bandwidth > fit.to) return "lies at the edge of the band";
  if (m.share < kShareThatCounts) return "hardly shows in the response";
  return {};
}

// Takes the decay an exponential window added off a mode again; the modal mass stays. False when none would be left.
bool withoutWindow(milling::Mode& mode, double addedDecay) {
  if (addedDecay <= 0.0) return true;
  const double w = kTwoPi * mode.frequency.value;
  const double damped = w * std::sqrt(1.0 - mode.damping * mode.damping);
  const double decay = mode.damping * w - addedDecay;
  if (decay <= 0.0) return false;
  const double natural = std::hypot(damped, decay);
  mode.stiffness *= (natural / w) * (natural / w);
  mode.frequency = Hertz(natural / kTwoPi);
  mode.damping = decay / natural;
  return true;
}

// A mode far below the band is all inertia in it, one far above all compliance. A residual with the other sign stands
// for no structure and is left out.
std::vector<milling::Mode> residualModes(const ModalLines& lines, double compliance, double inertia) {
  constexpr double kBelow = 0.2, kAbove = 4.0;  // of the ends of the band
  constexpr double kDamping = 0.3;              // so much that they chatter nowhere themselves
  std::vector<milling::Mode> modes;
  if (inertia > 0.0) {
    // -inertia (middle/f)^2 is what a mode of this frequency comes to.
    const double low = kBelow * lines.from, middle = 0.5 * (lines.from + lines.to);
    modes.push_back({Hertz(low), kDamping, (low / middle) * (low / middle) / inertia, {1.0, 0.0}});
  }
  if (compliance > 0.0) modes.push_back({Hertz(kAbove * lines.to), kDamping, 1.0 / compliance, {1.0, 0.0}});
  return modes;
}

void describeModes(ModalFit& fit, const ModalLines& lines, const Selection& selection, const Frf& frf) {
  const std::vector<ModalPole>& poles = selection.poles();
  const ConstantsFit constants = fitConstants(lines, poles, ModalConstants::Complex);
  const Eigen::MatrixX3d sd = relativeDeviations(lines, poles);
  fit.misfit = constants.misfit;
  const ConstantsFit real = fitConstants(lines, poles, ModalConstants::Real);
  fit.realMisfit = real.misfit;
  const auto modes = static_cast<Eigen::Index>(poles.size());
  for (Eigen::Index i = 0; i < modes; ++i) {
    const ModalPole& pole = poles[static_cast<std::size_t>(i)];
    if (!(real.constants[i] > 0.0)) continue;
    milling::Mode mode{Hertz(pole.frequency), pole.damping, 1.0 / real.constants[i], {1.0, 0.0}};
    if (withoutWindow(mode, frf.addedDecay)) fit.whole.push_back(mode);
  }
  for (const milling::Mode& mode : residualModes(lines, real.constants[modes], real.constants[modes + 2])) {
    fit.whole.push_back(mode);
    ++fit.outside;
  }
  fit.fitted.assign(constants.fitted.begin(), constants.fitted.end());
  for (std::size_t i = 0; i < poles.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double a = constants.constants[2 * row];
    IdentifiedMode m;
    m.mode.frequency = Hertz(poles[i].frequency);
    m.mode.damping = poles[i].damping;
    m.mode.stiffness = 1.0 / a;
    m.phase = std::atan2(constants.constants[2 * row + 1], a);
    m.frequencySd = sd(row, 0) * poles[i].frequency;
    m.dampingSd = sd(row, 1) * poles[i].damping;
    m.stiffnessSd = sd(row, 2) / a;
    const double without = poles.size() > 1 ? selection.misfitWithout(i) : 1.0;
    m.share = std::min(1.0, std::sqrt(std::max(0.0, without * without - fit.misfit * fit.misfit)));
    m.stability = stabilityOf(poles[i], fit.diagram);
    if (!withoutWindow(m.mode, frf.addedDecay)) {
      fit.remarks.push_back(message("a mode at %1 Hz left out: all its damping is the exponential window's",
                                    std::lround(poles[i].frequency)));
      continue;
    }
    m.depth = 1.0 / (4.0 * m.mode.stiffness * m.mode.damping * (1.0 + m.mode.damping));
    m.coherence = coherenceAt(frf, m.mode);
    m.caveat = doubtAbout(m, fit);
    fit.modes.push_back(std::move(m));
  }
  std::sort(fit.modes.begin(), fit.modes.end(),
            [](const auto& p, const auto& q) { return p.mode.frequency < q.mode.frequency; });
}

}  // namespace

Result<ModalFit> fitModes(const Frf& frf, const ModalOptions& options) {
  Status sane = checkOptions(frf, options);
  if (!sane) return sane.error();
  const Frf compliance = toCompliance(frf);
  if (compliance.frequency.empty()) return Error{frf.source, message("holds no line above 0 Hz")};
  const std::vector<Resonance> resonances = findResonances(compliance);
  const auto band = chooseBand(compliance, resonances, options);
  if (!band) return band.error();
  const auto lines = linesIn(compliance, *band);
  if (!lines) return lines.error();
  ModalFit fit;
  fit.from = lines->from;
  fit.to = lines->to;
  fit.frequency.assign(lines->frequency.begin(), lines->frequency.end());
  fit.measured.assign(lines->value.begin(), lines->value.end());
  const int lineLimit = static_cast<int>(lines->frequency.size()) / 3;
  fit.diagram = lscfPoles(*lines, std::clamp(options.highestOrder, 4, std::max(4, lineLimit)));
  Selection selection(*lines, candidates(stablePoles(fit.diagram), *lines, options.modes), options.modes);
  selection.run();
  if (!selection.poles().empty()) describeModes(fit, *lines, selection, compliance);
  if (fit.modes.empty())
    return Error{frf.source, message("no physical mode was found in the band"), message("try another band")};
  judgeWritten(fit, resonances, frf.addedDecay);
  nameLeftOut(fit, resonances, compliance.usableTo);
  if (static_cast<int>(fit.modes.size()) < options.modes) {
    fit.remarks.push_back(message("only %1 of the %2 modes asked for were found", fit.modes.size(), options.modes));
  }
  if (fit.misfit > 0.2) fit.remarks.push_back(message("the fit leaves a fifth of the response unexplained or more"));
  if (fit.realMisfit > 0.2) fit.remarks.push_back(message("real modes describe this structure poorly"));
  return fit;
}

}  // namespace stillcut::identify
