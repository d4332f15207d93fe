// A desk with one recording of ten seconds that chatters from 4 s on; answers come when a test lets them.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "ui/facade/file_controller.h"

namespace stillcut::ui {

class FakeFileDesk final : public FileController {
 public:
  static constexpr double kRate = 8000.0, kLength = 10.0, kChatter = 1502.0;

  bool poll() override { return std::exchange(changed, false); }
  void open(Place place, const QString& path) override {
    opened.push_back({place, path});
    paths_[place] = path;
    contents_[place] = unreadable.isEmpty() ? makeContents(path) : nullptr;
    spectra_[place].reset();
    reading_[place].problem = unreadable;
    ask(place, {});
    changed = true;
  }
  void tellTiming(Place place, const FileTiming& timing) override {
    timings.push_back(timing);
    unreadable.clear();
    lack = FileLack::None;
    open(place, QString(paths_[place]));
  }
  FileLack lacking(Place place) const override { return place == Main ? lack : FileLack::None; }
  void close(Place place) override {
    paths_[place].clear();
    contents_[place].reset();
    answers_[place].reset();
    spectra_[place].reset();
    changed = true;
  }
  QString path(Place place) const override { return paths_[place]; }
  std::shared_ptr<const FileContents> contents(Place place) const override { return contents_[place]; }
  TaskState reading(Place place) const override { return reading_[place]; }
  void ask(Place place, const FileQuestion& question) override {
    changed = true;
    asked_[place] = question;
    if (place == Beside) return;  // finishBeside() answers it
    questions.push_back(question);
    judging.running = true;
    judging.part = 0.4;
  }
  FileQuestion asked(Place place) const override { return asked_[place]; }
  std::shared_ptr<const FileAnswer> answer(Place place) const override { return answers_[place]; }
  TaskState answering(Place place) const override { return place == Main ? judging : TaskState(); }
  bool comparing() const override { return false; }
  FileFindings findings() const override { return found; }
  void askSummary() override { ++summariesAsked; }
  std::shared_ptr<const SessionSummary> summary() const override { return nullptr; }
  TaskState summarizing() const override { return {}; }
  void askSpectra(Place place, const SpectraRequest& request) override {
    requests.push_back({place, request});
    spectra_[place] = makeSpectra(request, place == Beside ? besideLouderDb : 0.0);
    changed = true;
  }
  std::shared_ptr<const Spectra> spectra(Place place) const override { return spectra_[place]; }
  Status play(int channel, Seconds from, Seconds to) override {
    static_cast<void>(channel);
    if (noSound) return Error{message("sound"), message("this Stillcut was built without sound output")};
    played = {from, to};
    heard = from;
    return Done{};
  }
  void stopSound() override { heard.reset(); }
  std::optional<Seconds> playing() const override { return heard; }
  QString soundProblem() const override { return soundTrouble; }

  // The question asked last is answered.
  void finish() {
    answers_[Main] = makeAnswer(Main);
    judging.running = false;
    changed = true;
  }
  void finishBeside() {
    answers_[Beside] = makeAnswer(Beside);
    changed = true;
  }
  std::shared_ptr<const FileAnswer> makeAnswer(Place place) const {
    FileAnswer answer;
    answer.question = asked(place);
    answer.finding = Finding::Chatter;
    answer.headline = QStringLiteral("Chatter at 1502 Hz from 4.0 s on");
    answer.advice = QStringLiteral(
        "Try 9\u202f010 or 10\u202f010 rpm (5 or 4\u00bd waves of 1502 Hz between two teeth instead of 4.74), or "
        "less depth");
    answer.details = QStringList{QStringLiteral("Judged 8.0 of 10.0 s; the rest: 2.0 s of air"),
                                 QStringLiteral("Chatter can be detected up to 3500 Hz")};
    answer.teeth = asked(place).teeth > 0 ? asked(place).teeth : 2;
    answer.chatter = Hertz(kChatter);
    answer.spindle = Hertz(158.4);
    for (const char* name : {"Energy ratio", "Coherence", "Growth", "Statistics"}) {
      answer.tracks.push_back({QString::fromLatin1(name),
                               {{Seconds(0.0), Seconds(1.0), CutState::AirCutting, true},
                                {Seconds(1.0), Seconds(1.5), CutState::Stable, false},
                                {Seconds(1.5), Seconds(4.0), CutState::Stable, true},
                                {Seconds(4.0), Seconds(4.3), CutState::Onset, true},
                                {Seconds(4.3), Seconds(9.0), CutState::Chatter, true},
                                {Seconds(9.0), Seconds(10.0), CutState::AirCutting, true}},
                               makeCurve()});
    }
    return std::make_shared<const FileAnswer>(std::move(answer));
  }

