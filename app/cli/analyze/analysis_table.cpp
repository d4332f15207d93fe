#include "app/cli/analyze/analysis_table.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/cli/json_line.h"
#include "core/evaluate/answer_json.h"
#include "core/evaluate/answer_text.h"

namespace stillcut::app {
namespace {

std::string figure(double value, const char* format) {
  if (!std::isfinite(value)) return "-";
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// Of what the alarms named, relative; not a number: no alarm, or nobody has said where the chatter was.
double frequencyError(const evaluate::RecordedTruth& truth, const evaluate::VerdictLog::Summary& s) {
  return truth.chatter && s.alarms > 0 ? s.frequency_Hz / truth.chatter->value - 1.0
                                       : std::numeric_limits<double>::quiet_NaN();
}

void printOwnValues(const std::vector<evaluate::AutoValueLog::Entry>& values) {
  if (!values.empty()) std::printf("set by itself, as last known\n");
  for (const evaluate::AutoValueLog::Entry& e : values) {
    const std::string value = std::isfinite(e.value) ? figure(e.value, "%.4g ") + std::string(e.decl->unit) : "-";
    std::printf("  %-26s %-12s %s\n", std::string(e.decl->key).c_str(), value.c_str(), std::string(e.why).c_str());
  }
}

nlohmann::json ownJson(const std::vector<evaluate::AutoValueLog::Entry>& values) {
  nlohmann::json array = nlohmann::json::array();
  for (const evaluate::AutoValueLog::Entry& e : values) {
    array.push_back({{"key", e.decl->key},
                     {"value", std::isfinite(e.value) ? nlohmann::json(e.value) : nlohmann::json()},
                     {"unit", e.decl->unit},
                     {"why", e.why}});
  }
  return array;
}

void printScore(const evaluate::AlarmScore& s, double error) {
  const std::string found = s.spans > 0 ? std::to_string(s.found) + "/" + std::to_string(s.spans) : "-";
  std::printf(" %7s %10s %9s %6d", found.c_str(), figure(s.delayQuantile(0.5), "%.3f s").c_str(),
              figure(100.0 * error, "%+.2f %%").c_str(), s.falseAlarms);
}

// What was not judged has no number of alarms.
void printRow(const evaluate::VerdictLog::Summary& s, Finding finding) {
  if (s.alarms > 0) {
    std::printf("%-14s %6d %12s %11s %11s %11s %9.2f", s.detector.c_str(), s.alarms,
                figure(s.firstAlarm_s, "%.3f s").c_str(), figure(s.alarmTime_s, "%.3f s").c_str(),
                figure(s.chatterTime_s, "%.3f s").c_str(), figure(s.frequency_Hz, "%.1f Hz").c_str(), s.worstSeverity);
  } else {
    std::printf("%-14s %6s %12s %11s %11s %11s %9s", s.detector.c_str(), finding == Finding::NotJudged ? "-" : "0", "-",
                "-", "-", "-", "-");
  }
}

nlohmann::json scoreJson(const evaluate::AlarmScore& s, double error) {
  const double delay = s.delayQuantile(0.5);
  return {{"spans", s.spans},
          {"found", s.found},
          {"missed", s.missed()},
          {"false_alarms", s.falseAlarms},
          {"delay_median_s", std::isfinite(delay) ? nlohmann::json(delay) : nlohmann::json()},
          {"frequency_error", std::isfinite(error) ? nlohmann::json(error) : nlohmann::json()}};
}

// Columns that were not even read as channels.
Message whySkipped(const record::RecordingFormat& format, std::size_t i) {
  const bool told = i < format.skippedWhy.size() && !format.skippedWhy[i].empty();
  return told ? format.skippedWhy[i] : message("it is no vibration");
}

void printSkipped(const record::RecordingFormat& format) {
  for (std::size_t i = 0; i < format.skipped.size(); ++i) {
    std::printf("  '%s' is left out: %s\n", format.skipped[i].c_str(), text(whySkipped(format, i)).c_str());
  }
}

void addSkipped(nlohmann::json& leftOut, const record::RecordingFormat& format) {
  for (std::size_t i = 0; i < format.skipped.size(); ++i) {
    leftOut.push_back({{"channel", nullptr}, {"name", format.skipped[i]}, {"reason", text(whySkipped(format, i))}});
  }
}

void printAnswer(const std::string& recording, const RecordingAnswer& answer) {
  const evaluate::AnswerWriting writing = evaluate::englishWriting();
  std::printf("%s: %s\n", recording.c_str(), text(evaluate::findingSentence(answer, writing)).c_str());
  std::vector<Message> lines;
  if (answer.finding == Finding::Chatter) lines.push_back(evaluate::adviceSentence(answer.advice, writing));
  lines.push_back(evaluate::judgedSentence(answer, writing));
  lines.push_back(evaluate::hearingSentence(answer, writing));
  for (Message& line : evaluate::channelSentences(answer, writing)) lines.push_back(std::move(line));
  for (const Message& line : lines) {
    if (!line.empty()) std::printf("  %s\n", text(line).c_str());
  }
}

}  // namespace

void printTable(const Analysis& a) {
  printAnswer(a.recording, a.answers.front());
  printSkipped(a.format);
  std::printf("%s, %zu channel(s) at %.6g Hz, %.3f s\n", a.format.kind.c_str(), a.format.channels.size(),
              a.format.rate.value, a.format.length().value);
  for (const std::string& remark : a.remarks) std::printf("%s\n", remark.c_str());
  if (a.truth) std::printf("truth from %s\n", a.truth->from.c_str());
  std::printf("%-14s %6s %12s %11s %11s %11s %9s", "detector", "alarms", "first alarm", "in alarm", "in chatter",
              "frequency", "worst ER");
  if (a.truth) std::printf(" %7s %10s %9s %6s", "found", "delay", "f error", "false");
  std::printf("\n");
  for (std::size_t d = 0; d < a.detectors.size(); ++d) {
    const evaluate::VerdictLog::Summary& s = a.detectors[d];
    printRow(s, a.answers[d].finding);
    if (a.truth) printScore(a.scores[d], frequencyError(*a.truth, s));
    std::printf("\n");
    if (s.validTime_s <= 0.0 && !s.lastReason.empty()) {
      std::printf("%-14s no valid verdict: %s\n", "", s.lastReason.c_str());
    }
  }
  printOwnValues(a.own);
}

void printAnswerLine(const Analysis& a) {
  nlohmann::json object = jsonObject("analyze", "answer");
  object["recording"] = a.recording;
  object["answer"] = evaluate::toJson(a.answers.front());
  addSkipped(object["answer"]["left_out"], a.format);
  object["kind"] = a.format.kind;
  object["rate_hz"] = a.format.rate.value;
  object["channels"] = a.format.channels.size();
  object["length_s"] = a.format.length().value;
  object["started_utc_ms"] =
      a.format.started_ns > 0 ? nlohmann::json(a.format.started_ns / 1'000'000) : nlohmann::json();
  object["remarks"] = a.remarks;
  object["truth"] = a.truth ? nlohmann::json(a.truth->from) : nlohmann::json();
  object["detectors"] = nlohmann::json::array();
  object["own_values"] = ownJson(a.own);
  for (std::size_t d = 0; d < a.detectors.size(); ++d) {
    nlohmann::json row;
    toJson(row, a.detectors[d]);
    evaluate::addJudged(row, a.answers[d]);
    row["score"] = a.truth ? scoreJson(a.scores[d], frequencyError(*a.truth, a.detectors[d])) : nlohmann::json();
    object["detectors"].push_back(row);
  }
  printJsonLine(object);
}

}  // namespace stillcut::app
