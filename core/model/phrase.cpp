#include "core/model/phrase.h"

#include <cstddef>

namespace stillcut {

Phrase phraseOf(const Error& error) {
  Phrase phrase{error.where.empty() ? "%1" : "%1: %2", {error.what}};
  if (!error.where.empty()) phrase.values.insert(phrase.values.begin(), error.where);
  if (error.why.empty()) return phrase;
  phrase.values.push_back(error.why);
  phrase.form += " (%" + std::to_string(phrase.values.size()) + ')';
  return phrase;
}

std::string text(const Phrase& phrase) {
  std::string out;
  for (std::size_t k = 0; k < phrase.form.size(); ++k) {
    const char next = k + 1 < phrase.form.size() ? phrase.form[k + 1] : ' ';
    const auto place = static_cast<std::size_t>(next - '1');
    if (phrase.form[k] != '%' || next < '1' || place >= phrase.values.size()) {
      out += phrase.form[k];
      continue;
    }
    out += phrase.values[place];
    ++k;
  }
  return out;
}

std::string text(const std::vector<Phrase>& phrases) {
  std::string out;
  for (const Phrase& phrase : phrases) out += (out.empty() ? "" : "; ") + text(phrase);
  return out;
}

}  // namespace stillcut
