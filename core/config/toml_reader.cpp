#include "core/config/toml_reader.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include "core/config/nearest_word.h"
#include "core/units/number_text.h"

namespace stillcut::config {

namespace detail {

struct TomlDocument {
  std::string name;
  toml::table root;
  std::optional<Error> error;
  std::map<const toml::table*, std::set<std::string, std::less<>>> asked;

  void refuse(Message::Argument where, Message what, Message why = {}) {
    if (!error) error = Error{std::move(where), std::move(what), std::move(why)};
  }
  std::string place(const toml::node* node) const {
    const auto line = node != nullptr ? node->source().begin.line : 0;
    return line > 0 ? name + ":" + std::to_string(line) : name;
  }
};

}  // namespace detail

namespace {

using detail::TomlDocument;

const toml::table& tableOf(const void* node) {
  return *static_cast<const toml::table*>(node);
}

Message allowed(double lowest, double highest) {
  if (lowest == -kAnyNumber && highest == kAnyNumber) return {};
  if (highest == kAnyNumber) return message("allowed: %1 and above", numberText(lowest));
  if (lowest == -kAnyNumber) return message("allowed: up to %1", numberText(highest));
  return message("allowed: %1 to %2", numberText(lowest), numberText(highest));
}

// toml++ follows nested keys by recursion, when it reads them and when it lets go of them: 50,000 of them on a line end
// the program. Ours nest four deep.
constexpr int kMostDotsOnALine = 64;

// The line that nests deeper than any file of settings; 0: none. Dots in quotes and between digits are no keys.
std::size_t deepLine(std::string_view content) {
  std::size_t line = 1;
  int dots = 0;
  char quote = 0;
  for (std::size_t i = 0; i < content.size(); ++i) {
    const char c = content[i];
    if (c == '\n') {
      ++line;
      dots = 0;
      quote = 0;
    } else if (quote != 0) {
      if (c == '\\' && quote == '"') ++i;
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#') {
      i = std::min(content.find('\n', i), content.size()) - 1;
    } else if (c == '.') {
      const bool number = i > 0 && i + 1 < content.size() && std::isdigit(static_cast<unsigned char>(content[i - 1])) &&
                          std::isdigit(static_cast<unsigned char>(content[i + 1])) &&
                          (i < 2 || content[i - 2] != '.') && (i + 2 >= content.size() || content[i + 2] != '.');
      if (!number && ++dots > kMostDotsOnALine) return line;
    }
  }
  return 0;
}

// Everything in `table` that nobody asked for, depth first.
void refuseUnasked(TomlDocument& document, const toml::table& table, const std::string& path) {
  const auto& asked = document.asked[&table];
  const std::vector<std::string_view> known(asked.begin(), asked.end());
  for (const auto& [key, node] : table) {
    if (!asked.contains(key.str())) {
      document.refuse(document.place(&node), message("unknown key '%1'", path + std::string(key.str())),
                      didYouMean(key.str(), known));
      continue;
    }
    const std::string inner = path + std::string(key.str()) + ".";
    if (const toml::table* t = node.as_table()) refuseUnasked(document, *t, inner);
    if (const toml::array* a = node.as_array()) {
      for (const toml::node& element : *a) {
        if (const toml::table* t = element.as_table()) refuseUnasked(document, *t, inner);
      }
    }
  }
}

// The parser quotes what it found, line ends included.
std::string oneLine(std::string_view text) {
  std::string line(text);
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return line;
}

}  // namespace

const void* TomlTable::find(std::string_view key, bool required) const {
  if (node_ != nullptr) {
    document_->asked[&tableOf(node_)].emplace(key);
    if (const toml::node* node = tableOf(node_).get(key)) return node;
  }
  if (required) document_->refuse(place(), message("'%1' is missing", path_ + std::string(key)));
  return nullptr;
}

bool TomlTable::has(std::string_view key) const {
  return find(key, false) != nullptr;
}

bool TomlTable::isTable(std::string_view key) const {
  const auto* node = static_cast<const toml::node*>(find(key, false));
  return node != nullptr && node->is_table();
}

std::string TomlTable::place(std::string_view key) const {
  if (node_ == nullptr) return document_->name;
  const toml::table& table = tableOf(node_);
  const toml::node* node = key.empty() ? &table : table.get(key);
  return document_->place(node);
}

void TomlTable::refuse(std::string_view key, const Message& what, const Message& why) const {
  document_->refuse(place(key), message("'%1%2' %3", path_, key, what), why);
}

double TomlTable::number(std::string_view key, double lowest, double highest) const {
  const auto* node = static_cast<const toml::node*>(find(key, true));
  if (node == nullptr) return lowest == -kAnyNumber ? 0.0 : lowest;
  const auto value = node->value<double>();
  if (!node->is_number() || !value) {
    refuse(key, message("is not a number"));
  } else if (!std::isfinite(*value)) {
    refuse(key, message("is not a finite number"));
  } else if (*value < lowest || *value > highest) {
    refuse(key, message("is out of range: %1", numberText(*value)), allowed(lowest, highest));
  } else {
    return *value;
  }
  return lowest == -kAnyNumber ? 0.0 : lowest;
}

int TomlTable::integer(std::string_view key, int lowest, int highest) const {
  const double v = number(key, lowest, highest);
  if (v != std::round(v)) {
    refuse(key, message("is not a whole number"));
    return lowest;
  }
  return static_cast<int>(v);
}

bool TomlTable::boolean(std::string_view key) const {
  const auto* node = static_cast<const toml::node*>(find(key, true));
  if (node == nullptr) return false;
  const auto value = node->value_exact<bool>();
  if (!value) refuse(key, message("is neither true nor false"));
  return value.value_or(false);
}

std::string TomlTable::text(std::string_view key) const {
  const auto* node = static_cast<const toml::node*>(find(key, true));
  if (node == nullptr) return {};
  const auto value = node->value_exact<std::string>();
  if (!value) refuse(key, message("is not a text"));
  return value.value_or("");
}

int TomlTable::choice(std::string_view key, const std::vector<std::string_view>& words) const {
  const std::string word = text(key);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == word) return static_cast<int>(i);
  }
  std::string all;
  for (std::string_view w : words) all += (all.empty() ? "" : ", ") + std::string(w);
  refuse(key, message("is not a choice: '%1'", word), message("choices: %1", all));
  return 0;
}

