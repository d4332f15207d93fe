// A desk with three recordings and a scripted replay; time passes when it is polled while it plays.
#pragma once

#include <string>
#include <vector>

#include "ui/facade/session_controller.h"

namespace stillcut::ui {

class FakeSessionDesk final : public SessionController {
 public:
  FakeSessionDesk() {
    const qint64 day = 86'400'000, november = 20'758 * day;
    entries_ = {
        {QStringLiteral("/rec/Housing/T12/2026-11-19.h5"), QStringLiteral("Housing"), QStringLiteral("T12 D12 Z4"),
         november + 18 * day + day / 3, 48'000'000, SessionEntry::Inside::Known, Seconds(754.0), 2},
        {QStringLiteral("/rec/Bracket/T3/2026-11-21.h5"), QStringLiteral("Bracket"), QStringLiteral("T3 D6 Z2"),
         november + 20 * day + day / 2, 9'400'000, SessionEntry::Inside::Known, Seconds(33'240.0), 0},
        {QStringLiteral("/rec/audio/face.wav"), QStringLiteral("face"), QStringLiteral("audio"),
         november + 19 * day + day / 4, 2'100'000}};
    auto summary = std::make_shared<SessionSummary>();
    summary->file = "/rec/Housing/T12/2026-11-19.h5";
    summary->kind = "Stillcut session";
    summary->session = true;
    summary->length = Seconds(30.0);
    summary->alarms = 2;
    summary->chatterTime = Seconds(2.5);
    for (int k = 0; k < 300; ++k) {
      const double t = 0.05 + 0.1 * k;
      const bool loud = (t > 8.0 && t < 9.5) || (t > 21.0 && t < 22.0);
      SummaryPoint point;
      point.time = Seconds(t);
      point.vibration = t < 1.0 || t > 28.0 ? 0.05 : loud ? 9.0 : 2.0 + 0.6 * ((k * 7919) % 13) / 13.0;
      point.valid = true;
      point.state = loud ? CutState::Chatter : CutState::Stable;
      point.gap = k == 150;
      summary->curve.push_back(point);
    }
    summary_ = std::move(summary);
  }

  bool poll() override {
    if (state.playing) state.position = Seconds(std::min(state.position.value + 0.04 * state.pace, 30.0));
    const bool was = changed;
    changed = false;
    return was;
  }
  QString folder() const override { return folder_; }
  void setFolder(const QString& folder) override {
    folder_ = folder;
    ++listed;
    changed = true;
  }
  const std::vector<SessionEntry>& entries() const override { return entries_; }
  void setEntries(std::vector<SessionEntry> entries) { entries_ = std::move(entries); }
  void lookInside(const QStringList& paths) override { lookedInto = paths; }
  const std::vector<SessionEntry>& scenarios() const override { return scenarios_; }
  void open(const QString& path) override {
    path_ = path;
    state.open = true;
    state.length = Seconds(30.0);
    changed = true;
  }
  // What is opened next.
  void showNext(std::shared_ptr<const SessionSummary> summary) { summary_ = std::move(summary); }
  QString openedPath() const override { return path_; }
  std::shared_ptr<const SessionSummary> summary() const override { return path_.isEmpty() ? nullptr : summary_; }
  ReplayState replay() const override { return state; }
  const Snapshot* replayed() override { return nullptr; }
  void play() override { state.playing = true; }
  void pause() override { state.playing = false; }
  void step(int blocks) override { steps += blocks; }
  void setPace(double times) override { state.pace = times; }
  void goTo(Seconds time) override { state.position = time; }
  void loop(Seconds from, Seconds to) override {
    state.looping = true;
    state.loopFrom = from;
    state.loopTo = to;
  }
  void endLoop() override { state.looping = false; }
  Status showEverywhere(bool on) override {
    if (on && refuse)
      return Error{message("replay"), message("the machine is under our authority"), message("set it to Off first")};
    everywhere = on;
    return Done{};
  }
  bool shownEverywhere() const override { return everywhere; }
  const std::vector<Marker>& markers() const override { return marks; }
  Seconds markerTime(const Marker& marker) const override { return sinceEpoch(marker.begin); }
  Status mark(Seconds from, Seconds to, const QString& label, const QString& note) override {
    Marker marker;
    marker.number = marks.size() + 1;
    marker.begin += toDuration(from);
    marker.end += toDuration(to);
    marker.label = label.toStdString();
    marker.note = note.toStdString();
    marks.push_back(marker);
    changed = true;
    return Done{};
  }
  Status changeMark(std::uint64_t number, const QString& label, const QString& note) override {
    for (Marker& marker : marks) {
      if (marker.number != number) continue;
      marker.label = label.toStdString();
      marker.note = note.toStdString();
    }
    changed = true;
    return Done{};
  }
  Status removeMark(std::uint64_t number) override {
    std::erase_if(marks, [number](const Marker& m) { return m.number == number; });
    changed = true;
    return Done{};
  }
  QStringList tunedSettings() const override { return tuned; }
  void runDetectors(const QStringList& settings) override {
    asked = settings;
    tracks_ = {{QStringLiteral("Energy ratio"),
                {{Seconds(8.0), Seconds(9.5)}, {Seconds(14.0), Seconds(14.2)}},
                {{Seconds(8.1), Seconds(9.5)}},
                !settings.isEmpty(),
                1,
                0},
               {QStringLiteral("Coherence"),
                {{Seconds(8.4), Seconds(9.5)}},
                {{Seconds(8.4), Seconds(9.5)}},
                !settings.isEmpty(),
                0,
                0}};
    finished.what = TaskState::What::Detectors;
    changed = true;
  }
  const std::vector<DetectorTrack>& tracks() const override { return tracks_; }
  void score(bool wholeFolder) override {
    scoredFolder = wholeFolder;
    scores_ = {{QStringLiteral("Energy ratio"), 4, 3, 6, 2, 12.0, 0.18}};
    changed = true;
  }
  const std::vector<ScoreLine>& scores() const override { return scores_; }
  const QStringList& notScored() const override { return unreadable; }
  void exportSpan(Seconds from, Seconds to, const QString& file) override {
    exported = file;
    exportFrom = from;
    exportTo = to;
  }
  TaskState task() const override { return finished; }
  void cancel() override { cancelled = true; }

  ReplayState state;
  TaskState finished;
  std::vector<Marker> marks;
  QStringList tuned, asked, unreadable;
  QString exported;
  Seconds exportFrom{}, exportTo{};
  int steps = 0, listed = 0;
  QStringList lookedInto;
  bool changed = true, everywhere = false, refuse = false, scoredFolder = false, cancelled = false;

 private:
  QString folder_ = QStringLiteral("/rec"), path_;
  std::vector<SessionEntry> entries_;
  std::vector<SessionEntry> scenarios_{{QStringLiteral("/scenarios/demo.toml"), QStringLiteral("demo"),
                                        QStringLiteral("D12 Z4"), 0, 2'000, SessionEntry::Inside::Known, Seconds(60.0),
                                        0}};
  std::shared_ptr<const SessionSummary> summary_;
  std::vector<DetectorTrack> tracks_;
  std::vector<ScoreLine> scores_;
};

}  // namespace stillcut::ui
