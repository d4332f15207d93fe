// The Vamp plugin as a host loads it, against the same samples through BlockRun.

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vamp-hostsdk/PluginHostAdapter.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "app/embed/block_run.h"
#include "core/base/units.h"

namespace stillcut::app {
namespace {

using Vamp::Plugin;

constexpr float kRate = 25600.0F;
constexpr double kSpeed = 6000.0, kChatter_Hz = 1316.0;
constexpr int kTeeth = 4;

// Two seconds of cut by its runout and tooth passings, then chatter that grows to five times as much, and may rise.
std::vector<float> aCut(double rise_HzPerSecond = 0.0) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.05);
  std::vector<float> x;
  for (int k = 0; k < static_cast<int>(5 * kRate); ++k) {
    const double t = k / static_cast<double>(kRate);
    double v = noise(random) + 0.3 * std::sin(kTwoPi * kSpeed / 60.0 * t);  // runout
    for (int n = 1; n <= 4; ++n) v += std::sin(kTwoPi * n * kTeeth * kSpeed / 60.0 * t) / n;
    const double since = std::max(0.0, t - 2.0);
    const double phase = kTwoPi * (kChatter_Hz * since + 0.5 * rise_HzPerSecond * since * since);
    if (t > 2.0) v += std::min(5.0, 0.01 * std::exp(8.0 * since)) * std::sin(phase);
    x.push_back(static_cast<float>(v));
  }
  return x;
}

class VampPlugin : public ::testing::Test {
 protected:
  void SetUp() override {
    library_ = ::dlopen(STILLCUT_VAMP, RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library_, nullptr) << ::dlerror();
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): dlsym knows no types
    const auto ask = reinterpret_cast<VampGetPluginDescriptorFunction>(::dlsym(library_, "vampGetPluginDescriptor"));
    ASSERT_NE(ask, nullptr);
    const VampPluginDescriptor* first = ask(2, 0);
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(ask(2, 1), nullptr);
    first_ = first;
    plugin_ = std::make_unique<Vamp::PluginHostAdapter>(first, kRate);
  }
  void TearDown() override {
    plugin_.reset();
    if (library_ != nullptr) ::dlclose(library_);
  }
  // All features of a run over `x`, which begins at `from` on the host's time.
  Plugin::FeatureSet runOver(const std::vector<float>& x, std::size_t block, const Vamp::RealTime& from = {}) {
    Plugin::FeatureSet all;
    const auto keep = [&all](const Plugin::FeatureSet& some) {
      for (const auto& [output, features] : some)
        all[output].insert(all[output].end(), features.begin(), features.end());
    };
    for (std::size_t at = 0; at + block <= x.size(); at += block) {
      const float* channel = x.data() + at;
      keep(plugin_->process(
          &channel, from + Vamp::RealTime::frame2RealTime(static_cast<long>(at), static_cast<unsigned>(kRate))));
    }
    keep(plugin_->getRemainingFeatures());
    return all;
  }

  void* library_ = nullptr;
  const VampPluginDescriptor* first_ = nullptr;
  std::unique_ptr<Vamp::PluginHostAdapter> plugin_;
};

