// The row of controls above the plots of a recording: how its spectra are made and on which axis they stand. GUI
// thread.
#pragma once

#include <QStringList>
#include <QWidget>
#include <array>

#include "ui/base/themed.h"
#include "ui/models/file/file_look.h"

class QComboBox;
class QHBoxLayout;

namespace stillcut::ui {

class TouchButton;

class FileTools : public QWidget, public Themed {
  Q_OBJECT
 public:
  explicit FileTools(QWidget* parent = nullptr);

  const FileLook& look() const { return look_; }
  void setLook(const FileLook& look);
  void setChannels(const QStringList& names);
  void applyTheme(const Theme& theme) override;

 signals:
  void changed();

 private:
  QComboBox* addChoice(const char* name, const QString& spoken, const QStringList& items);
  TouchButton* addToggle(const char* name, const QString& caption, const QString& spoken, Qt::Key key,
                         bool FileLook::*value);
  void take();
  void showLook();

  FileLook look_;
  QHBoxLayout* row_;
  QComboBox *channel_ = nullptr, *length_ = nullptr, *window_ = nullptr, *overlap_ = nullptr;
  TouchButton *log_ = nullptr, *order_ = nullptr;
};

}  // namespace stillcut::ui
