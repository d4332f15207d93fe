// ChatterPlugin: Stillcut's detectors as a Vamp plugin, so that Sonic Visualiser, Audacity and other programs for sound
// show where a cut chatters. What cannot be heard in the samples (teeth, spindle speed, kind of sensor) are its
// parameters. Thread: the host's, one at a time.
#pragma once

#include <vamp-sdk/Plugin.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/embed/block_run.h"
#include "core/model/reason.h"
#include "core/model/verdict.h"

namespace stillcut::app {

class ChatterPlugin final : public Vamp::Plugin {
 public:
  explicit ChatterPlugin(float rate) : Vamp::Plugin(rate) {}

  std::string getIdentifier() const override { return "chatter"; }
  std::string getName() const override { return "Milling chatter"; }
  std::string getDescription() const override { return "Where a milling cut chatters, and at which frequency"; }
  std::string getMaker() const override { return "Stillcut"; }
  int getPluginVersion() const override { return 1; }
  std::string getCopyright() const override;
  InputDomain getInputDomain() const override { return TimeDomain; }
  std::size_t getPreferredBlockSize() const override { return 1024; }
  std::size_t getPreferredStepSize() const override { return 0; }  // as the block
  std::size_t getMinChannelCount() const override { return 1; }
  std::size_t getMaxChannelCount() const override;

  ParameterList getParameterDescriptors() const override;
  float getParameter(std::string id) const override;
  void setParameter(std::string id, float value) override;
  OutputList getOutputDescriptors() const override;

  bool initialise(std::size_t channels, std::size_t step, std::size_t block) override;
  void reset() override;
  FeatureSet process(const float* const* inputBuffers, Vamp::RealTime timestamp) override;
  FeatureSet getRemainingFeatures() override;

 private:
  enum Output { kStates, kEnergyRatio, kFrequency };
  // Of one state and, where that was not judged, one reason. What changes from block to block starts no new one.
  struct Stretch {
    int state = 0;  // 0 not judged, 1 air cutting, 2 stable, 3 onset, 4 chatter
    Reason why;     // of its first block
    Vamp::RealTime from, to;
    std::vector<double> frequencies;  // of the chatter [Hz]

    bool holds(const Verdict& verdict) const;
    std::string label() const;
  };
  bool build();
  BlockRun::Took taker(FeatureSet& found);
  void take(const Verdict& verdict, FeatureSet& found);
  void endStretch(FeatureSet& found);
  OutputDescriptor series(const char* id, const char* name, const char* about, const char* unit) const;
  Vamp::RealTime timeOf(Instant moment) const;

  std::vector<float> values_;  // of the parameters; empty: the defaults
  std::size_t channels_ = 0, frames_ = 0;
  std::unique_ptr<BlockRun> run_;
  std::vector<float> sideBySide_;  // one block of the host's, frame by frame
  std::optional<Vamp::RealTime> began_;
  std::optional<Stretch> stretch_;
};

}  // namespace stillcut::app
