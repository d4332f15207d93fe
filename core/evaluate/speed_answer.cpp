#include "core/evaluate/speed_answer.h"

#include <cmath>
#include <cstdio>

namespace stillcut::evaluate {
namespace {

constexpr double kSlowest = 0.5, kFastest = 2.0;  // of the present speed, where no reach is given
// A spindle runs a percent or two off what is programmed: nearer pockets than that cannot be aimed at.
constexpr double kSpeedDoubt = 0.02;

std::string whole(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", value);
  return text;
}

std::string millimetres(Metres depth) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", 1e3 * depth.value);
  return text;
}

Message whyNone(const control::SpeedQuestion& q) {
  if (!(q.chatter.value > 0.0)) return message("the frequency of the chatter is not known");
  if (q.teeth <= 0) return message("no speed follows while the number of teeth is not known");
  if (!(q.present.value > 0.0)) return message("no speed follows while the spindle speed is not known");
  if (q.known != nullptr && q.known->ranges.empty()) {
    return message("no speed in reach is stable at a depth of %1 mm, %2 mm at %3 rpm would be",
                   millimetres(q.known->depth), millimetres(q.known->largestStableDepth),
                   whole(q.known->largestDepthSpeed.value));
  }
  return message("no stable speed lies between %1 and %2 rpm", whole(q.reach.low.value), whole(q.reach.high.value));
}

}  // namespace

SpeedAnswer answerSpeed(const SpeedRequest& request) {
  control::SpeedQuestion question = request.question;
  if (!std::isfinite(question.reach.high.value) || !(question.reach.high > question.reach.low)) {
    question.reach = {question.present * kSlowest, question.present * kFastest};
  }
  SpeedAnswer answer;
  answer.chatter = question.chatter;
  answer.teeth = question.teeth;
  answer.present = question.present;
  answer.depthLimit = request.depthLimit;
  if (question.teeth > 0 && question.present.value > 0.0)
    answer.waves = question.chatter / toothPassing(question.present, question.teeth);
  answer.choices = control::speedChoices(question);
  if (answer.choices.empty()) {
    answer.why = whyNone(question);
  } else if (question.known == nullptr && 0.5 / answer.waves < kSpeedDoubt) {
    answer.why = message("stable speeds are only %1 rpm apart here, so that less depth is the surer way",
                         whole(question.present.value / answer.waves));
  }
  return answer;
}

}  // namespace stillcut::evaluate
