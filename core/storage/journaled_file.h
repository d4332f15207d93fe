// JournaledFile: a file that goes from one commit to the next as a whole, whatever ends the program or the power in
// between. New bytes go behind its end at once, where nothing refers to them yet; overwrites wait in memory, go to the
// journal with the commit, and only then into their places. A commit that waits for the disk syncs the new bytes, then
// the journal, then the file.
// Thread: one at a time; not real-time.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/storage/disk.h"
#include "core/storage/journal.h"

namespace stillcut::record {

class JournaledFile {
 public:
  enum class Access { Create, Write, Read };
  // Create: everything goes straight to the file until beginJournal(). Write: the journal begins at once; an error when
  // somebody else is writing. Read: with the overwrites of a journal that was left, as if they had been made, where it
  // is this file's.
  static Result<std::unique_ptr<JournaledFile>> open(const std::string& path, Access access, Disk& disk = systemDisk());
  ~JournaledFile();  // without commit
  JournaledFile(const JournaledFile&) = delete;
  JournaledFile& operator=(const JournaledFile&) = delete;

  // Makes and locks the journal of `session`, the name the file will have. The lock tells readers that a writer lives,
  // and a journal that was made as a new one keeps the name for this file among all programs that record. An error
  // leaves no journal that was not there before.
  enum class JournalOf { AnyFile, NewFile };  // NewFile: an error where one is there
  Status beginJournal(const std::string& session, JournalOf which = JournalOf::AnyFile);

  std::uint64_t size() const { return size_; }
  bool read(std::uint64_t offset, std::span<std::byte> out) const;  // zeros behind the end
  // `growsOnly`: bytes that are there already are written as they are, so that no journal is needed. False: error().
  bool write(std::uint64_t offset, std::span<const std::byte> bytes, bool growsOnly);
  void truncate(std::uint64_t size);
  // All since the last commit, or nothing of it. `toDisk`: also after a power loss.
  Status commit(bool toDisk);
  // Forgets what came since the last commit; from now on writes are taken and dropped, so that what holds the file can
  // be closed.
  void abandon();
  // The file is whole without its journal: removes it. After the last commit.
  void removeJournal();
  // False: `path` is not this file any more; it was deleted, moved away or replaced.
  bool isAt(const std::string& path) const;
  // Somebody else has made it shorter than what was written to it.
  bool cutShort() const;
  // One line about the last failure.
  const Message& error() const { return error_; }

 private:
  JournaledFile(std::string path, Disk& disk) : path_(std::move(path)), disk_(disk) {}
  bool failed(const char* doing);
  bool failedCutShort();
  Status refuseJournal(const std::string& session, bool made);
  Status apply(bool toDisk);

  std::string path_;  // for messages
  std::string journal_;
  Disk& disk_;
  int file_ = -1;
  int journalFile_ = -1;
  std::uint64_t size_ = 0;
  std::uint64_t committed_ = 0;  // size at the last commit
  std::uint64_t written_ = 0;    // where what was written to the file ends
  JournalContent pending_;
  bool abandoned_ = false;
  Message error_;
};

enum class Recovery {
  NothingToDo,      // no journal
  WriterAlive,      // a journal that somebody holds
  NotWritable,      // a journal, but the file or its folder cannot be written
  AnothersJournal,  // the file is not what this journal was written for, or was changed since: both are left alone
  Recovered,        // the journal's overwrites are in the file
};
// Completes what a dead writer has begun, and leaves the journal in place: the marks in the file still say that it was
// not closed. `whole` looks at the file as it would be; when it fails, nothing is written.
Result<Recovery> recoverFromJournal(const std::string& path, const std::function<Status()>& whole);

}  // namespace stillcut::record
