// Outbox: what is to be told to the shop, kept on disk until the broker has it, and with it how far the source was
// read. Both change in one transaction that waits for the disk, so that a kill or a power cut loses no message and
// gives none a second number. One SQLite file; one program at a time has it. Thread: one.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/shop/shop_message.h"
#include "core/base/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace stillcut::shop {

class Outbox {
 public:
  struct Kept {
    std::uint64_t sequence = 0;
    std::string topic;
    std::string payload;  // as it is sent
    bool retained = false;
  };

  static constexpr std::uint64_t kMost = 2'000'000;  // three weeks of one a second; 1 to 2 GB

  // Made where there is none. An error: it cannot be written, or another program has it.
  static Result<std::unique_ptr<Outbox>> open(const std::string& path, std::uint64_t most = kMost);
  ~Outbox();
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;

  // When it was made, UTC ms: sequences of one series never repeat.
  std::int64_t series() const { return series_; }
  std::uint64_t waiting() const { return waiting_; }

  // Everything between begin() and commit() happens or does not. After an error of commit() nothing may follow.
  void begin();
  Status commit();
  // Adds schema, series and sequence. Beyond `most` the oldest features go first, then whatever is oldest.
  std::uint64_t add(const ShopMessage& message);
  // A transaction of its own that does not wait for the disk: where one lasts 30 ms, waiting for each batch that the
  // broker acknowledges takes longer than sending it. After a power cut some may be sent again, with their numbers.
  Status forget(const std::vector<std::uint64_t>& sequences);
  void setNote(std::string_view key, std::string_view value);
  // Whether line `line` of the run that began at `run` (UTC ms) is new; it is then taken. A source that is read again
  // from an earlier place is so told once.
  bool takeLine(std::int64_t run, std::uint64_t line);

  std::string note(std::string_view key) const;  // "": none
  // The payload of the newest message of a topic, also when the broker has it; "": there was none.
  std::string newestOf(const std::string& topic) const { return note("newest " + topic); }
  std::vector<Kept> after(std::uint64_t sequence, int atMost) const;

 private:
  explicit Outbox(sqlite3* file, std::uint64_t most) : file_(file), most_(most) {}
  bool does(const char* sql);
  sqlite3_stmt* prepared(const char* sql) const;
  bool step(sqlite3_stmt* statement);
  Status prepareTables(const std::string& path);
  void makeRoom();

  sqlite3* file_;
  std::uint64_t most_;
  std::string path_;
  std::int64_t series_ = 0;
  std::uint64_t newest_ = 0, waiting_ = 0;
  bool failed_ = false;
};

}  // namespace stillcut::shop
