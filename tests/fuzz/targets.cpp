#include "tests/fuzz/targets.h"

#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/cnc/analog/analog_map.h"
#include "core/cnc/grbl/grbl_status.h"
#include "core/cnc/line_splitter.h"
#include "core/cnc/linuxcnc/emc_status.h"
#include "core/cnc/linuxcnc/hal_messages.h"
#include "core/cnc/modbus/register_map.h"
#include "core/config/profile.h"
#include "core/formats/universal/uff58.h"
#include "core/milling/identify/import/measurement_import.h"
#include "core/milling/simulation/case_json.h"
#include "core/milling/simulation/scenario.h"
#include "core/milling/stability/lobe_case.h"
#include "core/session/open_recording.h"

namespace stillcut::fuzz {
namespace {

[[noreturn]] void broken(const std::string& margin) {
  std::fprintf(stderr, "fuzz: %s\n", margin.c_str());
  std::abort();
}

void checkError(const Error& error) {
  const std::string line = error.line();
  if (line.empty()) broken("an error says nothing");
  if (line.find('\n') != std::string::npos) broken("an error has several lines: " + line);
}

// The bytes as a file, in memory where there is such a place.
std::string asFile(std::string_view bytes, std::string_view suffix) {
  static const std::string kFolder = std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp";
  std::string path = kFolder + "/stillcut-fuzz-" + std::to_string(getpid()) + std::string(suffix);
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path;
}

void readEverything(const std::string& path) {
  record::ReadOptions options;
  options.rate = Hertz(1000.0);  // so that a missing rate does not hide what comes after it
  auto reader = record::openRecording(path, options);
  if (!reader) return checkError(reader.error());
  const record::RecordingFormat& format = (*reader)->format();
  if (format.channels.empty() || !(format.rate.value > 0.0)) broken("a recording without channels or rate");
  SampleBlock block;
  block.allocate(static_cast<int>(format.channels.size()), std::max(512, format.blockFrames));
  // Compressed silence may be long: what was right for so many blocks is taken to be right.
  constexpr int kMostBlocks = 2000;
  for (int n = 0; n < kMostBlocks; ++n) {
    const Result<bool> more = (*reader)->read(block);
    if (!more) return checkError(more.error());
    if (!*more) return;
    if (block.frames <= 0 || block.frames > block.capacityFrames) broken("a block of an impossible length");
    for (int c = 0; c < block.channels; ++c) {
      for (const float v : block.channel(c)) {
        if (!std::isfinite(v)) broken("a sample that is no finite number");
      }
    }
  }
}

template <const char* const& Suffix>
void readRecording(std::string_view bytes) {
  const std::string path = asFile(bytes, Suffix);
  readEverything(path);
  std::remove(path.c_str());
}

void readUffInMemory(std::string_view bytes) {
  const auto sets = uff::parseUff58(bytes, "fuzz.uff");
  if (!sets) return checkError(sets.error());
  for (const uff::Uff58Dataset& set : *sets) {
    if (set.x.size() != set.y.size()) broken("points without abscissa");
  }
}

void expectFinite(const identify::Frf& frf) {
  if (frf.frequency.size() != frf.value.size()) broken("a response without its frequency");
  if (!frf.coherence.empty() && frf.coherence.size() != frf.value.size()) broken("a coherence on other lines");
  for (const auto& v : frf.value) {
    if (std::isnan(v.real()) || std::isnan(v.imag())) broken("a response that is no number");
  }
}

// Files of tap tests, with everything told that they might not say.
void readTapTest(std::string_view bytes) {
  identify::ImportOptions options;
  options.rate = Hertz(1000.0);
  options.open = [](const std::string& path, const record::ReadOptions& o) { return record::openRecording(path, o); };
  const std::string path = asFile(bytes, ".tap");
  for (const bool told : {false, true}) {
    options.forceUnit = told ? "N" : "";
    options.responseUnit = told ? "g" : "";
    options.unit = told ? "m/N" : "";
    if (told) options.axes = {identify::Axis::X};
    const auto got = identify::importMeasurement(path, options);
    if (!got) checkError(got.error());
    const auto* frfs = got ? std::get_if<std::vector<identify::Frf>>(&got->data) : nullptr;
    if (frfs == nullptr) continue;
    for (const identify::Frf& frf : *frfs) expectFinite(frf);
  }
  std::remove(path.c_str());
}

template <class Loaded>
void expectOneLine(const Loaded& loaded) {
  if (!loaded) checkError(loaded.error());
}

void readToml(std::string_view bytes) {
  expectOneLine(config::parseProfile(bytes, "fuzz.toml", config::ParamCatalog{}));
  expectOneLine(cnc::parseRegisterMap(bytes, "fuzz.toml"));
  expectOneLine(cnc::parseAnalogMap(bytes, "fuzz.toml"));
  const std::string path = asFile(bytes, ".toml");
  expectOneLine(milling::loadScenario(path));
  expectOneLine(milling::loadLobeCase(path));
  std::remove(path.c_str());
}

void readJson(std::string_view bytes) {
  const std::string path = asFile(bytes, ".json");
  expectOneLine(milling::loadCaseJson(path));
  expectOneLine(milling::importLobeJson(path));
  std::remove(path.c_str());
}

// What a machine says on its wire: lines of LinuxCNC and of GRBL.
void hearMachine(std::string_view bytes) {
  cnc::LineSplitter splitter;
  cnc::EmcStatus emc;
  cnc::GrblReport report;
  cnc::GrblWords words;
  splitter.feed(bytes, [&](std::string_view line) {
    emc.take(line, {});
    cnc::readGrblLine(line, report, words);
    const double numbers[] = {emc.actualSpeed.value.value,
                              emc.commandedSpeed.value.value,
                              emc.speedWord.value.value,
                              emc.feedWord.value.value,
                              emc.currentFeed.value.value,
                              emc.adaptiveFeed.value,
                              report.feed.value_or(0.0),
                              report.speed.value_or(0.0),
                              words.feed,
                              words.speed};
    for (const double n : numbers) {
      if (!std::isfinite(n) || std::abs(n) > 1e7) broken("a machine that is faster than any");
    }
    const int percents[] = {emc.feedOverride.value, emc.spindleOverride.value, report.feedOverride.value_or(0),
                            report.speedOverride.value_or(0)};
    for (const int p : percents) {
      if (p < 0 || p > 1000) broken("an override that no machine has");
    }
  });
}

// What stillcut-hal and the link say to each other: what was understood is said and understood the same again.
void hearHal(std::string_view bytes) {
  cnc::LineSplitter splitter;
  std::array<char, cnc::kHalLine> text{};
  const auto bare = [](std::string_view line) { return line.substr(0, line.find_first_of("\r\n")); };
  splitter.feed(bytes, [&](std::string_view line) {
    if (const auto request = cnc::readHalRequest(line)) {
      const auto again = cnc::readHalRequest(bare(cnc::writeHalRequest(*request, text)));
      if (!again || again->hold != request->hold || again->speed != request->speed || again->feed != request->feed ||
          again->restoreSpeed != request->restoreSpeed || again->restoreFeed != request->restoreFeed ||
          std::abs(again->adaptiveFeed - request->adaptiveFeed) > 1e-3) {
        broken("a request that is said otherwise than it was understood");
      }
    }
    if (const auto report = cnc::readHalReport(line)) {
      const auto again = cnc::readHalReport(bare(cnc::writeHalReport(*report, text)));
      if (!again || again->standing != report->standing || again->speed != report->speed ||
          again->feed != report->feed || again->watchdogMs != report->watchdogMs) {
        broken("a report that is said otherwise than it was understood");
      }
    }
  });
}

// Words of a Modbus register in every form a map can give it: the number they mean is written back as the same words.
void readRegisters(std::string_view bytes) {
  constexpr std::array<double, 6> kScales{1.0, 0.1, 0.01, -0.5, 800.0, 1e-3};
  constexpr std::array<double, 3> kOffsets{0.0, -100.0, 4000.0};
  constexpr std::size_t kEach = 8;
  for (std::size_t at = 0; at + kEach <= bytes.size(); at += kEach) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(bytes[at + i])); };
    cnc::Register r;
    r.words = 1 + static_cast<int>(byte(0) & 1U);
    r.highWordFirst = (byte(0) & 2U) != 0;
    r.isSigned = (byte(0) & 4U) != 0;
    r.bit = static_cast<int>(byte(1) % 17U) - 1;
    r.scale = kScales[byte(2) % kScales.size()];
    r.offset = kOffsets[byte(3) % kOffsets.size()];
    cnc::RegisterWords words{};
    for (int w = 0; w < r.words; ++w) {
      const std::size_t from = 4 + 2 * static_cast<std::size_t>(w);
      words[static_cast<std::size_t>(w)] = static_cast<std::uint16_t>(byte(from) << 8U | byte(from + 1));
    }
    [[maybe_unused]] const bool flag = r.flag(words);
    const double value = r.decode(words);
    if (!std::isfinite(value)) broken("a register that is no number");
    const auto back = r.encode(value);
    if (!back) broken("a register's own value does not fit into it");
    for (std::size_t w = 0; w < static_cast<std::size_t>(r.words); ++w) {
      if ((*back)[w] != words[w]) broken("a register is written back otherwise than it was read");
    }
  }
}

const char* const kWav = ".wav";
const char* const kFlac = ".flac";
const char* const kCsv = ".csv";
const char* const kUff = ".uff";
const char* const kMat = ".mat";
const char* const kHdf5 = ".h5";

constexpr std::array<Target, 13> kTargets{{
    {"wav", ".wav", readRecording<kWav>},
    {"flac", ".flac", readRecording<kFlac>},
    {"text", ".csv", readRecording<kCsv>},
    {"uff", ".uff", readRecording<kUff>},
    {"uff-memory", ".uff", readUffInMemory},
    {"mat", ".mat", readRecording<kMat>},
    {"hdf5", ".h5", readRecording<kHdf5>},
    {"tap", ".tap", readTapTest},
    {"toml", ".toml", readToml},
    {"json", ".json", readJson},
    {"machine", ".txt", hearMachine},
    {"hal", ".txt", hearHal},
    {"registers", ".bin", readRegisters},
}};

}  // namespace

std::span<const Target> targets() {
  return kTargets;
}

const Target* findTarget(std::string_view name) {
  for (const Target& target : kTargets) {
    if (target.name == name) return &target;
  }
  return nullptr;
}

}  // namespace stillcut::fuzz
