#include "core/config/toml_edit.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/config/toml_text.h"

namespace stillcut::config {
namespace {

struct Leaf {
  TomlPath path;
  std::string value;  // as TomlWriter writes it
};

TomlPath parentOf(TomlPath path) {
  path.pop_back();
  return path;
}

bool startsWith(const TomlPath& path, const TomlPath& begin) {
  return path.size() >= begin.size() && std::equal(begin.begin(), begin.end(), path.begin());
}

bool isNumber(const std::string& key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::string spelled(const std::string& key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_';
  });
  return bare ? key : '"' + key + '"';
}

// "channels", "0", "name" is written channels.name: the number stands in no header.
std::string dotted(const TomlPath& path, std::size_t from = 0) {
  std::string text;
  for (std::size_t i = from; i < path.size(); ++i) {
    if (!isNumber(path[i])) text += (text.empty() ? "" : ".") + spelled(path[i]);
  }
  return text;
}

std::vector<Leaf> leavesOf(std::string_view text) {
  std::vector<Leaf> leaves;
  for (const TomlSpot& s : tomlSpots(text)) {
    if (s.what != TomlSpot::What::Entry) continue;
    leaves.push_back({s.path, std::string(text.substr(s.valueBegin, s.valueEnd - s.valueBegin))});
  }
  return leaves;
}

// The names of an array's elements, each once; empty where there are none or some are alike.
std::vector<std::string> namesOf(const std::vector<Leaf>& leaves, const std::string& array) {
  std::vector<std::string> names;
  for (const Leaf& leaf : leaves) {
    if (leaf.path.size() == 3 && leaf.path[0] == array && leaf.path[2] == "name") names.push_back(leaf.value);
  }
  const std::set<std::string> different(names.begin(), names.end());
  return different.size() == names.size() ? names : std::vector<std::string>();
}

// Elements that were there keep their number; new ones get numbers behind all others, and `follows` says behind which
// they come.
struct Renumbering {
  std::map<std::string, std::string> number;   // of after -> of before
  std::map<std::string, std::string> follows;  // of a new element
};

Renumbering renumbered(const std::vector<std::string>& before, const std::vector<std::string>& after) {
  Renumbering r;
  std::size_t next = before.size(), reached = 0;
  std::string last;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto known = std::find(before.begin(), before.end(), after[i]);
    const auto place = static_cast<std::size_t>(known - before.begin());
    if (known != before.end() && place < reached) return {};  // another order: by their places
    if (known != before.end()) reached = place + 1;
    const std::string number = std::to_string(known != before.end() ? place : next++);
    if (known == before.end()) r.follows[number] = last;
    r.number[std::to_string(i)] = number;
    last = number;
  }
  return r;
}

class Editor {
 public:
  Editor(std::string_view written, std::string_view before, std::string_view after)
      : written_(written),
        newline_(written.find("\r\n") != std::string_view::npos ? "\r\n" : "\n"),
        spots_(tomlSpots(written)),
        before_(leavesOf(before)),
        after_(leavesOf(after)) {}

  std::string run() {
    matchElements();
    std::map<TomlPath, std::string> was, is;
    for (const Leaf& leaf : before_) was[leaf.path] = leaf.value;
    for (const Leaf& leaf : after_) is[leaf.path] = leaf.value;
    for (const Leaf& leaf : after_) {
      const auto known = was.find(leaf.path);
      if (known == was.end() || known->second != leaf.value) set(leaf);
    }
    for (const Leaf& leaf : before_) {
      if (!is.contains(leaf.path)) remove(leaf.path);
    }
    removeElements(is);
    writeTables();
    return applied();
  }

 private:
  using What = TomlSpot::What;
  struct Edit {
    std::size_t begin, end;
    std::string text;
  };