  struct Opened {
    Place place;
    QString path;
  };
  std::vector<Opened> opened;
  std::vector<FileQuestion> questions;
  std::vector<std::pair<Place, SpectraRequest>> requests;
  TaskState judging;
  FileFindings found;
  QString unreadable, soundTrouble;
  FileLack lack = FileLack::None;
  std::vector<FileTiming> timings;
  std::optional<Seconds> heard;
  std::pair<Seconds, Seconds> played;
  FileQuestion toldByFile;
  std::optional<FileTrack> recorded;
  qint64 wallMs = 0;
  int summariesAsked = 0;
  double besideLouderDb = 0.0;
  bool noSound = false, changed = true;

 private:
  // Low while stable, a hole while not judged, high in chatter.
  static FileCurve makeCurve() {
    FileCurve curve{QStringLiteral("er"), Seconds(0.01), {}, 0.3};
    for (int k = 0; k < 1000; ++k) {
      const double t = 0.01 * k;
      const float level = t > 4.0 && t < 9.0 ? 0.8F : 0.1F;
      curve.highest.push_back(t > 1.0 && t < 1.5 ? std::numeric_limits<float>::quiet_NaN() : level);
    }
    return curve;
  }
  static double sample(double t) {
    const double cut = t > 1.0 && t < 9.0 ? 1.0 : 0.02, chatter = t > 4.0 && t < 9.0 ? 2.0 : 0.0;
    return cut * std::sin(6.283185 * 316.8 * t) + chatter * std::sin(6.283185 * kChatter * t);
  }
  std::shared_ptr<const FileContents> makeContents(const QString& path) const {
    FileContents contents;
    contents.path = path;
    contents.kind = QStringLiteral("WAV");
    contents.rate = Hertz(kRate);
    contents.length = path.endsWith(QLatin1String("longer.wav")) ? Seconds(2.5 * kLength) : Seconds(kLength);
    contents.told = toldByFile;
    contents.recorded = recorded;
    contents.wallMs = wallMs;
    for (const char* name : {"x", "y"}) {
      FileChannel channel;
      channel.name = QString::fromLatin1(name);
      channel.unit = QStringLiteral("m/s\u00b2");
      std::vector<float> samples(static_cast<std::size_t>(kRate * kLength));
      for (std::size_t k = 0; k < samples.size(); ++k)
        samples[k] = static_cast<float>(sample(static_cast<double>(k) / kRate));
      channel.wave.add(samples);
      contents.channels.push_back(std::move(channel));
    }
    return std::make_shared<const FileContents>(std::move(contents));
  }
  static std::shared_ptr<const Spectra> makeSpectra(const SpectraRequest& request, double louder_dB) {
    Spectra s;
    s.request = request;
    s.bins = request.length / 2 + 1;
    s.binWidth = kRate / request.length;
    s.columns = 200;
    s.step = (request.to - request.from) * (1.0 / s.columns);
    s.first = request.from + s.step * 0.5;
    for (int k = 0; k < s.columns; ++k) {
      const double t = s.first.value + k * s.step.value;
      for (int b = 0; b < s.bins; ++b) {
        const double f = b * s.binWidth;
        double level = -70.0 + 3.0 * std::sin(0.7 * b + 1.3 * k);
        if (t > 1.0 && t < 9.0 && std::abs(std::remainder(f, 316.8)) < s.binWidth) level = -10.0 - 0.01 * f;
        if (t > 4.0 && t < 9.0 && std::abs(f - kChatter) < s.binWidth) level = 3.0;
        s.level_dB.push_back(static_cast<float>(level + louder_dB));
      }
    }
    return std::make_shared<const Spectra>(std::move(s));
  }

  std::array<QString, 2> paths_;
  std::array<std::shared_ptr<const FileContents>, 2> contents_;
  std::array<std::shared_ptr<const Spectra>, 2> spectra_;
  std::array<TaskState, 2> reading_;
  std::array<FileQuestion, 2> asked_;
  std::array<std::shared_ptr<const FileAnswer>, 2> answers_;
};

}  // namespace stillcut::ui
