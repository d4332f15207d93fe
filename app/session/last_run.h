// LastRun: what ran when the program was last there, kept in one small file of the user's folder: the next start brings
// the same machine up again, with authority Off, and says when that run did not end in order. Thread: GUI.
#pragma once

#include <QDateTime>
#include <QString>

namespace stillcut::app {

class LastRun {
 public:
  struct Kept {
    QString profile;          // file; empty: none was ever in force
    bool endedBadly = false;  // it began and nobody ended it: the program or the computer died
    QDateTime began;
    QString recording;  // its file; empty: it was not recorded
  };

  // Of what an earlier program kept in `folder`; without a folder nothing is kept.
  explicit LastRun(const QString& folder);
  const Kept& before() const { return before_; }
  // In the language of the screen: that the run before did not end in order, and what is left of it; empty: it did.
  QString sentence() const;

  // A run on `profile` begins; one on none (the demonstration) changes nothing of what is kept.
  void begin(const QString& profile);
  // The file it is recorded to, as soon as it is known. Cheap while it stays the same.
  void recordTo(const QString& recording);
  // In order.
  void end();

 private:
  void keep(bool running);

  QString file_;
  Kept before_;
  Kept now_;
};

}  // namespace stillcut::app
