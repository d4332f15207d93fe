// DeskFileController: one recording as a whole and its answer, and a second one beside it. Each part of the work has a
// thread of its own: reading, judging by the default detector, judging by the others, spectra. Thread: GUI.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "app/io/sound_player.h"
#include "app/session/background_task.h"
#include "app/session/file/file_judgement.h"
#include "app/session/file/file_reading.h"
#include "ui/facade/file_controller.h"

namespace stillcut::app {

class DeskFileController final : public ui::FileController {
 public:
  bool poll() override;

  void open(Place place, const QString& path) override;
  void tellTiming(Place place, const ui::FileTiming& timing) override;
  ui::FileLack lacking(Place place) const override { return places_[place].lack; }
  void close(Place place) override;
  QString path(Place place) const override { return places_[place].path; }
  std::shared_ptr<const ui::FileContents> contents(Place place) const override { return places_[place].read.contents; }
  ui::TaskState reading(Place place) const override { return places_[place].reading.state(); }

  void ask(Place place, const ui::FileQuestion& question) override;
  ui::FileQuestion asked(Place place) const override { return places_[place].question; }
  std::shared_ptr<const ui::FileAnswer> answer(Place place) const override;
  ui::TaskState answering(Place place) const override { return places_[place].answering.state(); }
  bool comparing() const override { return others_.state().running; }
  ui::FileFindings findings() const override { return findings_; }

  void askSummary() override;
  std::shared_ptr<const SessionSummary> summary() const override { return summary_; }
  ui::TaskState summarizing() const override { return summarizing_.state(); }
  void askSpectra(Place place, const SpectraRequest& request) override;
  std::shared_ptr<const Spectra> spectra(Place place) const override { return places_[place].spectra; }

  Status play(int channel, Seconds from, Seconds to) override;
  void stopSound() override { sound_.stop(); }
  std::optional<Seconds> playing() const override;
  QString soundProblem() const override;

 private:
  struct Shown {
    QString path;
    ui::FileTiming timing;
    ui::FileLack lack = ui::FileLack::None;
    FileReading read;
    std::shared_ptr<const Spectra> spectra;
    ui::FileQuestion question;
    std::optional<FileJudgement> judgement;
    ui::FileQuestion judged;  // that `judgement` answers
    BackgroundTask reading, transforming, answering;
  };
  void startReading(Place place);
  void findInSignal();
  void askOthers(const ui::FileQuestion& question);

  std::array<Shown, 2> places_;
  ui::FileFindings findings_;
  std::shared_ptr<const SessionSummary> summary_;
  BackgroundTask others_, finding_, summarizing_;
  SoundPlayer sound_;
  bool changed_ = false;
};

}  // namespace stillcut::app
