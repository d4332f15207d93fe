#include "tests/lint/edges.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace stillcut::lint {
namespace {

namespace fs = std::filesystem;

struct Include {
  int line = 0;
  std::string target;
  bool angled = false;
};

std::vector<Include> includesOf(const SourceFile& file) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*([<"])([^">]+)[">].*)re");
  std::vector<Include> all;
  std::istringstream text(file.text);
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    std::smatch match;
    if (std::regex_match(line, match, kInclude)) all.push_back({number, match[2], match[1] == "<"});
  }
  return all;
}

// The innermost room that holds the path; nullptr when none does.
const Room* roomOf(std::string_view path, const std::vector<Room>& table) {
  const Room* best = nullptr;
  for (const Room& room : table) {
    const bool inside =
        path.size() > room.folder.size() && path.starts_with(room.folder) && path[room.folder.size()] == '/';
    if (inside && (best == nullptr || room.folder.size() > best->folder.size())) best = &room;
  }
  return best;
}

bool allowed(const Room& from, const Room& to) {
  if (from.folder == to.folder) return true;
  return std::any_of(from.mayInclude.begin(), from.mayInclude.end(), [&](std::string_view word) {
    return word == to.folder || (word == "core/*" && to.folder.starts_with("core/"));
  });
}

bool isOurs(std::string_view path) {
  return path.starts_with("core/") || path.starts_with("ui/") || path.starts_with("app/");
}
bool isSource(std::string_view path) {
  return path.ends_with(".h") || path.ends_with(".cpp");
}
bool isQt(const Include& include) {
  const std::string& t = include.target;
  return t.size() > 1 && t[0] == 'Q' && (t[1] == 't' || (t[1] >= 'A' && t[1] <= 'Z'));
}

// "core_stability" -> the room whose folder begins with core/ and ends in /stability.
const Room* roomOfTarget(std::string_view target, const std::vector<Room>& table) {
  const std::size_t bar = target.find('_');
  if (bar == std::string_view::npos) return nullptr;
  const std::string begin = std::string(target.substr(0, bar)) + "/";
  const std::string end = "/" + std::string(target.substr(bar + 1));
  for (const Room& room : table) {
    if (room.folder.starts_with(begin) && room.folder.ends_with(end)) return &room;
  }
  return nullptr;
}

struct LinkLine {
  std::string file;
  std::string target;
  std::vector<std::string> links;  // our own rooms only
};

std::vector<LinkLine> linkLines(const std::vector<SourceFile>& files) {
  static const std::regex kCall(R"(stillcut_room\(([^)]*)\))");
  static const std::regex kComment("#[^\n]*");
  std::vector<LinkLine> all;
  for (const SourceFile& file : files) {
    if (isSource(file.path)) continue;
    const std::string text = std::regex_replace(file.text, kComment, "");
    for (std::sregex_iterator it(text.begin(), text.end(), kCall), end; it != end; ++it) {
      std::istringstream words((*it)[1].str());
      LinkLine line{file.path, "", {}};
      words >> line.target;
      bool linking = false;
      for (std::string word; words >> word;) {
        if (word == "SOURCES" || word == "LINKS" || word == "PRIVATE_LINKS") {
          linking = word != "SOURCES";
        } else if (linking && (word.starts_with("core_") || word.starts_with("ui_") || word.starts_with("app_"))) {
          line.links.push_back(word);
        }
      }
      all.push_back(line);
    }
  }
  return all;
}

using LinkGraph = std::map<std::string_view, std::set<std::string_view>>;

void collect(const LinkGraph& graph, std::string_view room, std::set<std::string_view>& reached) {
  const auto it = graph.find(room);
  if (it == graph.end()) return;
  for (std::string_view next : it->second) {
    if (reached.insert(next).second) collect(graph, next, reached);
  }
}

}  // namespace

