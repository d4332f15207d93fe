#include "app/session/file/file_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/evaluate/picture/file_spectra.h"
#include "core/evaluate/picture/signal_guess.h"
#include "core/evaluate/session_summary_builder.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

constexpr double kLoudest = 0.9;  // of what is played

std::function<bool(double)> told(BackgroundTask::Progress& progress) {
  return [&progress](double part) {
    progress.part.store(part, std::memory_order_relaxed);
    return !progress.stopped();
  };
}

}  // namespace

bool DeskFileController::poll() {
  bool any = std::exchange(changed_, false);
  bool read = false;
  for (Shown& shown : places_) {
    read = shown.reading.collect() || read;
    any = shown.transforming.collect() || any;
  }
  const bool answered = places_[Main].answering.collect();
  any = places_[Beside].answering.collect() || any;
  if (answered || read) findInSignal();
  const bool more = others_.collect(), found = finding_.collect(), summed = summarizing_.collect();
  return any || answered || read || more || found || summed;
}

void DeskFileController::open(Place place, const QString& path) {
  close(place);
  places_[place].path = path;
  startReading(place);
}

void DeskFileController::tellTiming(Place place, const ui::FileTiming& timing) {
  const QString path = places_[place].path;
  close(place);
  places_[place].path = path;
  places_[place].timing = timing;
  if (!path.isEmpty()) startReading(place);
}

void DeskFileController::startReading(Place place) {
  Shown& shown = places_[place];
  const auto lack = std::make_shared<ui::FileLack>(ui::FileLack::None);  // the work's until it has failed
  shown.reading.start(
      ui::TaskState::What::Reading, shown.path,
      [&shown, lack, file = shown.path.toStdString(),
       timing = shown.timing](BackgroundTask::Progress& p) -> Result<BackgroundTask::Apply> {
        auto read = readFile(file, timing, p);
        if (!read) {
          if (!p.stopped()) *lack = lackOf(file);
          return read.error();
        }
        return BackgroundTask::Apply([&shown, made = std::move(read).value()] { shown.read = made; });
      },
      [this, &shown, lack](const Error&) {
        shown.lack = *lack;
        changed_ = true;
      });
  ask(place, {});
}

void DeskFileController::close(Place place) {
  Shown& shown = places_[place];
  shown.reading.leave();
  shown.transforming.leave();
  shown.answering.leave();
  shown.path.clear();
  shown.timing = {};
  shown.lack = ui::FileLack::None;
  shown.read = {};
  shown.judgement.reset();
  shown.question = {};
  shown.spectra.reset();
  changed_ = true;
  if (place != Main) return;
  sound_.stop();
  others_.leave();
  finding_.leave();
  summarizing_.leave();
  summary_.reset();
  findings_ = {};
}

void DeskFileController::ask(Place place, const ui::FileQuestion& question) {
  Shown& shown = places_[place];
  shown.question = question;
  changed_ = true;
  if (place == Main) others_.leave();
  if (shown.path.isEmpty()) return;
  shown.answering.start(
      ui::TaskState::What::Detectors, shown.path,
      [this, place, question, read = readOptions(shown.timing),
       file = shown.path.toStdString()](BackgroundTask::Progress& p) -> Result<BackgroundTask::Apply> {
        auto judged = judgeFile(file, {read, question, FileDetectors::Default}, p);
        if (!judged) return judged.error();
        return BackgroundTask::Apply([this, place, question, made = std::move(judged).value()] {
          places_[place].judgement = made;
          places_[place].judged = question;
          if (place == Main) askOthers(question);
        });
      },
      [&shown](const Error&) { shown.judgement.reset(); });
}

void DeskFileController::askOthers(const ui::FileQuestion& question) {
  others_.start(ui::TaskState::What::Detectors, places_[Main].path,
                [this, question, read = readOptions(places_[Main].timing), file = places_[Main].path.toStdString()](
                    BackgroundTask::Progress& p) -> Result<BackgroundTask::Apply> {
                  auto judged = judgeFile(file, {read, question, FileDetectors::Others}, p);
                  if (!judged) return judged.error();
                  return BackgroundTask::Apply([this, question, made = std::move(judged).value()] {
                    Shown& main = places_[Main];
                    if (!main.judgement || !(main.judged == question)) return;
                    std::vector<ui::FileTrack>& tracks = main.judgement->tracks;
                    tracks.insert(tracks.end(), made.tracks.begin(), made.tracks.end());
                  });
                });
}

