// The energy-ratio detector's numeric chain against its equations written out plainly (oracle/plain_energy.h), with
// every instruction set.
#include "core/detect/caliskan/energy_chain.h"

#include "core/dsp/kernels/choose.h"
#include "tests/unit/detect/oracle/plain_energy.h"
#include "tests/unit/detect/oracle/sources.h"

namespace stillcut::detect::testing {
namespace {

constexpr int kHarmonics = 32;
constexpr double kRetune = 1e-3;  // the speed change at which the bank's edges follow
constexpr double kStrict = 1e-6;  // of the numbers themselves
// For a few turns after the filters were retuned: their states were scaled by other coefficients.
constexpr double kLoose = 0.05;
constexpr double kSettleTurns = 12.0;
constexpr double kLooseTurns = 2.0;

int lagOf(int band, double width, double rate) {
  return std::max(1, static_cast<int>(std::lround(rate / (4.0 * (band + 0.5) * width))));
}

// Both chains side by side, hop by hop: eighths of a turn.
class SideBySide {
 public:
  SideBySide(const Source& source, double rate)
      : rate_(rate), orders_(source.teeth), eta_(integrationFactor(source.quantity)), plain_(kHarmonics) {
    const double spindle = toHertz(Rpm(source.rpm)).value;
    bands_.resize(static_cast<std::size_t>(kHarmonics / orders_));
    for (const auto set : dsp::kernels::availableSets()) {
      chains_.emplace_back();
      chains_.back().prepare(
          {1, kHarmonics, static_cast<int>(bands_.size()), orders_, Hertz(rate), Hertz(0.5 * spindle)},
          dsp::kernels::kernelsOf(set));
    }
  }

  void process(const ConditionedBlock& block) {
    tune(block);
    for (int f = 0; f < block.frames;) {
      int n = 1;
      while (f + n < block.frames && inHop_ + n < hop_ && block.angleStep[f + n] == block.angleStep[f]) ++n;
      for (EnergyChain& chain : chains_) {
        chain.align(block.angle[f], block.angleStep[f]);
        chain.process(block.samples + f, 0, static_cast<std::size_t>(n));
      }
      for (int k = 0; k < n; ++k) compareRest(block.samples[f + k], block.angle[f + k], k);
      f += n;
      if ((inHop_ += n) >= hop_) endHop();
    }
  }
  int hops() const { return hops_; }
  int strictHops() const { return strict_; }

 private:
  void tune(const ConditionedBlock& block) {
    spindle_ = block.spindle.value;
    const double gain = spindle_ / rate_;
    gain_ = gain;
    for (EnergyChain& chain : chains_) chain.tune(block.spindle, gain);
    active_ = std::min(kHarmonics, static_cast<int>(EnergyChain::kUsableBand * rate_ / spindle_));
    hop_ = std::max(1, static_cast<int>(rate_ / spindle_ / 8.0));
    const double width = spindle_ * orders_;
    if (active_ == top_ && width_ > 0.0 && std::abs(width / width_ - 1.0) < kRetune) return;
    width_ = width;
    top_ = active_;
    sinceRetune_ = 0.0;
    const double top = active_ * spindle_;
    usable_ = static_cast<int>(bands_.size());
    while (usable_ > 1 && 4 * (active_ - (usable_ - 1) * orders_) < orders_) --usable_;
    for (int m = 0; m < usable_; ++m) {
      PlainBand& band = bands_[static_cast<std::size_t>(m)];
      const double low = m == 0 ? 0.5 * spindle_ : m * width;
      band.tune(Hertz(low), Hertz(std::min((m + 1) * width, top)), Hertz(rate_));
      band.setLag(lagOf(m, width, rate_));
    }
  }
  void compareRest(double x, double angle, int k) {
    const double rest = plain_.process(x, angle, active_, gain_);
    largest_ = std::max(largest_, std::abs(x));
    for (const EnergyChain& chain : chains_) ASSERT_NEAR(chain.rest(0)[k], rest, 1e-8 * largest_) << "hop " << hops_;
    for (int m = 0; m < usable_; ++m) bands_[static_cast<std::size_t>(m)].process(rest);
  }
  void endHop() {
    for (EnergyChain& chain : chains_) chain.endHop();
    for (int m = 0; m < usable_; ++m) bands_[static_cast<std::size_t>(m)].estimate(inHop_);
    sinceRetune_ += inHop_ * spindle_ / rate_;
    inHop_ = 0;
    ++hops_;
    const bool strict = sinceRetune_ > kSettleTurns;
    if (strict) ++strict_;
    const double within = strict ? kStrict : kLoose;
    const double plain = plainEnergyRatio(plain_, active_, spindle_, bands_, eta_);
    for (const EnergyChain& chain : chains_) {
      if (sinceRetune_ > kLooseTurns) {
        ASSERT_NEAR(chain.ratio(0, eta_), plain, within) << "hop " << hops_;
      }
      ASSERT_EQ(chain.ratio(0, eta_), chains_.front().ratio(0, eta_)) << "another instruction set";
    }
    if (strict) compareBands();
  }
  void compareBands() {
    for (int m = 0; m < usable_; ++m) {
      const PlainBand& plain = bands_[static_cast<std::size_t>(m)];
      const BandEstimate band = chains_.front().bands().band(0, m);
      ASSERT_EQ(band.valid, plain.valid) << "band " << m << " hop " << hops_;
      if (!plain.valid) continue;
      ASSERT_NEAR(band.power, plain.power, 1e-5 * plain.power) << "band " << m << " hop " << hops_;
      ASSERT_NEAR(band.frequency.value, plain.frequency, 1e-5 * plain.frequency) << "band " << m << " hop " << hops_;
    }
  }

  double rate_;
  int orders_;
  int eta_;
  PlainHarmonics plain_;
  std::vector<PlainBand> bands_;
  std::vector<EnergyChain> chains_;  // one per instruction set
  double spindle_ = 0.0;
  double width_ = 0.0;
  double gain_ = 0.0;
  double largest_ = 0.0;
  double sinceRetune_ = 0.0;  // turns
  int active_ = 0;
  int top_ = 0;  // of the bands, in orders
  int usable_ = 0;
  int hop_ = 1;
  int inHop_ = 0;
  int hops_ = 0;
  int strict_ = 0;
};

class EnergyChainOracle : public OnSources {};

TEST_P(EnergyChainOracle, ResidualBandsAndRatioAgree) {
  STILLCUT_NEEDS_SOURCE(GetParam());
  const Recording recording = recordingOf(GetParam());
  SideBySide both(GetParam(), recording.rate);
  forEachBlock(GetParam(), recording, [&](const ConditionedBlock& block) {
    if (!HasFatalFailure()) both.process(block);
  });
  EXPECT_GT(both.hops(), 200);
  EXPECT_GT(both.strictHops(), both.hops() / 3);
}

INSTANTIATE_TEST_SUITE_P(Sources, EnergyChainOracle, ::testing::ValuesIn(sources()));

}  // namespace
}  // namespace stillcut::detect::testing