TEST_F(VampPlugin, ShowsWhereTheCutChatters) {
  plugin_->setParameter("teeth", kTeeth);
  plugin_->setParameter("speed", static_cast<float>(kSpeed));
  ASSERT_TRUE(plugin_->initialise(1, 1000, 1000));
  const auto x = aCut();
  const auto found = runOver(x, 1000, Vamp::RealTime(10, 0));
  const auto& states = found.at(0);
  // Side by side without a gap, from the first sample to the last.
  for (std::size_t k = 1; k < states.size(); ++k)
    EXPECT_EQ(states[k].timestamp, states[k - 1].timestamp + states[k - 1].duration);
  EXPECT_EQ(states.front().timestamp, Vamp::RealTime(10, 0));
  const Vamp::RealTime end = states.back().timestamp + states.back().duration;
  EXPECT_NEAR(end.sec + 1e-9 * end.nsec, 15.0, 1e-3);
  // And the program says the same of them.
  BlockRunOptions options;
  options.setup.rate = Hertz(static_cast<double>(kRate));
  options.setup.teeth = kTeeth;
  options.setup.nominalSpeed = Rpm(kSpeed);
  options.setup.channels.resize(1);
  options.setup.channels[0].quantity = SensorQuantity::Sound;
  auto run = BlockRun::build(options);
  ASSERT_TRUE(run.ok()) << run.error().line();
  double first = 0.0;
  (*run)->feed(x, Rpm{}, [&first](const StepInput&, const StepOutput& out) {
    if (out.verdicts[0].alarming() && first == 0.0) first = sinceEpoch(out.verdicts[0].time).value;
  });
  ASSERT_GT(first, 2.0);
  const auto alarm = std::find_if(states.begin(), states.end(), [](const Plugin::Feature& f) {
    return f.label.starts_with("onset") || f.label.starts_with("chatter");
  });
  ASSERT_NE(alarm, states.end());
  EXPECT_NEAR(alarm->timestamp.sec - 10 + 1e-9 * alarm->timestamp.nsec, first, 0.0051);  // from the block before it
  ASSERT_FALSE(found.at(2).empty());
  EXPECT_NEAR(found.at(2).back().values[0], kChatter_Hz, 10.0);
}

// A label of which each block may change a digit would fall into hundreds of pieces.
TEST_F(VampPlugin, AStretchIsOfOneStateAndReasonWhateverTheNumbersDoMeanwhile) {
  plugin_->setParameter("teeth", kTeeth);
  plugin_->setParameter("speed", static_cast<float>(kSpeed));
  ASSERT_TRUE(plugin_->initialise(1, 1000, 1000));
  constexpr double kRise = 8.0;  // [Hz/s]
  const auto found = runOver(aCut(kRise), 1000);
  std::vector<std::string> labels;
  for (const Plugin::Feature& f : found.at(0)) {
    labels.push_back(f.label);
    ASSERT_EQ(f.values.size(), 1U);
    EXPECT_EQ(f.label.starts_with("not judged"), f.values[0] == 0.0F) << f.label;
    EXPECT_EQ(f.label.starts_with("air"), f.values[0] == 1.0F) << f.label;
    EXPECT_EQ(f.label.starts_with("stable"), f.values[0] == 2.0F) << f.label;
    EXPECT_EQ(f.label.starts_with("onset"), f.values[0] == 3.0F) << f.label;
    EXPECT_EQ(f.label.starts_with("chatter"), f.values[0] == 4.0F) << f.label;
    for (const char c : f.label) EXPECT_TRUE(c >= ' ' && c <= '~') << f.label;
  }
  EXPECT_THAT(labels, ::testing::Contains("not judged: still learning"));
  EXPECT_THAT(labels, ::testing::Contains("stable"));
  EXPECT_EQ(std::count_if(labels.begin(), labels.end(), [](const auto& l) { return l.starts_with("onset at"); }), 1);
  EXPECT_EQ(std::count_if(labels.begin(), labels.end(), [](const auto& l) { return l.starts_with("chatter at"); }), 1);
  // It names the median of what the other output shows in the same time.
  const Plugin::Feature& chatter = found.at(0).back();
  ASSERT_EQ(chatter.values[0], 4.0F);
  std::vector<float> shown;
  for (const Plugin::Feature& f : found.at(2)) {
    if (f.timestamp > chatter.timestamp) shown.push_back(f.values[0]);
  }
  std::sort(shown.begin(), shown.end());
  ASSERT_GT(shown.back() - shown.front(), 0.5 * kRise);
  const long median = std::lround(shown[shown.size() / 2]);
  EXPECT_EQ(chatter.label, "chatter at " + std::to_string(median) + " Hz");
}

