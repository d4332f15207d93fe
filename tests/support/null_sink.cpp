#include "tests/support/null_sink.h"

#include <alsa/asoundlib.h>
#include <poll.h>
#include <sched.h>
#include <sys/inotify.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <utility>
#include <vector>

namespace stillcut::testing {
namespace fs = std::filesystem;
namespace {

// Wakes with every change in its folder, until the file is there.
bool appears(const fs::path& file, int atMostMs) {
  const int changes = ::inotify_init1(IN_CLOEXEC);
  ::inotify_add_watch(changes, file.parent_path().c_str(), IN_CREATE | IN_MOVED_TO);
  std::array<char, 4096> told;
  pollfd change{changes, POLLIN, 0};
  while (!fs::exists(file) && ::poll(&change, 1, atMostMs) > 0 && ::read(changes, told.data(), told.size()) > 0) {
  }
  ::close(changes);
  return fs::exists(file);
}

}  // namespace

NullSink::~NullSink() {
  unplug();
  if (!folder_.empty()) fs::remove_all(folder_);
}

std::string NullSink::start(int rate, int channels, const std::string& channelMap, const std::string& resampling) {
  if (std::system("command -v pulseaudio >/dev/null") != 0) return "pulseaudio is not installed";
  if (std::system("ls /usr/lib/*/alsa-lib/libasound_module_pcm_pulse.so >/dev/null 2>&1") != 0) {
    return "libasound2-plugins is not installed";
  }
  char folder[] = "/tmp/stillcut-pulse-XXXXXX";
  if (::mkdtemp(folder) == nullptr) return "no folder can be made";
  folder_ = folder;
  rate_ = rate;
  channels_ = channels;
  resampling_ = resampling.empty() ? "auto" : resampling;
  map_ = channelMap.empty() ? "" : " channel_map=" + channelMap;
  const std::string server = "server \"unix:" + (folder_ / "socket").string() + "\"";
  std::ofstream(folder_ / "alsa.conf") << "</usr/share/alsa/alsa.conf>\n"
                                       << "pcm.heard { type pulse " << server << " device \"sink.monitor\" }\n"
                                       << "pcm.played { type pulse " << server << " device \"sink\" }\n"
                                       << "pcm.looped { type asym playback.pcm played capture.pcm heard }\n"
                                       << "pcm.fixed { type plug slave { pcm heard rate " << rate << " } }\n";
  ::setenv("ALSA_CONFIG_PATH", (folder_ / "alsa.conf").c_str(), 1);
  ::setenv("XDG_RUNTIME_DIR", folder, 1);
  ::setenv("HOME", folder, 1);
  return plug();
}

std::string NullSink::plug() {
  const std::string socket = (folder_ / "socket").string();
  server_ = ::fork();
  if (server_ == 0) {
    const OnTime always;
    const std::string listen = "--load=module-native-protocol-unix auth-anonymous=1 socket=" + socket;
    const std::string sink = "--load=module-null-sink sink_name=sink format=s32le rate=" + std::to_string(rate_) +
                             " channels=" + std::to_string(channels_) + map_;
    const std::string method = "--resample-method=" + resampling_;
    ::execlp("pulseaudio", "pulseaudio", "-n", "--daemonize=no", "--exit-idle-time=-1", "--log-target=null",
             method.c_str(), listen.c_str(), sink.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  return appears(socket, 5000) ? "" : "pulseaudio does not start here";
}

void NullSink::unplug() {
  if (server_ <= 0) return;
  ::kill(server_, SIGTERM);
  ::waitpid(server_, nullptr, 0);
  server_ = -1;
  fs::remove(folder_ / "socket");
}

OnTime::OnTime() {
  const sched_param lowest{.sched_priority = 1};
  ::sched_setscheduler(0, SCHED_RR, &lowest);
}

OnTime::~OnTime() {
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_OTHER, &none);
}

NullSinkPlayer::NullSinkPlayer(int rate, int channels, Fill fill, double ahead)
    : fill_(std::move(fill)), thread_([this, rate, channels, ahead] { run(rate, channels, ahead); }) {}

NullSinkPlayer::~NullSinkPlayer() {
  stopped_ = true;
  thread_.join();
}

void NullSinkPlayer::run(int rate, int channels, double ahead) {
  const OnTime always;
  snd_pcm_t* pcm = nullptr;
  if (::snd_pcm_open(&pcm, "played", SND_PCM_STREAM_PLAYBACK, 0) < 0) {
    refused_ = true;
    return;
  }
  refused_ =
      ::snd_pcm_set_params(pcm, SND_PCM_FORMAT_S32_LE, SND_PCM_ACCESS_RW_INTERLEAVED, static_cast<unsigned>(channels),
                           static_cast<unsigned>(rate), 0, static_cast<unsigned>(ahead * 1e6)) < 0;
  const auto frames = static_cast<std::size_t>(rate / 100);
  std::vector<std::int32_t> out(static_cast<std::size_t>(channels) * frames);
  while (!stopped_ && !refused_) {
    fill_(out);
    if (::snd_pcm_writei(pcm, out.data(), frames) >= 0) continue;
    ++underruns_;
    if (::snd_pcm_prepare(pcm) < 0) break;
  }
  ::snd_pcm_close(pcm);
}

}  // namespace stillcut::testing
