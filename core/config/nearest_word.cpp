#include "core/config/nearest_word.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace stillcut::config {
namespace {

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substitute, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string_view nearestWord(std::string_view word, std::span<const std::string_view> words) {
  std::string_view best;
  std::size_t bestDistance = std::max<std::size_t>(3, word.size() / 2);
  for (std::string_view candidate : words) {
    const std::size_t d = editDistance(word, candidate);
    if (d < bestDistance) {
      bestDistance = d;
      best = candidate;
    }
  }
  return best;
}

Message didYouMean(std::string_view word, std::span<const std::string_view> words) {
  const std::string_view near = nearestWord(word, words);
  return near.empty() ? Message() : message("did you mean '%1'?", near);
}

}  // namespace stillcut::config
