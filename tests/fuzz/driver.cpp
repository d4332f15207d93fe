// fuzz_driver TARGET CORPUS_FOLDER RUNS [SEED] : the corpus, then RUNS changes of it, the same ones every time. For
// compilers without libFuzzer, and for the smoke run in ctest. Memory is limited to a gigabyte of addresses, so that a
// reader that believes a lying size fails here; a failure names the run, which alone repeats it: RUNS:ONLY.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "core/base/sanitized.h"
#include "tests/fuzz/targets.h"

namespace stillcut::fuzz {
namespace {

char current[128];  // for the handler: what is running

void onCrash(int signal) {
  [[maybe_unused]] const auto written = write(2, current, std::strlen(current));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void limitMemory() {
#if !defined(STILLCUT_SANITIZED_ADDRESSES) && !defined(STILLCUT_SANITIZED_THREADS)
  constexpr rlim_t kBytes = rlim_t{1} << 30U;
  const rlimit limit{kBytes, kBytes};
  setrlimit(RLIMIT_AS, &limit);
#endif
}

std::vector<std::string> readCorpus(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> all;
  for (const auto& path : paths) {
    std::ifstream in(path, std::ios::binary);
    all.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return all;
}

class Mutator {
 public:
  Mutator(const std::vector<std::string>& corpus, std::uint64_t seed) : corpus_(corpus), random_(seed) {}

  std::string make() {
    std::string bytes = corpus_[below(corpus_.size())];
    const std::size_t changes = 1 + below(5);
    for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) change(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

  // Headers are where files lie: half of the changes are made near the beginning.
  std::size_t place(const std::string& bytes) {
    constexpr std::size_t kHead = 600;
    return below(below(2) == 0 ? std::min(kHead, bytes.size()) : bytes.size());
  }

  void change(std::string& bytes) {
    const std::size_t at = place(bytes);
    switch (below(7)) {
      case 0:
        bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << below(8)));
        return;
      case 1:
        bytes[at] = static_cast<char>(below(256));
        return;
      case 2:
        putNumber(bytes, at);
        return;
      case 3:
        bytes.resize(at);
        return;
      case 4:
        bytes.insert(at, bytes.substr(place(bytes), below(64)));
        return;
      case 5:
        bytes.erase(at, 1 + below(32));
        return;
      default: {
        const std::string& other = corpus_[below(corpus_.size())];
        if (!other.empty()) bytes.replace(at, 1 + below(64), other.substr(place(other), below(64)));
      }
    }
  }

  // The sizes that files lie with, in both byte orders, and as text.
  void putNumber(std::string& bytes, std::size_t at) {
    constexpr std::array<std::uint64_t, 10> kSizes{0,           1,           0x7f,        0xff,        0x7fff,
                                                   0xffff'ffff, 0x7fff'ffff, 0x8000'0000, 1ULL << 40U, ~0ULL};
    const std::uint64_t value = kSizes[below(kSizes.size())];
    if (below(3) == 0) {
      constexpr std::array<const char*, 5> kWords{"nan", "-1", "1e999", "99999999999", "inf"};
      const std::string word = kWords[below(kWords.size())];
      bytes.replace(at, word.size(), word);
      return;
    }
    const std::size_t width = std::size_t{1} << below(4);
    const bool big = below(2) == 0;
    for (std::size_t i = 0; i < width && at + i < bytes.size(); ++i) {
      bytes[at + i] = static_cast<char>(value >> 8U * (big ? width - 1 - i : i) & 0xffU);
    }
  }

  const std::vector<std::string>& corpus_;
  std::mt19937_64 random_;
};

int run(const Target& target, const std::filesystem::path& folder, const std::string& runs, std::uint64_t seed) {
  const std::vector<std::string> corpus = readCorpus(folder);
  if (corpus.empty()) {
    std::fprintf(stderr, "fuzz: %s holds no files\n", folder.c_str());
    return 2;
  }
  for (std::size_t i = 0; i < corpus.size(); ++i) {
    std::snprintf(current, sizeof current, "fuzz: %s, file %zu of the corpus\n", std::string(target.name).c_str(), i);
    target.run(corpus[i]);
  }
  const std::size_t colon = runs.find(':');
  const unsigned long count = std::strtoul(runs.c_str(), nullptr, 10);
  const unsigned long only = colon == std::string::npos ? count : std::strtoul(runs.c_str() + colon + 1, nullptr, 10);
  for (unsigned long n = 0; n < count; ++n) {
    if (colon != std::string::npos && n != only) continue;
    Mutator mutator(corpus, seed * 1'000'003 + n);
    const std::string bytes = mutator.make();
    std::snprintf(current, sizeof current, "fuzz: %s, run %lu of seed %llu\n", std::string(target.name).c_str(), n,
                  static_cast<unsigned long long>(seed));
    if (colon != std::string::npos) std::ofstream("fuzz-input", std::ios::binary) << bytes;
    target.run(bytes);
  }
  std::printf("%s: %zu files, %lu changes\n", std::string(target.name).c_str(), corpus.size(), count);
  return 0;
}

}  // namespace
}  // namespace stillcut::fuzz

int main(int argc, char** argv) {
  using namespace stillcut::fuzz;
  const Target* target = argc > 3 ? findTarget(argv[1]) : nullptr;
  if (target == nullptr) {
    std::fprintf(stderr, "usage: fuzz_driver TARGET CORPUS_FOLDER RUNS [SEED]\n");
    for (const Target& known : targets()) std::fprintf(stderr, "  %s\n", std::string(known.name).c_str());
    return 2;
  }
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGTERM}) std::signal(signal, onCrash);
  limitMemory();
  return run(*target, argv[2], argv[3], argc > 4 ? std::strtoull(argv[4], nullptr, 10) : 1);
}
