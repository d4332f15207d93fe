#include "ui/models/history/analyse_view.h"

#include <algorithm>
#include <cmath>

#include "ui/models/history/run_history.h"

namespace stillcut::ui {

AnalyseView::AnalyseView(QObject* parent) : QObject(parent), longest_(RunHistory::kKept) {}

void AnalyseView::setOptions(const AnalyseOptions& options) {
  AnalyseOptions o = options;
  o.span = std::clamp(o.span, kShortest, longest_);
  const double top = top_.value > 0.0 ? top_.value : 1e6;
  o.high.value = std::clamp(o.high.value, kNarrowest.value, top);
  o.low.value = std::clamp(o.low.value, 0.0, o.high.value - kNarrowest.value);
  o.channel = std::max(o.channel, 0);
  if (o == options_) return;
  options_ = o;
  emit changed();
}

void AnalyseView::setReach(Instant first, Instant newest, Hertz top) {
  first_ = first;
  newest_ = newest;
  top_ = top;
  if (top_.value > 0.0 && options_.high > top_) setOptions(options_);
}

void AnalyseView::setWhole(Seconds length, Hertz top) {
  whole_ = true;
  first_ = Instant{};
  newest_ = first_ + toDuration(length);
  top_ = top;
  longest_ = std::max(length, kShortest);
  following_ = true;
  options_.span = longest_;
  options_.low = Hertz();
  options_.high = top;
  emit changed();
}

void AnalyseView::setLength(Seconds length) {
  const Instant end = first_ + toDuration(length);
  if (!whole_ || end == newest_) return;
  newest_ = end;
  longest_ = std::max(length, kShortest);
  options_.span = following_ ? longest_ : std::min(options_.span, longest_);
  to_ = std::clamp(to_, std::min(first_ + toDuration(options_.span), newest_), newest_);
  emit changed();
}

void AnalyseView::follow() {
  if (following_) return;
  following_ = true;
  if (whole_) options_.span = longest_;
  emit changed();
}

void AnalyseView::stand() {
  if (!following_) return;
  to_ = newest_;
  following_ = false;
}

void AnalyseView::goTo(Instant t) {
  stand();
  to_ = std::clamp(t, first_, std::max(first_, newest_)) + toDuration(options_.span * 0.5);
  emit changed();
}

// At least a sliver of what there is stays on show.
void AnalyseView::pan(Seconds by) {
  stand();
  // Of a recording that is complete there is nothing beyond its ends.
  const Duration sliver = whole_ ? toDuration(options_.span) : toDuration(options_.span * 0.1);
  const Instant earliest = first_ + sliver;
  const Instant latest = std::max(earliest, newest_ + toDuration(options_.span) - sliver);
  to_ = std::clamp(to_ + toDuration(by), earliest, latest);
  emit changed();
}

void AnalyseView::zoomTime(double factor, Instant around) {
  if (!std::isfinite(factor) || factor <= 0.0) return;
  if (whole_) stand();
  const Seconds span = std::clamp(options_.span * factor, kShortest, longest_);
  const double applied = span / options_.span;
  if (!following_) to_ = around + toDuration(secondsBetween(around, to_) * applied);
  options_.span = span;
  if (whole_) to_ = std::clamp(to_, std::min(first_ + toDuration(span), newest_), newest_);
  following_ = following_ || (whole_ && span >= longest_);
  emit changed();
}

void AnalyseView::showTimes(Instant from, Instant to) {
  if (secondsBetween(from, to) < kShortest) return;
  stand();
  to_ = to;
  options_.span = std::min(secondsBetween(from, to), longest_);
  emit changed();
}

void AnalyseView::panFrequency(Hertz by) {
  AnalyseOptions o = options_;
  const Hertz width = o.high - o.low;
  const Hertz highest = top_.value > 0.0 ? top_ : o.high;
  o.low = std::clamp(o.low + by, Hertz(), std::max(Hertz(), highest - width));
  o.high = o.low + width;
  setOptions(o);
}

void AnalyseView::zoomFrequency(double factor, Hertz around) {
  if (!std::isfinite(factor) || factor <= 0.0) return;
  AnalyseOptions o = options_;
  const Hertz width = std::max((o.high - o.low) * factor, kNarrowest);
  const double applied = width / (o.high - o.low);
  o.low = std::max(Hertz(), around - (around - o.low) * applied);
  o.high = o.low + width;
  setOptions(o);
}

void AnalyseView::showFrequencies(Hertz low, Hertz high) {
  if (high - low < kNarrowest) return;
  AnalyseOptions o = options_;
  o.low = low;
  o.high = high;
  setOptions(o);
}

void AnalyseView::setCursor(Cursor c, std::optional<Instant> t) {
  cursors_[c] = t;
  emit changed();
}

void AnalyseView::setHarmonic(std::optional<Hertz> f) {
  harmonic_ = f;
  emit changed();
}

void AnalyseView::restart() {
  following_ = true;
  cursors_ = {};
  harmonic_ = {};
  emit changed();
}

}  // namespace stillcut::ui
