// The dialog of files. Never modal: what commands the machine stays within reach while somebody looks for a file. GUI
// thread.
#pragma once

#include <QFileDialog>
#include <functional>
#include <utility>

#include "ui/base/say.h"

namespace stillcut::ui {

// What the importers read, by the ends of names; and all, for whoever has named it otherwise.
inline QStringList recordingFilters(bool modes = false) {
  const QString ends = QStringLiteral(
      "*.h5 *.hdf5 *.wav *.flac *.csv *.txt *.tsv *.dat *.lvm *.mat *.npy *.npz *.uff *.unv *.uf *.tdms *.mp3 *.m4a "
      "*.ogg *.aiff *.frf");
  const QString more = modes ? ends + QStringLiteral(" *.toml") : ends;
  return {say("Recordings (%1)").arg(more), say("All files (*)")};
}

// `folder` empty: where the one before was. `chosen` is told what was chosen; nothing is told of a dialog that was
// left.
inline QFileDialog* chooseFiles(QWidget* parent, const QString& title, QFileDialog::FileMode mode,
                                const QString& folder, std::function<void(const QStringList&)> chosen,
                                const QStringList& filters = {}) {
  auto* dialog = new QFileDialog(parent, title, folder);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setModal(false);
  dialog->setFileMode(mode);
  if (!filters.isEmpty()) dialog->setNameFilters(filters);
  dialog->resize(parent->window()->size() * 3 / 4);
  QObject::connect(dialog, &QFileDialog::filesSelected, parent, std::move(chosen));
  dialog->show();
  return dialog;
}

}  // namespace stillcut::ui