// Programs that keep labels (Audacity) offer outputs of variable rate: one label a value would be 200 a second.
TEST_F(VampPlugin, OnlyStatesAreOfVariableRateAndTheOthersStandOnTheirGrid) {
  using Output = Plugin::OutputDescriptor;
  const auto outputs = plugin_->getOutputDescriptors();
  ASSERT_EQ(outputs.size(), 3U);
  EXPECT_EQ(outputs[0].sampleType, Output::VariableSampleRate);
  EXPECT_TRUE(outputs[0].hasDuration);
  EXPECT_TRUE(outputs[0].isQuantized && outputs[0].hasKnownExtents);
  for (const Output& o : outputs) EXPECT_EQ(o.binCount, 1U) << o.identifier;
  EXPECT_EQ(outputs[1].sampleType, Output::FixedSampleRate);
  EXPECT_EQ(outputs[2].sampleType, Output::FixedSampleRate);
  // 5 ms are 220.5 samples here, and a block is whole.
  constexpr float kSoundRate = 44100.0F;
  plugin_ = std::make_unique<Vamp::PluginHostAdapter>(first_, kSoundRate);
  plugin_->setParameter("teeth", kTeeth);
  plugin_->setParameter("speed", static_cast<float>(kSpeed) * kSoundRate / kRate);
  ASSERT_TRUE(plugin_->initialise(1, 1000, 1000));
  const auto found = runOver(aCut(), 1000);
  for (const int k : {1, 2}) {
    const double rate = static_cast<double>(plugin_->getOutputDescriptors()[static_cast<std::size_t>(k)].sampleRate);
    EXPECT_NEAR(rate, 200.45, 0.01);
    double before = -1.0;
    for (const Plugin::Feature& f : found.at(k)) {
      const double place = (f.timestamp.sec + 1e-9 * f.timestamp.nsec) * rate;
      const bool last = &f == &found.at(k).back();  // of a block that did not become full
      EXPECT_NEAR(place, std::round(place), last ? 0.5 : 1e-3);
      EXPECT_GT(std::round(place), before);
      before = std::round(place);
    }
  }
}

TEST_F(VampPlugin, TheSameWhateverTheBlocksOfTheHost) {
  const auto x = aCut();
  plugin_->setParameter("teeth", kTeeth);
  plugin_->setParameter("speed", static_cast<float>(kSpeed));
  ASSERT_TRUE(plugin_->initialise(1, 1000, 1000));
  const auto wanted = runOver(x, 1000).at(1);
  for (const std::size_t block : {64UL, 4000UL}) {
    Vamp::PluginHostAdapter* again = plugin_.get();
    again->reset();
    ASSERT_TRUE(again->initialise(1, block, block));
    const auto found = runOver(x, block).at(1);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k].values, wanted[k].values);
  }
}

TEST_F(VampPlugin, SaysItsParametersAndRefusesWhatItCannotDo) {
  std::vector<std::string> ids;
  for (const auto& p : plugin_->getParameterDescriptors()) ids.push_back(p.identifier);
  EXPECT_THAT(ids, ::testing::ElementsAre("teeth", "speed", "sensor", "scale", "method"));
  const auto scale = plugin_->getParameterDescriptors()[3];
  EXPECT_GT(scale.minValue, 0.0F);
  EXPECT_THAT(scale.name, ::testing::HasSubstr("m/s2"));
  plugin_->setParameter("scale", 0.0F);
  EXPECT_TRUE(plugin_->initialise(1, 1000, 1000));
  EXPECT_FALSE(plugin_->initialise(0, 1000, 1000));
  EXPECT_FALSE(plugin_->initialise(33, 1000, 1000));
  EXPECT_FALSE(plugin_->initialise(1, 500, 1000));
  EXPECT_TRUE(plugin_->getRemainingFeatures().empty());
}

}  // namespace
}  // namespace stillcut::app