std::vector<double> TomlTable::numbers(std::string_view key) const {
  std::vector<double> values;
  const auto* node = static_cast<const toml::node*>(find(key, true));
  if (node == nullptr) return values;
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    refuse(key, message("is not an array of numbers"));
    return values;
  }
  for (const toml::node& element : *array) {
    const auto value = element.value<double>();
    if (!element.is_number() || !value || !std::isfinite(*value)) {
      refuse(key, message("holds something that is not a finite number"));
      return {};
    }
    values.push_back(*value);
  }
  return values;
}

std::vector<std::string> TomlTable::texts(std::string_view key) const {
  std::vector<std::string> values;
  const auto* node = static_cast<const toml::node*>(find(key, true));
  if (node == nullptr) return values;
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    refuse(key, message("is not an array of texts"));
    return values;
  }
  for (const toml::node& element : *array) {
    const auto value = element.value_exact<std::string>();
    if (!value) {
      refuse(key, message("holds something that is not a text"));
      return {};
    }
    values.push_back(*value);
  }
  return values;
}

std::vector<std::vector<double>> TomlTable::rows(std::string_view key) const {
  std::vector<std::vector<double>> all;
  const auto* node = static_cast<const toml::node*>(find(key, true));
  if (node == nullptr) return all;
  const toml::array* outer = node->as_array();
  if (outer == nullptr) {
    refuse(key, message("is not an array of rows"));
    return all;
  }
  for (const toml::node& row : *outer) {
    std::vector<double> values;
    const toml::array* inner = row.as_array();
    for (std::size_t i = 0; inner != nullptr && i < inner->size(); ++i) {
      const auto value = (*inner)[i].value<double>();
      if ((*inner)[i].is_number() && value && std::isfinite(*value)) values.push_back(*value);
    }
    if (inner == nullptr || values.size() != inner->size()) {
      refuse(key, message("holds a row that is not all finite numbers"));
      return {};
    }
    all.push_back(std::move(values));
  }
  return all;
}

TomlTable TomlTable::table(std::string_view key) const {
  const auto* node = static_cast<const toml::node*>(find(key, true));
  const std::string inner = path_ + std::string(key) + ".";
  if (node == nullptr) return {document_, nullptr, inner};
  if (!node->is_table()) refuse(key, message("is not a table"));
  return {document_, node->as_table(), inner};
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  std::vector<TomlTable> all;
  const auto* node = static_cast<const toml::node*>(find(key, true));
  if (node == nullptr) return all;
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    refuse(key, message("is not an array of tables"));
    return all;
  }
  for (const toml::node& element : *array) {
    if (!element.is_table()) {
      refuse(key, message("is not an array of tables"));
      return {};
    }
    all.push_back({document_, element.as_table(), path_ + std::string(key) + "."});
  }
  return all;
}

