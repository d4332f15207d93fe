#include "core/session/isolated_server.h"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <span>

#include "core/base/sanitized.h"
#include "core/formats/hdf5/hdf5_import.h"
#include "core/formats/hdf5/isolated_messages.h"
#include "core/formats/sound/sound_kinds.h"
#include "core/formats/sound/wav_reader.h"
#include "core/session/file/session_layout.h"
#include "core/session/file/session_open.h"
#include "core/session/file/session_reader.h"
#include "core/session/isolated_answers.h"
#include "core/storage/journal.h"

namespace stillcut::record {
namespace {

using apart::MessageType;

constexpr unsigned kPatience = 60;  // s

void limit() {
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
#if !defined(STILLCUT_SANITIZED_ADDRESSES) && !defined(STILLCUT_SANITIZED_THREADS)
  // A made file may ask for any amount: the run beside it keeps three quarters of the computer's memory.
  constexpr rlim_t kMost = rlim_t{4} << 30U;
  const auto physical = static_cast<rlim_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
  // ... but the libraries take some hundred MB of addresses before the first byte is read.
  constexpr rlim_t kLeast = rlim_t{1} << 30U;
  const rlim_t most = std::clamp(physical / 4, kLeast, kMost);
  rlimit memory{};
  if (getrlimit(RLIMIT_AS, &memory) == 0 && memory.rlim_cur > most) {
    memory.rlim_cur = most;
    setrlimit(RLIMIT_AS, &memory);
  }
#endif
}

bool isSession(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::exists(journalPath(path), ignored)) return true;
  const Result<OpenedSession> opened = openSessionFile(path, Repair::No);
  return opened && readText(opened->file.get(), "format").has_value();
}

// A file that was not closed, as a crash leaves a session: not for the plain importer.
bool opensPlainly(const std::string& path) {
  quietHdf5();
  return static_cast<bool>(Hdf5Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)));
}

bool beginsAsMpeg(const std::string& path) {
  std::array<char, 4> head{};
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), head.size());
  return isMpegAudio({head.data(), static_cast<std::size_t>(file.gcount())});
}

bool say(int peer, MessageType word, std::span<const std::byte> bytes = {}) {
  const apart::MessageHeader head{word, static_cast<std::uint32_t>(bytes.size())};
  return apart::send(peer, std::as_bytes(std::span(&head, 1))) && apart::send(peer, bytes);
}

bool say(int peer, MessageType word, const std::string& json) {
  return say(peer, word, std::as_bytes(std::span(json)));
}

bool sayBlock(int peer, const SampleBlock& block, const StepRecord* step) {
  const apart::BlockHead head{.sequence = block.sequence,
                              .lostFrames = block.lostFrames,
                              .firstSample_ns = toNs(block.firstSample),
                              .rate = block.rate.value,
                              .frames = block.frames,
                              .flags = block.flags,
                              .source = block.source,
                              .hasStep = step != nullptr ? 1U : 0U,
                              .stepFlags = step != nullptr ? step->input.block.flags : 0U};
  const auto samples = static_cast<std::size_t>(block.channels) * static_cast<std::size_t>(block.frames);
  const std::size_t bytes = sizeof head + samples * sizeof(float) + (step != nullptr ? apart::kStepBytes : 0);
  const apart::MessageHeader before{MessageType::Block, static_cast<std::uint32_t>(bytes)};
  bool sent =
      apart::send(peer, std::as_bytes(std::span(&before, 1))) && apart::send(peer, std::as_bytes(std::span(&head, 1)));
  for (int c = 0; sent && c < block.channels; ++c) sent = apart::send(peer, std::as_bytes(block.channel(c)));
  if (!sent || step == nullptr) return sent;
  std::array<std::byte, apart::kStepBytes> packed{};
  apart::packStep(*step, packed);
  return apart::send(peer, packed);
}

// The last block that goes out has to fit into what the other end has allocated, and the channels are those it knows.
int serveReader(int peer, RecordingReader& reader) {
  const auto channels = static_cast<int>(reader.format().channels.size());
  if (!say(peer, MessageType::Format, apart::toCbor(reader.format()))) return 1;
  SampleBlock block;
  while (true) {
    alarm(0);  // whoever asks may take his time
    apart::Request request;
    if (!apart::receive(peer, std::as_writable_bytes(std::span(&request, 1)))) return 0;
    alarm(kPatience);
    if (request.kind == apart::Request::Kind::Seek) {
      const Result<bool> found = reader.seek(instantFromNs(request.time_ns));
      const bool said = found ? say(peer, *found ? MessageType::Answer : MessageType::End)
                              : say(peer, MessageType::Refused, apart::toJson(found.error()));
      if (!said) return 1;
      continue;
    }
    const int capacity = std::clamp(request.capacity, 1, kMostBlockFrames);
    if (block.capacityFrames != capacity) block.allocate(channels, capacity);
    const Result<bool> more = reader.read(block);
    if (!more) return say(peer, MessageType::Refused, apart::toJson(more.error())) ? 0 : 1;
    if (!*more) {
      if (!say(peer, MessageType::End)) return 1;  // who jumps back goes on
    } else if (!sayBlock(peer, block, reader.recordedStep())) {
      return 1;
    }
  }
}

// Ends the process when it has worked for so long, whatever it waits for beside.
void limitWork(Seconds most) {
#if !defined(STILLCUT_SANITIZED_ADDRESSES) && !defined(STILLCUT_SANITIZED_THREADS)
  if (!(most.value > 0.0)) return;
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(most.value);
  timer.it_value.tv_usec = static_cast<suseconds_t>((most.value - std::floor(most.value)) * 1e6);
  setitimer(ITIMER_PROF, &timer, nullptr);
#else
  (void)most;
#endif
}

int serveAnswer(int peer, const std::string& path, const apart::Ask& ask) {
  limitWork(ask.patience);
  const Result<std::string> answer = answerTo(path, ask.what, ask.arguments);
  const bool said =
      answer ? say(peer, MessageType::Answer, *answer) : say(peer, MessageType::Refused, apart::toJson(answer.error()));
  return said ? 0 : 1;
}

}  // namespace

void limitIsolated() {
  limit();
  alarm(kPatience);
}

int serveOpened(int peer, const Result<std::unique_ptr<RecordingReader>>& reader) {
  if (!reader) return say(peer, MessageType::Refused, apart::toJson(reader.error())) ? 0 : 1;
  return serveReader(peer, **reader);
}

int serveIsolated(int peer, const std::string& path, const std::string& inner, const std::string& options) {
  limitIsolated();
  if (inner.empty() && beginsAsMpeg(path)) return serveOpened(peer, openWav(path, apart::optionsFrom(options)));
  if (const auto ask = apart::askFrom(options)) return serveAnswer(peer, path, *ask);
  const bool session = inner.empty() && (isSession(path) || (!opensPlainly(path) && !isLeftOpen(path)));
  return serveOpened(peer, session ? here::openSession(path, apart::optionsFrom(options))
                                   : openHdf5(path, inner, apart::optionsFrom(options)));
}

}  // namespace stillcut::record
