#include "app/shop/outbox.h"

#include <sqlite3.h>

#include <cstdlib>

namespace stillcut::shop {
namespace {

constexpr const char* kTables =
    "PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL; PRAGMA locking_mode=EXCLUSIVE;"
    "CREATE TABLE IF NOT EXISTS box(sequence INTEGER PRIMARY KEY, topic TEXT NOT NULL, payload TEXT NOT NULL,"
    "  retained INTEGER NOT NULL);"
    "CREATE TABLE IF NOT EXISTS note(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;"
    "CREATE TABLE IF NOT EXISTS run(began INTEGER PRIMARY KEY, line INTEGER NOT NULL);";
constexpr int kRunsKept = 100'000;

std::int64_t toNumber(const std::string& text) {
  return std::strtoll(text.c_str(), nullptr, 10);
}
std::string column(sqlite3_stmt* row, int index) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(row, index));
  return text != nullptr ? std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(row, index)))
                         : std::string();
}
void put(sqlite3_stmt* row, int index, std::string_view text) {
  sqlite3_bind_text(row, index, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
}
void put(sqlite3_stmt* row, int index, std::uint64_t number) {
  sqlite3_bind_int64(row, index, static_cast<sqlite3_int64>(number));
}

}  // namespace

Result<std::unique_ptr<Outbox>> Outbox::open(const std::string& path, std::uint64_t most) {
  sqlite3* file = nullptr;
  const int opened = sqlite3_open_v2(path.c_str(), &file, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  std::unique_ptr<Outbox> box(new Outbox(file, most));
  if (opened != SQLITE_OK) return Error{path, message("cannot be opened"), foreign(sqlite3_errmsg(file))};
  if (Status tables = box->prepareTables(path); !tables) return tables.error();
  return box;
}

Outbox::~Outbox() {
  for (sqlite3_stmt* s = sqlite3_next_stmt(file_, nullptr); s != nullptr; s = sqlite3_next_stmt(file_, nullptr))
    sqlite3_finalize(s);
  sqlite3_close(file_);
}

Status Outbox::prepareTables(const std::string& path) {
  path_ = path;
  // The exclusive lock is taken by the first write.
  if (!does(kTables) || !does("BEGIN IMMEDIATE; COMMIT;")) {
    const bool busy = sqlite3_errcode(file_) == SQLITE_BUSY;
    return Error{path, busy ? message("another stillcut-shop has it") : message("cannot be written"),
                 foreign(sqlite3_errmsg(file_))};
  }
  newest_ = static_cast<std::uint64_t>(toNumber(note("newest")));  // before the first commit, which keeps it
  begin();
  if (note("series").empty()) setNote("series", std::to_string(utcNowMs()));
  if (Status kept = commit(); !kept) return kept;
  series_ = toNumber(note("series"));
  sqlite3_stmt* count = prepared("SELECT count(*) FROM box");
  if (sqlite3_step(count) == SQLITE_ROW) waiting_ = static_cast<std::uint64_t>(sqlite3_column_int64(count, 0));
  sqlite3_reset(count);
  return Done{};
}

bool Outbox::does(const char* sql) {
  const bool ok = sqlite3_exec(file_, sql, nullptr, nullptr, nullptr) == SQLITE_OK;
  failed_ = failed_ || !ok;
  return ok;
}

// SQLite keeps what is prepared; a second call of the same text takes it from there.
sqlite3_stmt* Outbox::prepared(const char* sql) const {
  for (sqlite3_stmt* s = sqlite3_next_stmt(file_, nullptr); s != nullptr; s = sqlite3_next_stmt(file_, s)) {
    if (std::string_view(sqlite3_sql(s)) == sql) {
      sqlite3_reset(s);
      return s;
    }
  }
  sqlite3_stmt* made = nullptr;
  sqlite3_prepare_v2(file_, sql, -1, &made, nullptr);
  return made;
}

bool Outbox::step(sqlite3_stmt* statement) {
  const bool ok = sqlite3_step(statement) == SQLITE_DONE;
  failed_ = failed_ || !ok;
  sqlite3_reset(statement);
  return ok;
}

void Outbox::begin() {
  does("BEGIN");
}

Status Outbox::commit() {
  setNote("newest", std::to_string(newest_));
  if (!failed_ && does("COMMIT")) return Done{};
  const std::string why = sqlite3_errmsg(file_);
  sqlite3_exec(file_, "ROLLBACK", nullptr, nullptr, nullptr);
  return Error{path_, message("cannot be written"), foreign(why)};
}

std::uint64_t Outbox::add(const ShopMessage& told) {
  if (waiting_ >= most_) makeRoom();
  nlohmann::json payload = told.payload;
  payload["schema"] = kShopSchema;
  payload["series"] = series_;
  payload["sequence"] = ++newest_;
  sqlite3_stmt* insert = prepared("INSERT INTO box VALUES(?,?,?,?)");
  put(insert, 1, newest_);
  put(insert, 2, told.topic);
  const std::string text = payload.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  put(insert, 3, text);
  sqlite3_bind_int(insert, 4, told.retained ? 1 : 0);
  if (step(insert)) ++waiting_;
  setNote("newest " + told.topic, text);
  return newest_;
}

void Outbox::makeRoom() {
  for (const char* sql :
       {"DELETE FROM box WHERE sequence IN (SELECT sequence FROM box WHERE topic='features' ORDER BY sequence LIMIT "
        "1000)",
        "DELETE FROM box WHERE sequence IN (SELECT sequence FROM box ORDER BY sequence LIMIT 1000)"}) {
    step(prepared(sql));
    const auto gone = static_cast<std::uint64_t>(sqlite3_changes(file_));
    waiting_ -= gone;
    if (gone == 0) continue;
    const std::string lost = std::to_string(toNumber(note("dropped")) + static_cast<std::int64_t>(gone));
    setNote("dropped", lost);
    return;
  }
}

Status Outbox::forget(const std::vector<std::uint64_t>& sequences) {
  does("PRAGMA synchronous=NORMAL");
  begin();
  for (const std::uint64_t sequence : sequences) {
    sqlite3_stmt* gone = prepared("DELETE FROM box WHERE sequence=?");
    put(gone, 1, sequence);
    if (step(gone)) waiting_ -= static_cast<std::uint64_t>(sqlite3_changes(file_));
  }
  Status forgot = commit();
  does("PRAGMA synchronous=FULL");
  return forgot;
}

void Outbox::setNote(std::string_view key, std::string_view value) {
  sqlite3_stmt* set = prepared("INSERT OR REPLACE INTO note VALUES(?,?)");
  put(set, 1, key);
  put(set, 2, value);
  step(set);
}

bool Outbox::takeLine(std::int64_t run, std::uint64_t line) {
  sqlite3_stmt* last = prepared("SELECT line FROM run WHERE began=?");
  sqlite3_bind_int64(last, 1, run);
  const bool known = sqlite3_step(last) == SQLITE_ROW;
  const auto newest = known ? static_cast<std::uint64_t>(sqlite3_column_int64(last, 0)) : 0;
  sqlite3_reset(last);
  if (known && line <= newest) return false;
  sqlite3_stmt* take = prepared("INSERT OR REPLACE INTO run VALUES(?,?)");
  sqlite3_bind_int64(take, 1, run);
  put(take, 2, line);
  step(take);
  if (known) return true;
  sqlite3_stmt* old =
      prepared("DELETE FROM run WHERE began NOT IN (SELECT began FROM run ORDER BY began DESC LIMIT ?)");
  sqlite3_bind_int(old, 1, kRunsKept);
  step(old);
  return true;
}

std::string Outbox::note(std::string_view key) const {
  sqlite3_stmt* find = prepared("SELECT value FROM note WHERE key=?");
  put(find, 1, key);
  std::string value;
  if (sqlite3_step(find) == SQLITE_ROW) value = column(find, 0);
  sqlite3_reset(find);
  return value;
}

std::vector<Outbox::Kept> Outbox::after(std::uint64_t sequence, int atMost) const {
  sqlite3_stmt* next =
      prepared("SELECT sequence,topic,payload,retained FROM box WHERE sequence>? ORDER BY sequence LIMIT ?");
  put(next, 1, sequence);
  sqlite3_bind_int(next, 2, atMost);
  std::vector<Kept> all;
  while (sqlite3_step(next) == SQLITE_ROW) {
    all.push_back({static_cast<std::uint64_t>(sqlite3_column_int64(next, 0)), column(next, 1), column(next, 2),
                   sqlite3_column_int(next, 3) != 0});
  }
  sqlite3_reset(next);
  return all;
}

}  // namespace stillcut::shop
