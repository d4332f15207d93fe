#include "core/evaluate/answer_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stillcut::evaluate {
namespace {

constexpr Seconds kShortest{0.05};  // shortest part of the rest that is named
constexpr std::size_t kMostChoices = 2;
constexpr double kRoundFrom = 1000.0;  // rev/min: speeds are rounded to tens from here on

std::string speedText(Rpm speed, const AnswerWriting& w) {
  return w.speed(speed.value >= kRoundFrom ? Rpm(10.0 * std::round(speed.value / 10.0)) : speed);
}

// Of a stretch of time, for which the numbers of one moment mean nothing.
Message::Argument whyText(const Reason& reason, const AnswerWriting& w) {
  if (reason.code == ReasonCode::Learning) return message("learning the stable cut");
  if (reason.code == ReasonCode::Transient) return message("the tool enters or leaves");
  if (reason.code == ReasonCode::InputGap) return message("samples are missing");
  return w.reason(reason);
}

std::string seconds(Seconds time, const AnswerWriting& w) {
  return w.number(time.value, time.value < 1.0 ? 2 : 1);
}

Message lessDepth(const SpeedAnswer& advice, const AnswerWriting& w) {
  if (!(advice.depthLimit.value > 0.0)) return message("less depth");
  return message("less than %1 mm of depth", w.number(1e3 * advice.depthLimit.value, 2));
}

Message trySpeeds(const SpeedAnswer& a, const AnswerWriting& w) {
  const Message depth = lessDepth(a, w);
  const SpeedChoice& first = a.choices.front();
  if (first.basis == SpeedBasis::Lobes) {
    return message("try %1 rpm (stable from %2 to %3 rpm by the lobes), or %4", speedText(first.speed, w),
                   speedText(first.from, w), speedText(first.to, w), depth);
  }
  const std::string hertz = w.number(a.chatter.value, 0);
  const std::string now = wavesText(a.waves, w);
  if (a.choices.size() < kMostChoices) {
    return message("try %1 rpm (%2 waves of %3 Hz between two teeth instead of %4), or %5", speedText(first.speed, w),
                   wavesText(first.waves, w), hertz, now, depth);
  }
  const SpeedChoice& second = a.choices[1];
  return message("try %1 or %2 rpm (%3 or %4 waves of %5 Hz between two teeth instead of %6), or %7",
                 speedText(first.speed, w), speedText(second.speed, w), wavesText(first.waves, w),
                 wavesText(second.waves, w), hertz, now, depth);
}

}  // namespace

AnswerWriting englishWriting() {
  AnswerWriting writing;
  writing.number = [](double value, int decimals) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return std::string(text);
  };
  writing.speed = [](Rpm speed) {
    std::string text = std::to_string(std::lround(speed.value));
    for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
    return text;
  };
  writing.reason = [](const Reason& reason) { return sentence(reason); };
  return writing;
}

std::string wavesText(double waves, const AnswerWriting& writing) {
  constexpr double kExact = 1e-6;
  const double whole = std::floor(waves + kExact);
  const double part = waves - whole;
  if (std::abs(part) < kExact) return writing.number(whole, 0);
  if (std::abs(part - 0.5) > kExact) return writing.number(waves, 2);
  return (whole > 0.0 ? writing.number(whole, 0) : std::string()) + "\u00bd";
}

Message findingSentence(const RecordingAnswer& a, const AnswerWriting& w) {
  if (a.finding == Finding::NoChatter) return message("no chatter");
  if (a.finding == Finding::NotJudged) {
    if (a.notJudged.empty()) return message("not judged: no cut was measured");
    const Seconds cut = a.length - a.air;
    if (a.judged.value > 0.0) {
      return message("not judged: only %1 of %2 s in the cut could be, mainly because %3", seconds(a.judged, w),
                     seconds(cut, w), whyText(a.notJudged.front().reason, w));
    }
    return message("not judged: %1", whyText(a.notJudged.front().reason, w));
  }
  const std::string from = w.number(a.firstAlarm.value, 1);
  if (!(a.chatter.value > 0.0)) return message("chatter from %1 s on", from);
  return message("chatter at %1 Hz from %2 s on", w.number(a.chatter.value, 0), from);
}

Message adviceSentence(const SpeedAnswer& advice, const AnswerWriting& writing) {
  if (advice.choices.empty()) {
    if (advice.why.empty()) return {};
    return message("%1; take %2", advice.why, lessDepth(advice, writing));
  }
  const Message speeds = trySpeeds(advice, writing);
  return advice.why.empty() ? speeds : message("%1; %2", speeds, advice.why);
}

Message judgedSentence(const RecordingAnswer& a, const AnswerWriting& w) {
  std::vector<Message> rest;
  if (a.air >= kShortest) rest.push_back(message("%1 s of air cutting", seconds(a.air, w)));
  for (const UnjudgedTime& t : a.notJudged) {
    if (t.time >= kShortest) rest.push_back(message("%1 s: %2", seconds(t.time, w), whyText(t.reason, w)));
  }
  if (rest.empty()) return message("judged %1 of %2 s", seconds(a.judged, w), seconds(a.length, w));
  return message("judged %1 of %2 s; the rest: %3", seconds(a.judged, w), seconds(a.length, w),
                 Message::Argument(rest, ", "));
}

Message hearingSentence(const RecordingAnswer& a, const AnswerWriting& w) {
  return message("chatter can be detected up to %1 Hz", w.number(10.0 * std::floor(0.1 * a.hearsTo.value), 0));
}

std::vector<Message> channelSentences(const RecordingAnswer& a, const AnswerWriting& w) {
  std::vector<Message> lines;
  for (const LeftOutChannel& out : a.leftOut) {
    lines.push_back(message("channel %1 (%2) is no vibration and was left out: %3", out.index, out.name, out.why));
  }
  for (const ChannelAnswer& channel : a.channels) {
    if (channel.faults.empty()) continue;
    const UnjudgedTime& worst = channel.faults.front();
    lines.push_back(message("channel %1 (%2) was not in order for %3 s: %4", channel.index, channel.name,
                            seconds(worst.time, w), whyText(worst.reason, w)));
  }
  return lines;
}

}  // namespace stillcut::evaluate