  void matchElements() {
    std::set<std::string> arrays;
    for (const Leaf& leaf : after_) {
      if (leaf.path.size() > 2 && isNumber(leaf.path[1])) arrays.insert(leaf.path[0]);
    }
    for (const std::string& array : arrays) {
      const Renumbering r = renumbered(namesOf(before_, array), namesOf(after_, array));
      if (r.number.empty()) continue;
      for (Leaf& leaf : after_) {
        if (leaf.path.size() > 2 && leaf.path[0] == array) leaf.path[1] = r.number.at(leaf.path[1]);
      }
      for (const auto& [number, last] : r.follows) follows_[{array, number}] = {array, last};
    }
  }

  const TomlSpot* entryAt(const TomlPath& path) const {
    for (const TomlSpot& s : spots_) {
      if (s.what == What::Entry && s.path == path) return &s;
    }
    return nullptr;
  }
  // The inline table or the array that holds the path.
  const TomlSpot* holderOf(const TomlPath& path) const {
    for (const TomlSpot& s : spots_) {
      if (s.what != What::Entry || s.path.size() >= path.size() || !startsWith(path, s.path)) continue;
      const char first = s.valueBegin < written_.size() ? written_[s.valueBegin] : '\0';
      if (first == '{' || first == '[') return &s;
    }
    return nullptr;
  }
  template <typename Holds>
  const TomlSpot* lastSpot(const Holds& holds) const {
    const auto last = std::find_if(spots_.rbegin(), spots_.rend(), holds);
    return last == spots_.rend() ? nullptr : &*last;
  }

  void set(const Leaf& leaf) {
    if (const TomlSpot* entry = entryAt(leaf.path)) {
      edits_.push_back({entry->valueBegin, entry->valueEnd, leaf.value});
      return;
    }
    if (const TomlSpot* holder = holderOf(leaf.path)) return writeAgain(*holder);
    const TomlPath parent = parentOf(leaf.path);
    const std::string line = spelled(leaf.path.back()) + " = " + leaf.value + newline_;
    const TomlSpot* neighbour =
        lastSpot([&](const TomlSpot& s) { return s.what == What::Entry && parentOf(s.path) == parent; });
    const TomlSpot* header = lastSpot([&](const TomlSpot& s) { return s.what == What::Header && s.path == parent; });
    if (neighbour != nullptr) {
      // With the indent and the dotted name of the neighbour.
      const std::string_view begin = written_.substr(neighbour->lineBegin, neighbour->keyEnd - neighbour->lineBegin);
      insert(neighbour->lineEnd, std::string(begin) + line);
    } else if (header != nullptr) {
      insert(header->lineEnd, line);
    } else if (parent.empty()) {
      const auto first =
          std::find_if(spots_.begin(), spots_.end(), [](const TomlSpot& s) { return s.what == What::Header; });
      insert(first == spots_.end() ? written_.size() : first->lineBegin, line);
    } else {
      auto table = std::find_if(tables_.begin(), tables_.end(), [&](const auto& t) { return t.first == parent; });
      if (table == tables_.end()) table = tables_.insert(tables_.end(), {parent, ""});
      table->second += line;
    }
  }

  void insert(std::size_t at, std::string text) {
    const bool open = at > 0 && at == written_.size() && written_[at - 1] != '\n';
    edits_.push_back({at, at, (open && !opened_ ? newline_ : "") + std::move(text)});
    opened_ = opened_ || open;
  }

  void remove(const TomlPath& path) {
    if (const TomlSpot* entry = entryAt(path)) return removeLine(*entry);
    if (const TomlSpot* holder = holderOf(path)) writeAgain(*holder);
  }
  void removeLine(const TomlSpot& spot) {
    const std::size_t indent = written_.find_first_not_of(" \t", spot.lineBegin);
    if (spot.comment == std::string_view::npos) {
      edits_.push_back({spot.lineBegin, spot.lineEnd, ""});
    } else {
      edits_.push_back({indent, spot.comment, ""});
    }
  }
  // The header of an element none of whose values is left.
  void removeElements(const std::map<TomlPath, std::string>& is) {
    for (const TomlSpot& s : spots_) {
      if (s.what != What::Header || !s.element) continue;
      const bool left =
          std::any_of(is.begin(), is.end(), [&](const auto& leaf) { return startsWith(leaf.first, s.path); });
      if (!left) removeLine(s);
    }
  }

