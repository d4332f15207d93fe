#include "core/session/isolated_server.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <span>

#include "core/base/sanitized.h"
#include "core/formats/hdf5/hdf5_import.h"
#include "core/formats/hdf5/isolated_messages.h"
#include "core/session/file/session_layout.h"
#include "core/session/file/session_open.h"
#include "core/storage/journal.h"

namespace stillcut::record {
namespace {

using apart::MessageType;

constexpr unsigned kPatience = 60;  // s

void limit() {
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
#if !defined(STILLCUT_SANITIZED_ADDRESSES) && !defined(STILLCUT_SANITIZED_THREADS)
  constexpr rlim_t kMost = rlim_t{4} << 30U;
  rlimit memory{};
  if (getrlimit(RLIMIT_AS, &memory) == 0 && memory.rlim_cur > kMost) {
    memory.rlim_cur = kMost;
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

bool say(int peer, MessageType word, std::span<const std::byte> bytes = {}) {
  const apart::MessageHeader head{word, static_cast<std::uint32_t>(bytes.size())};
  return apart::send(peer, std::as_bytes(std::span(&head, 1))) && apart::send(peer, bytes);
}

bool say(int peer, MessageType word, const std::string& json) {
  return say(peer, word, std::as_bytes(std::span(json)));
}

bool sayBlock(int peer, const SampleBlock& block) {
  const apart::BlockHead head{block.sequence, block.lostFrames, toNs(block.firstSample), block.frames, block.flags};
  const auto samples = static_cast<std::size_t>(block.channels) * static_cast<std::size_t>(block.frames);
  const apart::MessageHeader before{MessageType::Block,
                                    static_cast<std::uint32_t>(sizeof head + samples * sizeof(float))};
  bool sent =
      apart::send(peer, std::as_bytes(std::span(&before, 1))) && apart::send(peer, std::as_bytes(std::span(&head, 1)));
  for (int c = 0; sent && c < block.channels; ++c) sent = apart::send(peer, std::as_bytes(block.channel(c)));
  return sent;
}

}  // namespace

int serveIsolated(int peer, const std::string& path, const std::string& inner, const std::string& options) {
  limit();
  alarm(kPatience);
  if (inner.empty() && (isSession(path) || !opensPlainly(path))) return say(peer, MessageType::Session) ? 0 : 1;
  const auto reader = openHdf5(path, inner, apart::optionsFrom(options));
  if (!reader) return say(peer, MessageType::Refused, apart::toJson(reader.error())) ? 0 : 1;
  const auto channels = static_cast<int>((*reader)->format().channels.size());
  if (!say(peer, MessageType::Format, apart::toJson((*reader)->format()))) return 1;
  SampleBlock block;
  while (true) {
    alarm(0);  // whoever asks may take his time
    std::int32_t capacity = 0;
    if (!apart::receive(peer, std::as_writable_bytes(std::span(&capacity, 1)))) return 0;
    alarm(kPatience);
    capacity = std::clamp(capacity, 1, kMostBlockFrames);
    if (block.capacityFrames != capacity) block.allocate(channels, capacity);
    const Result<bool> more = (*reader)->read(block);
    if (!more) return say(peer, MessageType::Refused, apart::toJson(more.error())) ? 0 : 1;
    if (!*more) return say(peer, MessageType::End) ? 0 : 1;
    if (!sayBlock(peer, block)) return 1;
  }
}

}  // namespace stillcut::record