double TomlTable::numberOr(std::string_view key, double fallback, double lowest, double highest) const {
  return has(key) ? number(key, lowest, highest) : fallback;
}
int TomlTable::integerOr(std::string_view key, int fallback, int lowest, int highest) const {
  return has(key) ? integer(key, lowest, highest) : fallback;
}
bool TomlTable::booleanOr(std::string_view key, bool fallback) const {
  return has(key) ? boolean(key) : fallback;
}
std::string TomlTable::textOr(std::string_view key, std::string_view fallback) const {
  return has(key) ? text(key) : std::string(fallback);
}
int TomlTable::choiceOr(std::string_view key, int fallback, const std::vector<std::string_view>& words) const {
  return has(key) ? choice(key, words) : fallback;
}
std::vector<double> TomlTable::numbersOr(std::string_view key, std::vector<double> fallback) const {
  return has(key) ? numbers(key) : std::move(fallback);
}
TomlTable TomlTable::tableOr(std::string_view key) const {
  return has(key) ? table(key) : TomlTable(document_, nullptr, path_ + std::string(key) + ".");
}
std::vector<TomlTable> TomlTable::tablesOr(std::string_view key) const {
  return has(key) ? tables(key) : std::vector<TomlTable>();
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> all;
  if (node_ == nullptr) return all;
  for (const auto& [key, node] : tableOf(node_)) {
    all.emplace_back(key.str());
    document_->asked[&tableOf(node_)].emplace(key.str());
  }
  return all;
}

std::string TomlTable::scalarText(std::string_view key) const {
  const auto* node = static_cast<const toml::node*>(find(key, true));
  if (node == nullptr) return {};
  if (const auto word = node->value_exact<std::string>()) return *word;
  if (const auto flag = node->value_exact<bool>()) return *flag ? "true" : "false";
  if (const auto whole = node->value_exact<std::int64_t>()) return std::to_string(*whole);
  if (node->is_number()) return numberText(node->value<double>().value_or(0.0));
  refuse(key, message("is not a single value"));
  return {};
}

TomlReader::TomlReader(std::unique_ptr<detail::TomlDocument> document) : document_(std::move(document)) {}
TomlReader::~TomlReader() = default;
TomlReader::TomlReader(TomlReader&&) noexcept = default;
TomlReader& TomlReader::operator=(TomlReader&&) noexcept = default;

TomlReader TomlReader::file(const std::string& path) {
  std::error_code code;
  std::ifstream in;
  if (std::filesystem::is_regular_file(path, code)) in.open(path, std::ios::binary);
  // A pipe or a device may never end.
  if (!in.is_open()) {
    auto document = std::make_unique<detail::TomlDocument>();
    document->name = path;
    document->refuse(path, message("cannot be read"),
                     std::filesystem::exists(path, code) ? message("not a readable file") : message("no such file"));
    return TomlReader(std::move(document));
  }
  constexpr std::uintmax_t kLargest = std::uintmax_t{16} << 20U;
  if (std::filesystem::file_size(path, code) > kLargest && !code) {
    auto document = std::make_unique<detail::TomlDocument>();
    document->name = path;
    document->refuse(path, message("is larger than 16 MB: no file of settings"));
    return TomlReader(std::move(document));
  }
  std::stringstream content;
  content << in.rdbuf();
  return text(content.str(), path);
}

TomlReader TomlReader::text(std::string_view content, const std::string& name) {
  auto document = std::make_unique<detail::TomlDocument>();
  document->name = name;
  if (const std::size_t line = deepLine(content); line != 0) {
    document->refuse(name + ":" + std::to_string(line), message("nests tables too deeply: no file of settings"));
    return TomlReader(std::move(document));
  }
  try {
    document->root = toml::parse(content);
    if (document->root.empty()) document->refuse(name, message("is empty"));
  } catch (const toml::parse_error& wrong) {
    document->refuse(name + ":" + std::to_string(wrong.source().begin.line), message("cannot be read as TOML"),
                     message("toml++: %1", oneLine(wrong.description())));
  }
  return TomlReader(std::move(document));
}

TomlTable TomlReader::root() const {
  return {document_.get(), &document_->root, ""};
}

std::optional<Error> TomlReader::error() const {
  return document_->error;
}

Status TomlReader::finish() const {
  if (!document_->error) refuseUnasked(*document_, document_->root, "");
  if (document_->error) return *document_->error;
  return Done{};
}

}  // namespace stillcut::config
