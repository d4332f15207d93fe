#include "core/milling/stability/advice/pitch_advice.h"

#include <algorithm>
#include <array>

#include "core/milling/stability/exact_lobes.h"
#include "core/milling/stability/lobe_refine.h"

namespace stillcut::milling {

namespace {

constexpr double kSearched = 3.0;                           // times the depth
constexpr std::array kSpeeds{0.98, 0.99, 1.0, 1.01, 1.02};  // times the speed
constexpr double kLargest = 0.35;                           // of the even pitch
constexpr double kCoarse = 0.025, kFine = 0.005;

enum class Pattern { Alternating, Rising };

std::vector<double> pitches(int teeth, Pattern pattern, double share) {
  const double even = kTwoPi / teeth;
  std::vector<double> list;
  for (int j = 0; j < teeth; ++j) {
    const double along = teeth > 1 ? 2.0 * j / (teeth - 1) - 1.0 : 0.0;
    list.push_back(even * (1.0 + share * (pattern == Pattern::Rising ? along : j % 2 == 0 ? -1.0 : 1.0)));
  }
  return list;
}

class Search {
 public:
  Search(const CutModel& model, Rpm speed, Metres depth, std::string where, std::stop_token stop)
      : model_(model), speed_(speed), searched_(kSearched * depth), where_(std::move(where)), stop_(std::move(stop)) {}

  Result<PitchAdvice> run() {
    PitchAdvice advice;
    advice.searched = searched_;
    const auto even = tried({});
    if (!even) return even.error();
    advice.even = even.value();
    advice.even.pitch.assign(static_cast<std::size_t>(model_.tool.teeth), kTwoPi / model_.tool.teeth);
    advice.best = advice.even;
    for (Pattern pattern : {Pattern::Alternating, Pattern::Rising}) {
      // Two teeth that alternate are two that rise; with an odd number two neighbours would be alike.
      if (pattern == Pattern::Alternating && (model_.tool.teeth % 2 == 1 || model_.tool.teeth == 2)) continue;
      if (Status ok = along(pattern, advice.best); !ok) return ok.error();
    }
    return advice;
  }

 private:
  Status along(Pattern pattern, PitchChoice& best) {
    double bestShare = 0.0;
    const auto look = [&](double from, double to, double step) -> Status {
      for (double share = from; share <= to + 1e-9 && !stop_.stop_requested(); share += step) {
        auto choice = tried(pitches(model_.tool.teeth, pattern, share));
        if (!choice) return choice.error();
        if (!(choice->limit > best.limit)) continue;
        best = std::move(choice.value());
        bestShare = share;
      }
      return Done{};
    };
    if (Status ok = look(kCoarse, kLargest, kCoarse); !ok || bestShare == 0.0) return ok;
    return look(std::max(kFine, bestShare - kCoarse), std::min(kLargest, bestShare + kCoarse), kFine);
  }

  Result<PitchChoice> tried(std::vector<double> pitch) const {
    CutModel model = model_;
    model.tool.pitch = pitch;
    const auto lobes = ExactLobes::make(model, where_);
    if (!lobes) return lobes.error();
    PitchChoice choice{std::move(pitch), searched_};
    for (double share : kSpeeds) {
      const auto limits = lobes->limits(share * speed_, {searched_, true, false, {}}, stop_);
      if (!limits) return limits.error();
      choice.limit = std::min(choice.limit, limitingDepth(limits.value()));
    }
    return choice;
  }

  const CutModel& model_;
  Rpm speed_;
  Metres searched_;
  std::string where_;
  std::stop_token stop_;
};

}  // namespace

Result<PitchAdvice> advisePitch(const CutModel& model, Rpm speed, Metres depth, const std::string& where,
                                const std::stop_token& stop) {
  if (model.tool.teeth < 2) return Error{where + ": tool", message("one tooth has no pitch to choose")};
  if (!model.tool.toothHelix.empty()) {
    return Error{where + ": tool", message("pitches are chosen for teeth of one helix")};
  }
  return Search(model, speed, depth, where, stop).run();
}

}  // namespace stillcut::milling
