// Detector: one published method. How to add one: core/detect/ADDING.md.
// Thread: everything on the worker. prepare() may allocate, plan and throw; process() and reset() may do none of it.
#pragma once

#include <span>
#include <string_view>

#include "core/config/param_set.h"
#include "core/model/cut_setup.h"
#include "core/model/verdict.h"
#include "core/sensing/auto_values.h"
#include "core/sensing/conditioned_block.h"

namespace stillcut::detect {

struct DetectorInfo {
  std::string_view id;      // "energy-ratio": the name in files and on the command line
  std::string_view label;   // "Energy ratio"
  std::string_view source;  // "Caliskan 2018"
  // Columns of --series and of Verdict::indicators, in order ("er", "frequency_hz"). At most kMaxIndicators.
  std::span<const std::string_view> indicators;
};

class Detector {
 public:
  virtual ~Detector() = default;

  virtual DetectorInfo describe() const = 0;  // the same before and after prepare(); any thread

  // Sizes every buffer for the setup (rate, channels, longest block). May allocate, plan and throw std::runtime_error
  // with one clear line. Leaves the detector as after reset().
  virtual void prepare(const CutSetup& setup, const config::ParamSet& params) = 0;

  // One block in order. Real-time: no allocation, lock or text. It must not throw; should it all the same, or retune()
  // or reset(), the chain takes that as a fault and falls back: nothing inside may be noexcept, which would end the
  // program. Every verdict carries the block's end time and sequence; an invalid block gives an invalid verdict with
  // the block's reason and changes no learned state.
  virtual Verdict process(const ConditionedBlock& block) = 0;

  // New values of parameters that are not locked while running; what was learned stays. A part whose parameters are all
  // locked needs none. Between blocks, real-time. Before the first block it does the same as prepare() with them.
  virtual void retune(const config::ParamSet& /*params*/) {}
  // After prepare(): what the detector chose for a parameter left automatic, in the declaration's unit. Not a number:
  // it depends on what is learned while running. Set-up thread.
  virtual double chosen(const config::ParamDecl& /*decl*/) const { return config::kAutomatic; }

  // What it has set itself, by parameters that are automatic and by what it learns: the value now and its reason, in
  // the order of autoValues(), which is the same always. own(): any thread.
  virtual AutoValueTable autoValues() const { return {}; }
  virtual AutoValue own(std::size_t /*index*/) const { return {}; }

  // Forgets everything learned. Real-time.
  virtual void reset() = 0;
};

}  // namespace stillcut::detect
