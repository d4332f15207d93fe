// The lines that another program has written since the last look into a file that grows. Thread: one.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <utility>

namespace stillcut::ends {

class Tail {
 public:
  explicit Tail(std::string path) : path_(std::move(path)) {}

  // Each whole line, as a stream of its words, to `take`.
  template <class Take>
  void look(Take&& take) {
    if (!file_.is_open()) file_.open(path_);
    if (!file_.is_open()) return;
    file_.clear();
    for (char c = 0; file_.get(c);) {
      if (c != '\n') {
        line_ += c;
        continue;
      }
      std::istringstream words(std::exchange(line_, {}));
      take(words);
    }
  }

 private:
  std::string path_, line_;
  std::ifstream file_;
};

}  // namespace stillcut::ends