// Once the samples are there, and it is known which channels are vibration.
void DeskFileController::findInSignal() {
  const Shown& main = places_[Main];
  const FileReading& read = main.read;
  if (!main.judgement || !read.samples) return;
  evaluate::GuessRequest request;
  request.rate = read.contents->rate;
  request.told = main.judged.speed.value > 0.0 ? main.judged.speed : read.contents->told.speed;
  request.heard = main.judgement->speed;
  for (const ChannelAnswer& channel : main.judgement->answers.front().channels)
    request.channels.push_back(channel.index);
  finding_.start(ui::TaskState::What::Detectors, places_[Main].path,
                 [this, request, samples = read.samples](BackgroundTask::Progress& p) -> Result<BackgroundTask::Apply> {
                   const auto guess = evaluate::guessFromSignal(*samples, request, [&p] { return !p.stopped(); });
                   ui::FileFindings found;
                   found.speed_rpm = {guess.speed.value, guess.doubt.value, {}};
                   for (const Rpm rival : guess.speedRivals) found.speed_rpm.rivals.push_back(rival.value);
                   found.teeth.value = guess.teeth;
                   for (const int rival : guess.teethRivals) found.teeth.rivals.push_back(rival);
                   return BackgroundTask::Apply([this, found] { findings_ = found; });
                 });
}

std::shared_ptr<const ui::FileAnswer> DeskFileController::answer(Place place) const {
  const Shown& shown = places_[place];
  if (!shown.judgement) return nullptr;
  return std::make_shared<const ui::FileAnswer>(inWords(shown.judged, *shown.judgement));
}

void DeskFileController::askSummary() {
  summary_.reset();
  const std::optional<FileJudgement>& judgement = places_[Main].judgement;
  const std::optional<SummaryAnswer> answer =
      judgement ? std::optional(sentencesOf(*judgement)) : std::optional<SummaryAnswer>();
  summarizing_.start(
      ui::TaskState::What::Reading, places_[Main].path,
      [this, answer, options = readOptions(places_[Main].timing),
       file = places_[Main].path.toStdString()](BackgroundTask::Progress& p) -> Result<BackgroundTask::Apply> {
        auto read = evaluate::summarizeRecording(file, options, {}, told(p));
        if (!read) return read.error();
        read->answer = answer;
        auto made = std::make_shared<const SessionSummary>(std::move(read).value());
        return BackgroundTask::Apply([this, made] { summary_ = made; });
      });
}

void DeskFileController::askSpectra(Place place, const SpectraRequest& request) {
  Shown& shown = places_[place];
  if (!shown.read.samples) return;
  shown.transforming.start(ui::TaskState::What::Reading, shown.path,
                           [&shown, request, samples = shown.read.samples, rate = shown.read.contents->rate](
                               BackgroundTask::Progress& p) -> Result<BackgroundTask::Apply> {
                             auto made = evaluate::spectraOf(*samples, rate, request, told(p));
                             if (!made) return made.error();
                             auto ready = std::make_shared<const Spectra>(std::move(made).value());
                             return BackgroundTask::Apply([&shown, ready] { shown.spectra = ready; });
                           });
}

Status DeskFileController::play(int channel, Seconds from, Seconds to) {
  const FileReading& read = places_[Main].read;
  if (!read.contents) return Error{message("sound"), message("no recording is open")};
  const auto& channels = read.contents->channels;
  if (channel < 0 || channel >= static_cast<int>(channels.size()))
    return Error{message("sound"), message("there is no such channel")};
  const WaveExtent whole = channels[static_cast<std::size_t>(channel)].wave.whole();
  const double peak =
      whole.present() ? std::max(std::abs(static_cast<double>(whole.low)), std::abs(static_cast<double>(whole.high)))
                      : 0.0;
  SoundStretch stretch;
  stretch.read = [samples = read.samples, channel](std::int64_t first, std::span<float> out) {
    return samples->read(channel, first, out);
  };
  stretch.rate = read.contents->rate;
  stretch.from = std::max<std::int64_t>(std::llround(from.value * stretch.rate.value), 0);
  stretch.to = std::min(std::llround(to.value * stretch.rate.value), static_cast<long long>(read.samples->frames()));
  stretch.gain = peak > 0.0 ? kLoudest / peak : 1.0;
  return sound_.play(std::move(stretch));
}

std::optional<Seconds> DeskFileController::playing() const {
  const auto frame = sound_.at();
  if (!frame || !places_[Main].read.contents) return {};
  return Seconds(static_cast<double>(*frame) / places_[Main].read.contents->rate.value);
}

QString DeskFileController::soundProblem() const {
  return ui::sayCore(sound_.problem());
}

}  // namespace stillcut::app
