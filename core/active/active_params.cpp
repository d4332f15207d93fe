#include "core/active/active_params.h"

#include <array>

namespace stillcut::active {
namespace {

using config::booleanParam;
using config::choiceParam;
using config::integerParam;
using config::locked;
using config::ParamDecl;
using config::realParam;

constexpr std::array<std::string_view, 2> kReferences{"error", "internal-model"};

constexpr std::array<std::string_view, 2> kFeedbacks{"acceleration", "force"};

constexpr ParamDecl kFeedback =
    locked(choiceParam("active.feedback", "Feedback", 0, kFeedbacks,
                       "In simulation: what is to fall, vibration by the accelerometers or the force at the spindle's "
                       "frequency"));
constexpr ParamDecl kTaps = locked(integerParam("active.taps", "Taps", 35, 1, kMostTaps,
                                                "Length of the adaptive filter of each axis (Ford 2013 table 3: 35)"));
constexpr ParamDecl kStep =
    realParam("active.step", "Step", "", 0.02, 0.0, 1.0,
              "Adaptation step mu; while 'normalised' is on, as a fraction of the largest stable step");
constexpr ParamDecl kNormalised =
    locked(booleanParam("active.normalised", "Normalised", true,
                        "Take the step as a fraction of the bound that follows the power of the filtered reference"));
constexpr ParamDecl kLeak = realParam("active.leak", "Leak", "", 1.0, 0.9, 1.0,
                                      "Factor on the weights at each sample (gamma of eq. 2); 1 forgets nothing");
constexpr ParamDecl kReference =
    locked(choiceParam("active.reference", "Reference", 1, kReferences,
                       "What the filter works from: the error itself, or the disturbance as the model sees it"));
constexpr ParamDecl kEmphasis = locked(
    realParam("active.emphasis", "Emphasis", "", 20.0, 1.0, 1000.0,
              "How much more the error counts on the lines to quieten than elsewhere, as amplitudes; 1: no more"));
constexpr ParamDecl kEmphasisWidth = locked(realParam("active.emphasis-width", "Width of the emphasis", "Hz", 40.0, 1.0,
                                                      1000.0, "Around each of the lines to quieten"));
constexpr ParamDecl kPathTaps =
    locked(integerParam("active.path-taps", "Path taps", 35, 1, kMostTaps,
                        "Length of each part of the recursive model from actuator to sensor (table 3: 35)"));

constexpr std::array<std::string_view, 2> kExcitations{"noise", "sweep"};
constexpr ParamDecl kExcitation = locked(choiceParam("active.excitation", "Excitation", 0, kExcitations,
                                                     "What moves the table while its paths are identified"));
constexpr ParamDecl kRecordLevel = locked(realParam("active.identify-level", "Level of identification", "", 0.1, 0.001,
                                                    0.3, "Rms of the excitation, as a fraction of the stroke"));
constexpr ParamDecl kRecordTime = locked(realParam("active.identify-time", "Time of identification", "s", 4.0, 0.5,
                                                   60.0, "Length of the record it is made from"));
constexpr ParamDecl kModelAge = locked(realParam("active.model-age", "Age of a model", "min", 60.0, 1.0, 1440.0,
                                                 "An older model of the path is not started with"));
constexpr ParamDecl kAuxiliary = locked(
    realParam("active.auxiliary", "Auxiliary noise", "", 0.0, 0.0, 0.1,
              "Rms of the noise that identifies the path anew while it controls, as a fraction of the stroke; 0: off"));
constexpr ParamDecl kBlockFrames = locked(integerParam("active.block-frames", "Frames of a block", 1, 1, 4096,
                                                       "In simulation: how many samples the device takes at a time"));

constexpr std::array<const ParamDecl*, 15> kAll{
    &kFeedback,      &kTaps,       &kStep,        &kNormalised, &kLeak,     &kReference, &kPathTaps,   &kEmphasis,
    &kEmphasisWidth, &kExcitation, &kRecordLevel, &kRecordTime, &kModelAge, &kAuxiliary, &kBlockFrames};

}  // namespace

config::ParamTable activeParams() {
  return kAll;
}

FxlmsOptions fxlmsOptions(const config::ParamSet& params) {
  FxlmsOptions o;
  o.filter.taps = params.integer(kTaps);
  o.filter.step = params.real(kStep);
  o.filter.normalised = params.boolean(kNormalised);
  o.filter.leak = params.real(kLeak);
  o.reference = params.choice(kReference) == 0 ? Reference::ErrorFeedback : Reference::InternalModel;
  o.emphasis.gain = params.real(kEmphasis);
  o.emphasis.width = Hertz(params.real(kEmphasisWidth));
  return o;
}

PathRequest pathRequest(const config::ParamSet& params) {
  PathRequest request;
  request.filter.forward = request.filter.backward = params.integer(kPathTaps);
  return request;
}

RecordRequest recordRequest(const config::ParamSet& params) {
  RecordRequest request;
  request.excitation = params.choice(kExcitation) == 0 ? Excitation::Noise : Excitation::Sweep;
  request.rms = params.real(kRecordLevel);
  request.duration = Seconds(params.real(kRecordTime));
  return request;
}

Seconds oldestModel(const config::ParamSet& params) {
  return Seconds(60.0 * params.real(kModelAge));
}

double auxiliaryShare(const config::ParamSet& params) {
  return params.real(kAuxiliary);
}

int simulatedFrames(const config::ParamSet& params) {
  return params.integer(kBlockFrames);
}

bool forceFeedback(const config::ParamSet& params) {
  return params.choice(kFeedback) == 1;
}

}  // namespace stillcut::active
