// What is said about a recording, large: chatter or not, what to do, what that rests on; and the two numbers that make
// it better, with what the signal says of them. GUI thread.
#pragma once

#include <memory>

#include "ui/facade/file_controller.h"
#include "ui/widgets/panel.h"

class QHBoxLayout;
class QLineEdit;
class QScrollArea;

namespace stillcut::ui {

class TextLabel;
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
  };
  void display(const Shown& shown);
  // As they stand in the fields; empty or no number: not told.
  FileQuestion question() const;
  void setQuestion(const FileQuestion& question);

  void applyTheme(const Theme& theme) override;

 signals:
  void edited();
  void openAsked();

 private:
  void showAnswer(const Shown& shown);
  void showFindings(const Shown& shown);

  QHBoxLayout* fields_;
  TextLabel *title_, *facts_, *headline_, *advice_, *details_, *found_;
  QLineEdit *teeth_, *speed_;
  QScrollArea* scroll_;
  TouchButton* open_;
};

}  // namespace stillcut::ui
