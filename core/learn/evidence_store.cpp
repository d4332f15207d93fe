#include "core/learn/evidence_store.h"

#include <sqlite3.h>

#include <cmath>

#include "core/learn/evidence_lines.h"

namespace stillcut::learn {
namespace {

constexpr int kApplication = 0x53744C72;  // "StLr", in the file's header
constexpr int kVersion = 1;
constexpr int kPatience_ms = 5000;  // for another program that is writing

constexpr const char* kTables =
    "CREATE TABLE cut(id TEXT PRIMARY KEY NOT NULL, machine TEXT NOT NULL, tool TEXT NOT NULL, holder TEXT NOT NULL,"
    " stick_out_m REAL NOT NULL, material TEXT NOT NULL, teeth INTEGER NOT NULL, diameter_m REAL NOT NULL,"
    " speed_rpm REAL NOT NULL, depth_m REAL NOT NULL, immersion REAL NOT NULL, up INTEGER NOT NULL, offset REAL,"
    " chatter INTEGER NOT NULL, doubt REAL NOT NULL, frequency_hz REAL NOT NULL, frequency_sd_hz REAL NOT NULL,"
    " time_s INTEGER NOT NULL, source TEXT NOT NULL);"
    "CREATE INDEX cut_assembly ON cut(machine, tool, time_s);";
constexpr const char* kColumns =
    "id, machine, tool, holder, stick_out_m, material, teeth, diameter_m, speed_rpm, depth_m, immersion, up, offset,"
    " chatter, doubt, frequency_hz, frequency_sd_hz, time_s, source";

struct Close {
  void operator()(sqlite3* db) const { sqlite3_close(db); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Connection = std::unique_ptr<sqlite3, Close>;
using Statement = std::unique_ptr<sqlite3_stmt, Close>;

std::string textAt(sqlite3_stmt* row, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(row, column));
  return text == nullptr ? std::string() : std::string(text);
}

CutEvidence cutAt(sqlite3_stmt* row) {
  CutEvidence cut;
  cut.id = textAt(row, 0);
  cut.assembly = {textAt(row, 1), textAt(row, 2), textAt(row, 3), Metres(sqlite3_column_double(row, 4))};
  cut.material = textAt(row, 5);
  cut.teeth = sqlite3_column_int(row, 6);
  cut.diameter = Metres(sqlite3_column_double(row, 7));
  cut.speed = Rpm(sqlite3_column_double(row, 8));
  cut.depth = Metres(sqlite3_column_double(row, 9));
  cut.engagement.radialImmersion = sqlite3_column_double(row, 10);
  cut.engagement.side =
      sqlite3_column_int(row, 11) != 0 ? milling::MillingDirection::Up : milling::MillingDirection::Down;
  if (sqlite3_column_type(row, 12) != SQLITE_NULL) cut.engagement.offset = sqlite3_column_double(row, 12);
  cut.outcome = sqlite3_column_int(row, 13) != 0 ? CutOutcome::Chatter : CutOutcome::Stable;
  cut.doubt = sqlite3_column_double(row, 14);
  cut.frequency = Hertz(sqlite3_column_double(row, 15));
  cut.frequencySd = Hertz(sqlite3_column_double(row, 16));
  cut.time_s = sqlite3_column_int64(row, 17);
  cut.source = textAt(row, 18);
  return cut;
}

void bindText(sqlite3_stmt* s, int place, const std::string& text) {
  sqlite3_bind_text(s, place, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
}

void bindCut(sqlite3_stmt* s, const CutEvidence& cut) {
  bindText(s, 1, cut.id);
  bindText(s, 2, cut.assembly.machine);
  bindText(s, 3, cut.assembly.tool);
  bindText(s, 4, cut.assembly.holder);
  sqlite3_bind_double(s, 5, cut.assembly.stickOut.value);
  bindText(s, 6, cut.material);
  sqlite3_bind_int(s, 7, cut.teeth);
  sqlite3_bind_double(s, 8, cut.diameter.value);
  sqlite3_bind_double(s, 9, cut.speed.value);
  sqlite3_bind_double(s, 10, cut.depth.value);
  sqlite3_bind_double(s, 11, cut.engagement.radialImmersion);
  sqlite3_bind_int(s, 12, cut.engagement.side == milling::MillingDirection::Up ? 1 : 0);
  if (cut.engagement.offset) sqlite3_bind_double(s, 13, *cut.engagement.offset);
  sqlite3_bind_int(s, 14, cut.outcome == CutOutcome::Chatter ? 1 : 0);
  sqlite3_bind_double(s, 15, cut.doubt);
  sqlite3_bind_double(s, 16, cut.frequency.value);
  sqlite3_bind_double(s, 17, cut.frequencySd.value);
  sqlite3_bind_int64(s, 18, cut.time_s);
  bindText(s, 19, cut.source);
}

}  // namespace

class EvidenceStore::Database {
 public:
  Database(Connection connection, std::string path) : connection_(std::move(connection)), path_(std::move(path)) {}