  // An inline table or an array of them, whole, from what it shall hold.
  void writeAgain(const TomlSpot& holder) {
    if (!again_.insert(holder.valueBegin).second) return;
    std::string text;
    if (written_[holder.valueBegin] == '{') {
      text = inlineTable(holder.path);
    } else {
      for (const TomlPath& element : elementsOf(holder.path))
        text.append("  ").append(inlineTable(element)).append(",").append(newline_);
      text = "[" + newline_ + text + "]";
    }
    edits_.push_back({holder.valueBegin, holder.valueEnd, text});
  }
  std::string inlineTable(const TomlPath& path) const {
    std::string text;
    for (const Leaf& leaf : after_) {
      if (startsWith(leaf.path, path))
        text.append(text.empty() ? "" : ", ").append(dotted(leaf.path, path.size())).append(" = ").append(leaf.value);
    }
    return text.empty() ? "{}" : "{ " + text + " }";
  }
  std::vector<TomlPath> elementsOf(const TomlPath& array) const {
    std::vector<TomlPath> elements;
    for (const Leaf& leaf : after_) {
      if (!startsWith(leaf.path, array) || leaf.path.size() <= array.size()) continue;
      const TomlPath element(leaf.path.begin(), leaf.path.begin() + static_cast<std::ptrdiff_t>(array.size()) + 1);
      if (elements.empty() || elements.back() != element) elements.push_back(element);
    }
    return elements;
  }

  // Tables that are not in the text: behind their kin, else at the end.
  void writeTables() {
    for (const auto& [path, lines] : tables_) {
      const bool element = path.size() > 1 && isNumber(path.back());
      const std::string name = dotted(path);
      std::string block = newline_;
      block.append(element ? "[[" : "[").append(name).append(element ? "]]" : "]").append(newline_).append(lines);
      const TomlSpot* kin = kinOf(path);
      insert(kin != nullptr ? kin->lineEnd : written_.size(), std::move(block));
    }
  }
  const TomlSpot* kinOf(const TomlPath& path) const {
    const auto lastBelow = [this](const TomlPath& begin) {
      return lastSpot([&](const TomlSpot& s) { return startsWith(s.path, begin); });
    };
    // New elements one after the other come behind the same old one.
    TomlPath before = path;
    while (true) {
      const auto last = follows_.find(before);
      if (last == follows_.end()) break;
      before = last->second;
    }
    if (before != path && !before.back().empty()) {
      if (const TomlSpot* spot = lastBelow(before)) return spot;
    }
    return lastBelow({path.front()});
  }

  std::string applied() {
    std::stable_sort(edits_.begin(), edits_.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
    std::string text;
    std::size_t done = 0;
    for (const Edit& e : edits_) {
      text += written_.substr(done, e.begin - std::min(e.begin, done));
      text += e.text;
      done = std::max(done, e.end);
    }
    return text + std::string(written_.substr(done));
  }

  std::string_view written_;
  std::string newline_;
  std::vector<TomlSpot> spots_;
  std::vector<Leaf> before_, after_;
  std::map<TomlPath, TomlPath> follows_;
  std::vector<Edit> edits_;
  std::vector<std::pair<TomlPath, std::string>> tables_;  // to be made, with their lines
  std::set<std::size_t> again_;                           // values that are written again whole
  bool opened_ = false;                                   // the last line, which ended without a line's end
};

}  // namespace

std::string editedToml(std::string_view written, std::string_view before, std::string_view after) {
  return Editor(written, before, after).run();
}

}  // namespace stillcut::config
