#include "core/config/param_set.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>

#include "core/config/nearest_word.h"
#include "core/units/number_text.h"

namespace stillcut::config {
namespace {

Message range(const ParamDecl& decl) {
  const std::string unit = decl.unit.empty() ? std::string() : " " + std::string(decl.unit);
  const std::string highest = numberText(decl.highest) + unit;
  return decl.mayBeAutomatic ? message("allowed: %1 to %2, or auto", numberText(decl.lowest), highest)
                             : message("allowed: %1 to %2", numberText(decl.lowest), highest);
}

std::optional<double> parseNumber(std::string_view text) {
  double v = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), v);
  if (code != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return v;
}

std::string place(std::string_view where, const ParamDecl& decl) {
  return std::string(where) + ": " + std::string(decl.key);
}

Result<double> parse(const ParamDecl& decl, std::string_view text, std::string_view where) {
  if (decl.mayBeAutomatic && text == "auto") return kAutomatic;
  if (decl.kind == ParamKind::Boolean) {
    if (text == "true") return 1.0;
    if (text == "false") return 0.0;
    return Error{place(where, decl), message("'%1' is neither true nor false", text)};
  }
  if (decl.kind == ParamKind::Choice) {
    const auto it = std::find(decl.choices.begin(), decl.choices.end(), text);
    if (it != decl.choices.end()) return static_cast<double>(it - decl.choices.begin());
    std::string all;
    for (std::string_view c : decl.choices) all += (all.empty() ? "" : ", ") + std::string(c);
    return Error{place(where, decl), message("'%1' is not a choice", text), message("choices: %1", all)};
  }
  const auto number = parseNumber(text);
  if (!number) return Error{place(where, decl), message("'%1' is not a number", text), range(decl)};
  return *number;
}

}  // namespace

void ParamCatalog::add(ParamTable table) {
  for (const ParamDecl* decl : table) {
    if (find(decl->key) == nullptr) decls_.push_back(decl);
  }
}

const ParamDecl* ParamCatalog::find(std::string_view key) const {
  const auto it = std::find_if(decls_.begin(), decls_.end(), [&](const ParamDecl* d) { return d->key == key; });
  return it == decls_.end() ? nullptr : *it;
}

std::string_view ParamCatalog::nearest(std::string_view key) const {
  std::vector<std::string_view> keys;
  for (const ParamDecl* decl : decls_) keys.push_back(decl->key);
  return nearestWord(key, keys);
}

double ParamSet::real(const ParamDecl& decl) const {
  const auto it = values_.find(decl.key);
  return it == values_.end() ? decl.fallback : it->second;
}
int ParamSet::integer(const ParamDecl& decl) const {
  return static_cast<int>(std::lround(real(decl)));
}
bool ParamSet::boolean(const ParamDecl& decl) const {
  return real(decl) != 0.0;
}
int ParamSet::choice(const ParamDecl& decl) const {
  return integer(decl);
}
bool ParamSet::isAutomatic(const ParamDecl& decl) const {
  return decl.mayBeAutomatic && std::isnan(real(decl));
}
bool ParamSet::isSet(const ParamDecl& decl) const {
  return values_.contains(decl.key);
}

Status ParamSet::set(const ParamCatalog& catalog, std::string_view key, std::string_view text, std::string_view where) {
  const ParamDecl* decl = catalog.find(key);
  if (decl == nullptr) {
    const std::string_view near = catalog.nearest(key);
    return Error{std::string(where), message("unknown key '%1'", key),
                 near.empty() ? Message() : message("did you mean '%1'?", near)};
  }
  const Result<double> value = parse(*decl, text, where);
  if (!value) return value.error();
  return set(*decl, *value, where);
}

Status ParamSet::set(const ParamDecl& decl, double value, std::string_view where) {
  const bool automatic = decl.mayBeAutomatic && std::isnan(value);
  if (!automatic) {
    if (!std::isfinite(value))
      return Error{place(where, decl), message("the value is not a finite number"), range(decl)};
    if (decl.kind == ParamKind::Integer && value != std::round(value)) {
      return Error{place(where, decl), message("%1 is not a whole number", numberText(value)), range(decl)};
    }
    if (value < decl.lowest || value > decl.highest) {
      return Error{place(where, decl), message("%1 is out of range", numberText(value)), range(decl)};
    }
  }
  values_.insert_or_assign(std::string(decl.key), value);
  return Done{};
}

bool ParamSet::replace(const ParamDecl& decl, double value) noexcept {
  const auto it = values_.find(decl.key);
  if (it == values_.end() || !isLegal(decl, value)) return false;
  it->second = value;
  return true;
}

void ParamSet::unset(const ParamDecl& decl) {
  const auto it = values_.find(decl.key);
  if (it != values_.end()) values_.erase(it);
}

std::string ParamSet::text(const ParamDecl& decl) const {
  if (isAutomatic(decl)) return "auto";
  if (decl.kind == ParamKind::Boolean) return boolean(decl) ? "true" : "false";
  if (decl.kind == ParamKind::Choice) return std::string(decl.choices[static_cast<std::size_t>(choice(decl))]);
  return numberText(real(decl));
}

}  // namespace stillcut::config
