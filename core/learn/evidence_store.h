// Every judged cut, kept: one SQLite file. A cut is written whole or not at all, survives a kill and a power cut
// (transactions, synchronous), and is known by its id, so that stores of several machines merge without duplicates.
// Several programs may have the file open.
// Thread: one at a time. Waits for the disk: never the sample path.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/learn/cut_evidence.h"

namespace stillcut::learn {

// Which cuts; an empty field takes all.
struct EvidenceFilter {
  std::string machine, tool, holder;
  std::optional<Metres> stickOut;  // to 0.5 mm
};

struct AssemblyCount {
  Assembly assembly;
  int stable = 0, chatter = 0;
};

struct MergeCount {
  int added = 0;
  int known = 0;  // were there already
};

class EvidenceStore {
 public:
  // Makes the file where there is none. Error: another program's database, a newer version's, no database at all; the
  // file is left as it is.
  static Result<EvidenceStore> open(const std::filesystem::path& path);
  // The same without making or writing: for a store that is merged from.
  static Result<EvidenceStore> openToRead(const std::filesystem::path& path);
  EvidenceStore(EvidenceStore&&) noexcept;
  EvidenceStore& operator=(EvidenceStore&&) noexcept;
  ~EvidenceStore();

  // Gives the id back, a new one where the cut has none.
  Result<std::string> add(const CutEvidence& cut);
  // All or none.
  Result<MergeCount> addAll(const std::vector<CutEvidence>& cuts);
  Result<MergeCount> importLines(std::string_view text, const std::string& where);
  Result<MergeCount> merge(const std::filesystem::path& other);
  // Error: no such id.
  Status remove(const std::string& id);

  Result<std::vector<CutEvidence>> cuts(const EvidenceFilter& filter = {}) const;  // by time
  Result<std::vector<AssemblyCount>> assemblies() const;                           // by name
  Result<std::string> exportLines(const EvidenceFilter& filter = {}) const;

 private:
  class Database;
  explicit EvidenceStore(std::unique_ptr<Database> database);
  std::unique_ptr<Database> database_;
};

}  // namespace stillcut::learn
