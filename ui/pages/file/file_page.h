// The page for a recording as a whole: its answer in words, its samples, spectra and states over one axis of time, the
// spectrum of any moment of it, sound, and a second recording to compare with, with its own answer. What runs at the
// machine goes on. GUI thread.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "ui/facade/file_controller.h"
#include "ui/models/file/file_look.h"
#include "ui/models/history/analyse_view.h"
#include "ui/pages/page.h"

class QGridLayout;
class QHBoxLayout;

namespace stillcut::ui {

class FileAnswerPanel;
class FileSpectrum;
class FileTools;
class Panel;
class SpectraMap;
class StateRows;
class TextLabel;
class TouchButton;
class WavePlot;

class FilePage : public Page {
  Q_OBJECT
 public:
  // Writes a summary as the file's name says.
  using ReportWriter = std::function<Status(const SessionSummary&, const QString& file, UnitSystem)>;
  // `controller` may be null: nothing can be opened here, the page says so. It outlives the page.
  explicit FilePage(FileController* controller, ReportWriter report = {}, QWidget* parent = nullptr);

  void openFile(const QString& path) override;
  void see(const Picture& picture) override;
  void display(const Picture& picture) override;
  void keep(QSettings& settings) const override;
  void restore(const QSettings& settings) override;
  void applyTheme(const Theme& theme) override;

  AnalyseView& view() { return view_; }
  // In the place of the dialog of files: tells what was chosen.
  std::function<void(const QString& title, const std::function<void(const QString&)>& chosen)> chooseFile;

 private:
  static constexpr qint64 kNotEdited = -2, kJustNow = -1;
  QWidget* makePlots();
  QWidget* makeFoot();
  void connectParts();
  void choose(FileController::Place place, bool thenOther = false);
  void refresh();
  void compareWith(const QString& path);
  void showAnswer();
  std::optional<double> besideLouderDb() const;
  void showTold(FileController::Place place);
  void showJudged();
  void showParts();
  void askSpectra(FileController::Place place);
  void askTyped(FileController::Place place, qint64 nowMs);
  bool busy() const;
  QString nameOf(FileController::Place place) const;
  FileMarks marks() const;
  void toggleBeside();
  void toggleSound();
  void writePicture();
  void writeReport();
  void tell(const QString& text, bool trouble = false);

  FileController* controller_;
  ReportWriter writer_;
  QString folder_;  // where the last recording was chosen; empty: nowhere yet
  UnitSystem units_ = UnitSystem::Metric;
  bool reportWanted_ = false;  // as soon as the summary is there
  AnalyseView view_;
  FileAnswerPanel* answer_ = nullptr;
  FileTools* tools_ = nullptr;
  WavePlot* wave_ = nullptr;
  SpectraMap* map_ = nullptr;
  StateRows* states_ = nullptr;
  FileSpectrum* spectrum_ = nullptr;
  TextLabel* status_ = nullptr;
  TouchButton *play_ = nullptr, *beside_ = nullptr, *picture_ = nullptr, *report_ = nullptr;
  QWidget* plots_ = nullptr;
  QGridLayout* grid_ = nullptr;
  QHBoxLayout *columns_ = nullptr, *foot_ = nullptr;
  std::shared_ptr<const FileContents> shown_;                // whose whole is in view_
  std::array<std::shared_ptr<const FileContents>, 2> told_;  // whose own numbers are in the fields
  bool judgedShown_ = false;                                 // frequencies up to what is judged, once
  std::array<SpectraRequest, 2> asked_;                      // newest spectra asked for
  std::array<const FileContents*, 2> askedOf_{};             // of this recording
  bool viewMoved_ = false;
  // When the fields were typed into last, while nobody was asked since.
  std::array<qint64, 2> editedMs_{kNotEdited, kNotEdited};
  QString soundProblem_;  // as last told
};

}  // namespace stillcut::ui
