// The dialog of files. Never modal: what commands the machine stays within reach while somebody looks for a file. GUI
// thread.
#pragma once

#include <QFileDialog>
#include <functional>
#include <utility>

namespace stillcut::ui {

// `folder` empty: where the one before was. `chosen` is told what was chosen; nothing is told of a dialog that was
// left.
inline QFileDialog* chooseFiles(QWidget* parent, const QString& title, QFileDialog::FileMode mode,
                                const QString& folder, std::function<void(const QStringList&)> chosen) {
  auto* dialog = new QFileDialog(parent, title, folder);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setModal(false);
  dialog->setFileMode(mode);
  dialog->resize(parent->window()->size() * 3 / 4);
  QObject::connect(dialog, &QFileDialog::filesSelected, parent, std::move(chosen));
  dialog->show();
  return dialog;
}

}  // namespace stillcut::ui
