#include "tests/golden/trace.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

namespace stillcut::test {
namespace {

constexpr double kShare = 1e-3;  // other libraries round otherwise
constexpr std::size_t kMostLines = 10;

bool isWhole(const Trace& trace, std::size_t column) {
  return std::all_of(trace.rows.begin(), trace.rows.end(),
                     [column](const auto& row) { return row[column] == std::round(row[column]); });
}

double largest(const Trace& trace, std::size_t column) {
  double most = 0.0;
  for (const auto& row : trace.rows) most = std::max(most, std::abs(row[column]));
  return most;
}

std::string shown(double value) {
  constexpr double kNothing = 1e-9;  // what decays for ever is no change to look at
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", std::abs(value) < kNothing ? 0.0 : value);
  return text;
}

}  // namespace

std::string Trace::text() const {
  std::string out;
  for (std::size_t c = 0; c < names.size(); ++c) out += (c ? "," : "") + names[c];
  out += '\n';
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) out += (c ? "," : "") + shown(row[c]);
    out += '\n';
  }
  return out;
}

Trace Trace::parse(const std::string& csv) {
  Trace trace;
  std::istringstream lines(csv);
  std::string line, cell;
  std::getline(lines, line);
  for (std::istringstream cells(line); std::getline(cells, cell, ',');) trace.names.push_back(cell);
  while (std::getline(lines, line)) {
    std::vector<double> row;
    for (std::istringstream cells(line); std::getline(cells, cell, ',');)
      row.push_back(std::strtod(cell.c_str(), nullptr));
    row.resize(trace.names.size());
    trace.rows.push_back(std::move(row));
  }
  return trace;
}

std::string departures(const Trace& kept, const Trace& now, double share) {
  if (kept.names != now.names || kept.rows.size() != now.rows.size())
    return "other columns or another number of rows\n";
  std::string out;
  std::size_t lines = 0;
  for (std::size_t c = 0; c < kept.names.size(); ++c) {
    const bool whole = isWhole(kept, c) && isWhole(now, c);
    const double allowed = share * largest(kept, c);
    for (std::size_t r = 0; r < kept.rows.size() && lines < kMostLines; ++r) {
      const double was = kept.rows[r][c];
      const double is = now.rows[r][c];
      const bool turned =
          whole && ((r > 0 && is == kept.rows[r - 1][c]) || (r + 1 < kept.rows.size() && is == kept.rows[r + 1][c]));
      if (std::abs(was - is) <= allowed || turned) continue;
      out += kept.names[c] + " at " + shown(kept.rows[r][0]) + " s: was " + shown(was) + ", is " + shown(is) + "\n";
      ++lines;
    }
  }
  return out;
}

std::string holdToGolden(const std::string& name, const Trace& now) {
  const std::string path = STILLCUT_SOURCE_DIR "/tests/golden/" + name + ".csv";
  const char* wish = std::getenv("STILLCUT_GOLDEN");
  if (wish != nullptr && std::string_view(wish) == "write") {
    std::ofstream out(path);
    out << now.text();
    return out.flush() ? "" : path + " cannot be written";
  }
  std::ifstream in(path);
  if (!in) return path + " cannot be read";
  const std::string kept{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  // Rounded as the file is.
  return departures(Trace::parse(kept), Trace::parse(now.text()), kShare);
}

}  // namespace stillcut::test
