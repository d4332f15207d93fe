#include "core/milling/identify/import/frf_columns.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>

#include "core/milling/identify/import/unit_label.h"

namespace stillcut::identify {
namespace {

// Letters and digits that stand together, in small letters; bytes of other alphabets count as letters.
std::vector<std::string> wordsOf(std::string_view name) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool letter = upper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80) != 0;
    if (letter) {
      words.back() += upper ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

struct RoleWord {
  std::string_view word;
  ColumnRole role;
};
using R = ColumnRole;
constexpr auto kRoleWords = std::to_array<RoleWord>({
    {"f", R::Frequency},
    {"freq", R::Frequency},
    {"frequency", R::Frequency},
    {"frequencies", R::Frequency},
    {"frequenz", R::Frequency},
    {"frecuencia", R::Frequency},
    {"frequence", R::Frequency},
    {"fr\xC3\xA9quence", R::Frequency},
    {"omega", R::Frequency},
    {"hz", R::Frequency},
    {"freqs", R::Frequency},
    {"re", R::Real},
    {"real", R::Real},
    {"realteil", R::Real},
    {"realpart", R::Real},
    {"im", R::Imaginary},
    {"imag", R::Imaginary},
    {"imaginary", R::Imaginary},
    {"imagin\xC3\xA4r", R::Imaginary},
    {"imagin\xC3\xA4rteil", R::Imaginary},
    {"imaginaerteil", R::Imaginary},
    {"mag", R::Magnitude},
    {"magn", R::Magnitude},
    {"magnitude", R::Magnitude},
    {"amplitude", R::Magnitude},
    {"ampl", R::Magnitude},
    {"abs", R::Magnitude},
    {"modulus", R::Magnitude},
    {"betrag", R::Magnitude},
    {"phase", R::Phase},
    {"phas", R::Phase},
    {"arg", R::Phase},
    {"coherence", R::Coherence},
    {"coh", R::Coherence},
    {"koh\xC3\xA4renz", R::Coherence},
    {"kohaerenz", R::Coherence},
    {"gamma2", R::Coherence},
    {"line", R::RowNumber},
    {"no", R::RowNumber},
    {"nr", R::RowNumber},
    {"index", R::RowNumber},
    {"idx", R::RowNumber},
    {"bin", R::RowNumber},
});

// "gxx", "hxy", "frfyy", "xx": response first, force second, as in G_xy.
bool takePair(const std::string& word, ColumnMeaning& meaning) {
  if (word.size() < 2) return false;
  const std::string_view before = std::string_view(word).substr(0, word.size() - 2);
  constexpr auto kSymbols =
      std::to_array<std::string_view>({"", "g", "h", "a", "y", "frf", "phi", "alpha", "h1", "h2"});
  if (std::find(kSymbols.begin(), kSymbols.end(), before) == kSymbols.end()) return false;
  const Axis along = axisFromLetter(word[word.size() - 2]);
  const Axis force = axisFromLetter(word.back());
  if (along == Axis::Unknown || force == Axis::Unknown) return false;
  meaning.along = along;
  meaning.force = force;
  return true;
}

}  // namespace

ColumnMeaning meaningOfColumn(const TableColumn& column) {
  ColumnMeaning meaning;
  for (const std::string& word : wordsOf(column.name)) {
    const auto known =
        std::find_if(kRoleWords.begin(), kRoleWords.end(), [&](const RoleWord& r) { return r.word == word; });
    // "Real part", "Real freq response": the first word that names a role does.
    if (known != kRoleWords.end() && meaning.role == R::Unknown) {
      meaning.role = known->role;
      continue;
    }
    if (word == "part" || word == "of") continue;
    meaning.response += (meaning.response.empty() ? "" : " ") + word;
    if (takePair(word, meaning) || word.size() != 1 || axisFromLetter(word[0]) == Axis::Unknown) continue;
    // "X/Y": along x by a force along y. "X" alone: whether each axis was hit by itself, or one for both, is not said.
    (meaning.along == Axis::Unknown ? meaning.along : meaning.force) = axisFromLetter(word[0]);
  }
  if (frequencyUnit(column.unit)) meaning.role = R::Frequency;
  if (angleUnit(column.unit)) meaning.role = R::Phase;
  if (!column.imaginary.empty()) meaning.role = R::Complex;
  if (meaning.role == R::Frequency || meaning.role == R::RowNumber) meaning = ColumnMeaning{meaning.role, "", {}, {}};
  return meaning;
}

namespace {

bool isCount(const std::vector<double>& column) {
  for (std::size_t i = 0; i < column.size(); ++i) {
    if (column[i] != column[0] + static_cast<double>(i)) return false;
  }
  return column[0] == 0.0 || column[0] == 1.0;
}

bool rises(const std::vector<double>& column) {
  return std::adjacent_find(column.begin(), column.end(), [](double a, double b) { return b <= a; }) == column.end();
}

bool anyIs(const std::vector<ColumnMeaning>& all, std::initializer_list<ColumnRole> roles) {
  return std::any_of(all.begin(), all.end(), [&](const ColumnMeaning& m) {
    return std::find(roles.begin(), roles.end(), m.role) != roles.end();
  });
}

}  // namespace

std::vector<ColumnMeaning> meaningOfColumns(const NumberTable& table) {
  std::vector<ColumnMeaning> all;
  for (const TableColumn& column : table.columns) all.push_back(meaningOfColumn(column));
  std::size_t first = 0;
  if (all.size() >= 4 && all[0].role == R::Unknown && isCount(table.columns[0].real) && rises(table.columns[1].real)) {
    all[0].role = R::RowNumber;
    first = 1;
  }
  if (!anyIs(all, {R::Frequency}) && all[first].role == R::Unknown) all[first] = {R::Frequency, "", {}, {}};
  if (anyIs(all, {R::Real, R::Imaginary, R::Complex, R::Magnitude, R::Phase})) return all;
  std::vector<std::size_t> left;
  for (std::size_t c = 0; c < all.size(); ++c) {
    if (all[c].role == R::Unknown) left.push_back(c);
  }
  if (left.size() != 2) return all;
  all[left[0]].role = R::Real;
  all[left[1]].role = R::Imaginary;
  all[left[1]].response = all[left[0]].response = "";
  return all;
}

}  // namespace stillcut::identify