std::vector<SourceFile> readTree(const fs::path& top) {
  std::vector<SourceFile> files;
  for (const char* folder : {"core", "ui", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
      const std::string path = fs::relative(entry.path(), top).string();
      if (!entry.is_regular_file() || (!isSource(path) && entry.path().filename() != "CMakeLists.txt")) continue;
      std::ifstream in(entry.path(), std::ios::binary);
      files.push_back({path, std::string(std::istreambuf_iterator<char>(in), {})});
    }
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return files;
}

std::vector<std::string> forbiddenIncludes(const std::vector<SourceFile>& files, const std::vector<Room>& table) {
  std::vector<std::string> offences;
  for (const SourceFile& file : files) {
    if (!isSource(file.path)) continue;
    const Room* from = roomOf(file.path, table);
    if (from == nullptr) {
      offences.push_back(file.path + ": lies in no room of tests/lint/room_table.h");
      continue;
    }
    for (const Include& include : includesOf(file)) {
      const std::string place = file.path + ":" + std::to_string(include.line) + ": ";
      if (from->folder.starts_with("core/") && isQt(include)) {
        offences.push_back(place + "core knows no Qt, but includes " + include.target);
      } else if (isOurs(include.target)) {
        const Room* to = roomOf(include.target, table);
        if (to == nullptr || !allowed(*from, *to)) {
          offences.push_back(place + std::string(from->folder) + " must not include " + include.target);
        }
      } else if (!include.angled && include.target.find('/') == std::string::npos) {
        offences.push_back(place + "\"" + include.target + "\" is not rooted at the top of the tree");
      }
    }
  }
  return offences;
}

std::vector<std::string> crossings(const std::vector<SourceFile>& files, const std::vector<Separate>& separate) {
  // "core/detect/liao" of "core/detect/liao/spectral.h" in core/detect; empty for what lies in the room itself.
  const auto inner = [](std::string_view path, std::string_view room) -> std::string_view {
    if (!path.starts_with(std::string(room) + '/')) return {};
    const std::size_t end = path.find('/', room.size() + 1);
    return end == std::string_view::npos ? std::string_view() : path.substr(0, end);
  };
  std::vector<std::string> offences;
  for (const SourceFile& file : files) {
    if (!isSource(file.path)) continue;
    for (const Separate& s : separate) {
      const std::string_view from = inner(file.path, s.room);
      if (from.empty()) continue;
      for (const Include& include : includesOf(file)) {
        const std::string_view to = inner(include.target, s.room);
        const bool shared = std::find(s.shared.begin(), s.shared.end(), to) != s.shared.end();
        if (!to.empty() && to != from && !shared)
          offences.push_back(file.path + ":" + std::to_string(include.line) + ": " + std::string(from) +
                             " must know nothing of " + include.target);
      }
    }
  }
  return offences;
}

std::vector<std::string> wrongLinks(const std::vector<SourceFile>& files, const std::vector<Room>& table) {
  std::vector<std::string> offences;
  LinkGraph graph;
  for (const LinkLine& line : linkLines(files)) {
    const Room* from = roomOfTarget(line.target, table);
    if (from == nullptr) {
      offences.push_back(line.file + ": " + line.target + " is no room of tests/lint/room_table.h");
      continue;
    }
    auto& links = graph[from->folder];
    for (const std::string& link : line.links) {
      const Room* to = roomOfTarget(link, table);
      if (to == nullptr || !allowed(*from, *to)) {
        offences.push_back(line.file + ": " + line.target + " must not link " + link);
      } else {
        links.insert(to->folder);
      }
    }
  }
  for (const SourceFile& file : files) {
    const Room* from = isSource(file.path) ? roomOf(file.path, table) : nullptr;
    if (from == nullptr || !graph.contains(from->folder)) continue;
    std::set<std::string_view> reached{from->folder};
    collect(graph, from->folder, reached);
    for (const Include& include : includesOf(file)) {
      const Room* to = roomOf(include.target, table);
      if (to != nullptr && allowed(*from, *to) && !reached.contains(to->folder)) {
        offences.push_back(file.path + ":" + std::to_string(include.line) + ": includes " + include.target + ", but " +
                           std::string(from->folder) + " does not link " + std::string(to->folder));
      }
    }
  }
  return offences;
}

std::vector<std::string> tableFaults(const std::vector<Room>& table) {
  std::vector<std::string> faults;
  std::set<std::string_view> above;
  for (const Room& room : table) {
    for (std::string_view word : room.mayInclude) {
      if (word != "core/*" && !above.contains(word)) {
        faults.push_back(std::string(room.folder) + " may include " + std::string(word) + ", which is not above it");
      }
    }
    above.insert(room.folder);
  }
  return faults;
}

}  // namespace stillcut::lint
