// What is said about a recording, large: chatter or not, what to do, what that rests on; and the two numbers that make
// it better, with what the signal says of them. Under it the same in short of a second one. GUI thread.
#pragma once

#include <memory>
#include <optional>

#include "ui/facade/file_controller.h"
#include "ui/widgets/panel.h"

class QScrollArea;

namespace stillcut::ui {

class QuestionFields;
class TextLabel;
class TimingFields;
class TouchButton;

class FileAnswerPanel : public Panel {
  Q_OBJECT
 public:
  explicit FileAnswerPanel(QWidget* parent = nullptr);

  struct Shown {
    std::shared_ptr<const FileContents> file;
    std::shared_ptr<const FileAnswer> answer;
    QString path;                // empty: nothing was opened
    TaskState reading, judging;  // of the file, of the answer
    FileQuestion asked;
    FileFindings findings;
    FileLack lack = FileLack::None;
  };
  void display(const Shown& shown);
  // The one it is compared with; hidden without one. `louder_dB`: in the cut than the first, where that is known.
  void displayBeside(const Shown& shown, std::optional<double> louder_dB);
  QuestionFields& fields(FileController::Place place) const {
    return *(place == FileController::Main ? fields_ : besideFields_);
  }

  void applyTheme(const Theme& theme) override;

 signals:
  void edited(stillcut::ui::FileController::Place place);
  void openAsked();
  void timingTold(const stillcut::ui::FileTiming& timing);

 private:
  void makeBeside();
  void showFindings(const Shown& shown);

  TextLabel *title_, *facts_, *headline_, *advice_, *details_, *found_;
  QuestionFields *fields_, *besideFields_;
  TimingFields* timing_;
  QWidget* beside_;
  TextLabel *besideTitle_, *besideHeadline_, *besideLevel_;
  QScrollArea* scroll_;
  TouchButton* open_;
};

}  // namespace stillcut::ui
