#include "tests/support/null_sink.h"

#include <alsa/asoundlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <utility>
#include <vector>

namespace stillcut::testing {
namespace fs = std::filesystem;

NullSink::~NullSink() {
  unplug();
  if (!folder_.empty()) fs::remove_all(folder_);
}

std::string NullSink::start(int rate, int channels, const std::string& channelMap) {
  if (std::system("command -v pulseaudio >/dev/null") != 0) return "pulseaudio is not installed";
  if (std::system("ls /usr/lib/*/alsa-lib/libasound_module_pcm_pulse.so >/dev/null 2>&1") != 0) {
    return "libasound2-plugins is not installed";
  }
  char folder[] = "/tmp/stillcut-pulse-XXXXXX";
  if (::mkdtemp(folder) == nullptr) return "no folder can be made";
  folder_ = folder;
  rate_ = rate;
  channels_ = channels;
  map_ = channelMap.empty() ? "" : " channel_map=" + channelMap;
  const std::string server = "server \"unix:" + (folder_ / "socket").string() + "\"";
  std::ofstream(folder_ / "alsa.conf") << "</usr/share/alsa/alsa.conf>\n"
                                       << "pcm.heard { type pulse " << server << " device \"sink.monitor\" }\n"
                                       << "pcm.played { type pulse " << server << " device \"sink\" }\n";
  ::setenv("ALSA_CONFIG_PATH", (folder_ / "alsa.conf").c_str(), 1);
  ::setenv("XDG_RUNTIME_DIR", folder, 1);
  ::setenv("HOME", folder, 1);
  return plug();
}

std::string NullSink::plug() {
  const std::string socket = (folder_ / "socket").string();
  server_ = ::fork();
  if (server_ == 0) {
    const std::string listen = "--load=module-native-protocol-unix auth-anonymous=1 socket=" + socket;
    const std::string sink = "--load=module-null-sink sink_name=sink format=s32le rate=" + std::to_string(rate_) +
                             " channels=" + std::to_string(channels_) + map_;
    ::execlp("pulseaudio", "pulseaudio", "-n", "--daemonize=no", "--exit-idle-time=-1", "--log-target=null",
             listen.c_str(), sink.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  for (int i = 0; i < 200 && !fs::exists(socket); ++i) ::usleep(25000);
  return fs::exists(socket) ? "" : "pulseaudio does not start here";
}

void NullSink::unplug() {
  if (server_ <= 0) return;
  ::kill(server_, SIGTERM);
  ::waitpid(server_, nullptr, 0);
  server_ = -1;
  fs::remove(folder_ / "socket");
}

NullSinkPlayer::NullSinkPlayer(int rate, int channels, Fill fill)
    : fill_(std::move(fill)), thread_([this, rate, channels] { run(rate, channels); }) {}

NullSinkPlayer::~NullSinkPlayer() {
  stopped_ = true;
  thread_.join();
}

void NullSinkPlayer::run(int rate, int channels) {
  snd_pcm_t* pcm = nullptr;
  if (::snd_pcm_open(&pcm, "played", SND_PCM_STREAM_PLAYBACK, 0) < 0) {
    refused_ = true;
    return;
  }
  constexpr unsigned kLatencyUs = 1'000'000;  // a busy computer must not silence it
  refused_ = ::snd_pcm_set_params(pcm, SND_PCM_FORMAT_S32_LE, SND_PCM_ACCESS_RW_INTERLEAVED,
                                  static_cast<unsigned>(channels), static_cast<unsigned>(rate), 0, kLatencyUs) < 0;
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
