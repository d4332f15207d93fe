#include "core/evaluate/series_log.h"

#include <charconv>
#include <cmath>

#include "core/storage/atomic_file.h"

namespace stillcut::evaluate {
namespace {

void append(std::string& text, double v) {
  if (!std::isfinite(v)) return;  // an indicator without a value is an empty cell
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, v, std::chars_format::general, 9);
  text.append(buffer, end.ptr);
}

}  // namespace

SeriesLog::SeriesLog(std::span<const detect::DetectorInfo> detectors, Instant begin, std::span<const std::string> more)
    : begin_(begin), text_("t") {
  for (const detect::DetectorInfo& info : detectors) {
    counts_.push_back(info.indicators.size());
    for (std::string_view indicator : info.indicators) {
      text_.append(",").append(info.id).append(".").append(indicator);
    }
    for (const char* column : {"state", "valid", "speed_rpm"})
      text_.append(",").append(info.id).append(".").append(column);
  }
  for (const std::string& column : more) text_.append(",").append(column);
  text_ += '\n';
}

void SeriesLog::observe(std::span<const Verdict> verdicts, std::span<const double> more) {
  if (verdicts.empty()) return;
  append(text_, secondsBetween(begin_, verdicts.front().time).value);
  for (std::size_t d = 0; d < verdicts.size() && d < counts_.size(); ++d) {
    for (std::size_t i = 0; i < counts_[d]; ++i) {
      text_ += ',';
      append(text_, verdicts[d].indicators[i]);
    }
    const Verdict& v = verdicts[d];
    text_.append(",").append(name(v.state)).append(v.valid ? ",1," : ",0,");
    if (v.spindle.value > 0.0) append(text_, toRpm(v.spindle).value);
  }
  for (const double value : more) {
    text_ += ',';
    append(text_, value);
  }
  text_ += '\n';
}

Status SeriesLog::write(const std::string& path) const {
  return writeFileAtomically(path, text_);
}

}  // namespace stillcut::evaluate
