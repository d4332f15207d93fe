// ParamSet: the values in force, by key; what is not set has its declared default. ParamCatalog: every declaration
// there is, against which keys and values are checked.
// Thread: set-up only; parts read what they need in prepare() and keep it in plain members.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/config/param.h"

namespace stillcut::config {

class ParamCatalog {
 public:
  void add(ParamTable table);
  const ParamDecl* find(std::string_view key) const;
  // The declared key with the smallest edit distance, for "did you mean"; empty when nothing is near.
  std::string_view nearest(std::string_view key) const;
  const std::vector<const ParamDecl*>& all() const { return decls_; }

 private:
  std::vector<const ParamDecl*> decls_;  // in the order added
};

class ParamSet {
 public:
  double real(const ParamDecl& decl) const;  // NaN when automatic
  int integer(const ParamDecl& decl) const;
  bool boolean(const ParamDecl& decl) const;
  int choice(const ParamDecl& decl) const;  // index into decl.choices
  bool isAutomatic(const ParamDecl& decl) const;
  bool isSet(const ParamDecl& decl) const;

  // Checks key, kind, range; `where` names the origin for the error ("--set", "mill3.toml:14").
  // Unknown key: the error names the nearest known one. Nothing changes on error.
  Status set(const ParamCatalog& catalog, std::string_view key, std::string_view text, std::string_view where);
  // Same with a value already parsed.
  Status set(const ParamDecl& decl, double value, std::string_view where);
  void unset(const ParamDecl& decl);
  // A value for a key that is set already. False: it is not, or the value is not legal; nothing changes. Real-time.
  bool replace(const ParamDecl& decl, double value) noexcept;

  // As text a file and set() both understand: "auto", "true", "0.2", the choice's word.
  std::string text(const ParamDecl& decl) const;
  // Keys that are set, in order.
  const std::map<std::string, double, std::less<>>& values() const { return values_; }

 private:
  std::map<std::string, double, std::less<>> values_;
};

}  // namespace stillcut::config
