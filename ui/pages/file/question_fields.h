// The two numbers that make an answer better: teeth and speed of a recording. GUI thread.
#pragma once

#include <QWidget>

#include "ui/base/themed.h"
#include "ui/facade/file_controller.h"

class QHBoxLayout;
class QLineEdit;

namespace stillcut::ui {

class QuestionFields : public QWidget, public Themed {
  Q_OBJECT
 public:
  // `name`: what tests find the fields by, with "-teeth" and "-speed".
  explicit QuestionFields(const QString& name, QWidget* parent = nullptr);

  // As they stand in the fields; empty or no number: not told.
  FileQuestion question() const;
  void setQuestion(const FileQuestion& question);
  void applyTheme(const Theme& theme) override;

 signals:
  void edited();

 private:
  QLineEdit *teeth_, *speed_;
  QHBoxLayout* fields_;
};

}  // namespace stillcut::ui