  Error error() const {
    return Error{path_, message("the store of cuts cannot be used"), foreign(sqlite3_errmsg(connection_.get()))};
  }
  const std::string& path() const { return path_; }

  Status run(const char* sql) const {
    if (sqlite3_exec(connection_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) return error();
    return Done{};
  }
  // Null where the text is no statement for this file: then error() says why.
  Statement prepare(const std::string& sql) const {
    sqlite3_stmt* raw = nullptr;
    sqlite3_prepare_v2(connection_.get(), sql.c_str(), static_cast<int>(sql.size()), &raw, nullptr);
    return Statement(raw);
  }
  Result<int> number(const char* sql) const {
    const Statement s = prepare(sql);
    if (!s || sqlite3_step(s.get()) != SQLITE_ROW) return error();
    return sqlite3_column_int(s.get(), 0);
  }
  bool changed() const { return sqlite3_changes(connection_.get()) > 0; }

  // Makes the tables in a file that is empty; refuses one that is another's.
  Status makeReady(bool mayMake) {
    sqlite3_busy_timeout(connection_.get(), kPatience_ms);
    const auto application = number("PRAGMA application_id");
    if (!application) return application.error();
    const auto version = number("PRAGMA user_version");
    if (!version) return version.error();
    const auto tables = number("SELECT count(*) FROM sqlite_master");
    if (!tables) return tables.error();
    if (*tables == 0 && *application == 0 && mayMake) return makeTables();
    if (*application != kApplication) {
      return Error{path_, message("is no store of cuts"), message("it belongs to another program")};
    }
    if (*version > kVersion) {
      return Error{path_, message("is a store of a newer version of Stillcut"), message("update this program")};
    }
    return run("PRAGMA synchronous = FULL");
  }

 private:
  Status makeTables() {
    const std::string sql =
        "PRAGMA synchronous = FULL; BEGIN IMMEDIATE; PRAGMA application_id = " + std::to_string(kApplication) +
        "; PRAGMA user_version = " + std::to_string(kVersion) + "; " + kTables + " COMMIT";
    if (Status made = run(sql.c_str()); made) return made;
    // Another program may have made them in between.
    run("ROLLBACK").ok();
    const auto application = number("PRAGMA application_id");
    return application && *application == kApplication ? Status(Done{}) : Status(error());
  }

  Connection connection_;
  std::string path_;
};

namespace {

// Ends a transaction that was not committed.
template <class Database>
class Transaction {
 public:
  explicit Transaction(const Database& database) : database_(database) {}
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction() {
    if (open_) database_.run("ROLLBACK").ok();
  }
  Status begin() {
    Status begun = database_.run("BEGIN IMMEDIATE");
    open_ = begun.ok();
    return begun;
  }
  Status commit() {
    Status done = database_.run("COMMIT");
    if (done) open_ = false;
    return done;
  }

