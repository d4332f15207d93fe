// TapBench: the tap test behind its page: a device and what is heard of it, the hits of both axes, their modes and the
// lobes that follow. Thread: GUI; devices are read, and modes and lobes computed, apart.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "app/session/background_task.h"
#include "app/session/tap/tap_listener.h"
#include "app/session/tap/tap_work.h"
#include "core/config/profile.h"
#include "ui/facade/tap_controller.h"
#include "ui/facade/tool_entry.h"

namespace stillcut::app {

class TapBench final : public ui::TapController {
 public:
  ~TapBench() override;

  // Where files of modes are kept; empty: nowhere.
  void keepIn(const QString& folder) { folder_ = folder; }
  // Profiles with a device: their names, and one by its name. A draft is the name "".
  std::function<QStringList()> profiles;
  std::function<Result<config::Profile>(const QString& name)> profile;
  std::function<std::string(const QString& name)> profilePath;
  // The shop's tools.
  std::function<Result<std::vector<ui::ToolEntry>>()> library;
  std::function<Status(const std::vector<ui::ToolEntry>&)> keepLibrary;
  // Times real time of the simulated hammer; 0: as fast as it is taken.
  void setSimulatedPace(double pace) { pace_ = pace; }

  bool poll() override;
  std::vector<ui::TapDevice> devices() const override;
  void listen(const QString& device) override;
  void stopListening() override;
  const ui::TapListening& listening() const override { return listening_; }
  void chooseForce(int channel) override;
  void chooseResponse(int channel) override;
  void begin(int axis) override;
  void end() override;
  ui::TapRun run() const override;
  const std::vector<ui::TapHitRow>& hits(int axis) const override;
  void useHit(int axis, std::size_t hit, bool use) override;
  void openFiles(const QStringList& paths, int axis) override;
  const QStringList& files() const override { return files_; }
  const ui::TapFileReading& reading() const override { return fileReading_; }
  void answer(const ui::TapAnswers& answers) override;
  const ui::TapResponse& response(int axis) const override;
  void useMode(int axis, std::size_t mode, bool use) override;
  std::vector<ui::TapMaterial> materials() const override;
  void compute(const ui::TapCut& cut) override;
  const ui::TapLobes& lobes() const override { return lobes_; }
  QStringList tools() const override;
  ui::TapCut withTool(ui::TapCut cut, const QString& tool) const override;
  Result<QString> saveCut(const QString& tool) override;
  QString keptAlready(ui::TapKept what, const QString& name) const override;
  Result<QString> saveModes(const QString& name) override;

 private:
  struct Axis {
    std::optional<identify::TapTest> test;
    std::vector<ui::TapHitRow> hits;
    TapAxis known;
    BackgroundTask fitting;
    QStringList files;   // that it is from; empty: measured here, or not at all
    TapReading reading;  // of them
  };
  Axis& axisOf(int axis) { return axes_[axis == 1 ? std::size_t{1} : std::size_t{0}]; }
  const Axis& axisOf(int axis) const { return axes_[axis == 1 ? std::size_t{1} : std::size_t{0}]; }
  void hear(const HeardBlock& block);
  void meter(const HeardBlock& block);
  void openDevice();
  void guessChannels();
  void chooseAlong();
  void showHits(Axis& axis);
  void fit(int axis);
  void take(Axis& axis, TapAxis found);
  void changed(ui::TapResponse& response) { response.version = ++versions_; }
  void readFiles(const QStringList& paths, const TapReading& reading);
  void takeFiles(const QStringList& paths, const TapReading& reading, TapFiles read);
  void notTaken(const Error& error, const TapReading& reading);
  void readHitsAnew(int axis);
  QStringList sources() const;
  void computeAnew();
  std::vector<identify::IdentifiedMode> modes() const;
  double missingMode() const;  // frequency of one that was left out and limits the depth [Hz]; 0: none
  Result<QString> fileIn(const char* folder, const QString& name) const;

  QString folder_;
  double pace_ = 1.0;
  TapListener listener_;
  ui::TapListening listening_;
  std::array<Axis, ui::kTapAxes> axes_;
  int axis_ = 0;
  bool running_ = false;
  bool beginning_ = false;     // once the device is heard
  bool withoutForce_ = false;  // somebody has said so
  bool gap_ = false;           // since the last block that was handed on
  QStringList files_;          // shown last; empty: a device's
  QStringList wanted_;         // asked for last, and along which axis
  int wantedAxis_ = 0;
  ui::TapFileReading fileReading_;
  BackgroundTask reading_, computing_;
  ui::TapLobes lobes_;
  std::optional<ui::TapCut> asked_;
  std::stop_source stopLobes_;
  std::uint32_t versions_ = 0;
};

}  // namespace stillcut::app
