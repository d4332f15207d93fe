// A sentence and what it tells of, kept apart: files and the command line show it as it is, the screens translate the
// form, and the values that are words, before they put them together. Plain value; made at set-up, never on the sample
// path. Any thread.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace stillcut {

struct Phrase {
  std::string form;                 // English, with places %1 .. %9
  std::vector<std::string> values;  // for the places, in their order

  bool operator==(const Phrase&) const = default;
};

// "where: what (why)".
Phrase phraseOf(const Error& error);

// As it is, in English; several are joined by "; ".
std::string text(const Phrase& phrase);
std::string text(const std::vector<Phrase>& phrases);

}  // namespace stillcut