 private:
  const Database& database_;
  bool open_ = false;
};

Result<Connection> connect(const std::filesystem::path& path, int flags) {
  sqlite3* raw = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &raw, flags, nullptr);
  Connection connection(raw);
  if (code == SQLITE_OK) return connection;
  return Error{path.string(), message("the store of cuts cannot be opened"),
               foreign(raw == nullptr ? "out of memory" : sqlite3_errmsg(raw))};
}

}  // namespace

EvidenceStore::EvidenceStore(std::unique_ptr<Database> database) : database_(std::move(database)) {}
EvidenceStore::EvidenceStore(EvidenceStore&&) noexcept = default;
EvidenceStore& EvidenceStore::operator=(EvidenceStore&&) noexcept = default;
EvidenceStore::~EvidenceStore() = default;

Result<EvidenceStore> EvidenceStore::open(const std::filesystem::path& path) {
  auto connection = connect(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  if (!connection) return connection.error();
  auto database = std::make_unique<Database>(std::move(*connection), path.string());
  if (Status ready = database->makeReady(true); !ready) return ready.error();
  return EvidenceStore(std::move(database));
}

Result<EvidenceStore> EvidenceStore::openToRead(const std::filesystem::path& path) {
  auto connection = connect(path, SQLITE_OPEN_READONLY);
  if (!connection) return connection.error();
  auto database = std::make_unique<Database>(std::move(*connection), path.string());
  if (Status ready = database->makeReady(false); !ready) return ready.error();
  return EvidenceStore(std::move(database));
}

Result<std::string> EvidenceStore::add(const CutEvidence& cut) {
  CutEvidence named = cut;
  if (named.id.empty()) named.id = newEvidenceId();
  if (const auto added = addAll({named}); !added) return added.error();
  return named.id;
}

Result<MergeCount> EvidenceStore::addAll(const std::vector<CutEvidence>& cuts) {
  Transaction transaction(*database_);
  if (Status begun = transaction.begin(); !begun) return begun.error();
  const Statement insert = database_->prepare(std::string("INSERT OR IGNORE INTO cut(") + kColumns +
                                              ") VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  if (!insert) return database_->error();
  MergeCount count;
  for (CutEvidence cut : cuts) {
    if (Status ok = check(cut, database_->path()); !ok) return ok.error();
    if (cut.id.empty()) cut.id = newEvidenceId();
    sqlite3_reset(insert.get());
    sqlite3_clear_bindings(insert.get());
    bindCut(insert.get(), cut);
    if (sqlite3_step(insert.get()) != SQLITE_DONE) return database_->error();
    ++(database_->changed() ? count.added : count.known);
  }
  sqlite3_reset(insert.get());
  if (Status done = transaction.commit(); !done) return done.error();
  return count;
}

Result<MergeCount> EvidenceStore::importLines(std::string_view text, const std::string& where) {
  const auto cuts = readEvidenceLines(text, where);
  if (!cuts) return cuts.error();
  return addAll(*cuts);
}

Result<MergeCount> EvidenceStore::merge(const std::filesystem::path& other) {
  const auto from = openToRead(other);
  if (!from) return from.error();
  const auto found = from->cuts();
  if (!found) return found.error();
  return addAll(*found);
}

Status EvidenceStore::remove(const std::string& id) {
  const Statement s = database_->prepare("DELETE FROM cut WHERE id = ?");
  if (!s) return database_->error();
  bindText(s.get(), 1, id);
  if (sqlite3_step(s.get()) != SQLITE_DONE) return database_->error();
  if (!database_->changed()) return Error{database_->path(), message("holds no cut '%1'", id)};
  return Done{};
}

Result<std::vector<CutEvidence>> EvidenceStore::cuts(const EvidenceFilter& filter) const {
  const Statement s = database_->prepare(
      std::string("SELECT ") + kColumns +
      " FROM cut WHERE (?1 = '' OR machine = ?1) AND (?2 = '' OR tool = ?2) AND (?3 = '' OR holder = ?3)"
      " AND (?4 < 0 OR abs(stick_out_m - ?4) <= 0.0005) ORDER BY time_s, rowid");
  if (!s) return database_->error();
  bindText(s.get(), 1, filter.machine);
  bindText(s.get(), 2, filter.tool);
  bindText(s.get(), 3, filter.holder);
  sqlite3_bind_double(s.get(), 4, filter.stickOut ? filter.stickOut->value : -1.0);
  std::vector<CutEvidence> found;
  int code = SQLITE_ROW;
  while ((code = sqlite3_step(s.get())) == SQLITE_ROW) {
    found.push_back(cutAt(s.get()));
    if (Status ok = check(found.back(), database_->path()); !ok) return ok.error();
  }
  if (code != SQLITE_DONE) return database_->error();
  return found;
}

Result<std::vector<AssemblyCount>> EvidenceStore::assemblies() const {
  const Statement s = database_->prepare(
      "SELECT machine, tool, holder, stick_out_m, sum(chatter = 0), sum(chatter <> 0) FROM cut"
      " GROUP BY machine, tool, holder, stick_out_m ORDER BY machine, tool, holder, stick_out_m");
  if (!s) return database_->error();
  std::vector<AssemblyCount> found;
  int code = SQLITE_ROW;
  while ((code = sqlite3_step(s.get())) == SQLITE_ROW) {
    sqlite3_stmt* row = s.get();
    found.push_back({{textAt(row, 0), textAt(row, 1), textAt(row, 2), Metres(sqlite3_column_double(row, 3))},
                     sqlite3_column_int(row, 4),
                     sqlite3_column_int(row, 5)});
  }
  if (code != SQLITE_DONE) return database_->error();
  return found;
}

Result<std::string> EvidenceStore::exportLines(const EvidenceFilter& filter) const {
  const auto found = cuts(filter);
  if (!found) return found.error();
  std::string text;
  for (const CutEvidence& cut : *found) text += evidenceLine(cut) + "\n";
  return text;
}

}  // namespace stillcut::learn
