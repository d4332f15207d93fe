#include "core/daq/registry.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <string>
#include <utility>

#include "core/config/component_settings.h"
#include "core/daq/joined_parts.h"
#include "core/daq/pcm_source.h"
#include "core/daq/replay_source.h"
#include "core/daq/simulated/hammer_source.h"
#include "core/daq/stream_decoder.h"
#include "core/daq/stream_source.h"
#include "core/model/sensor_status.h"
#include "core/session/open_recording.h"

namespace stillcut::daq {

namespace {

Result<std::unique_ptr<DaqSource>> makeSimulated(const SourceRequest& r) {
  if (r.scenario == nullptr) return Error{message("source 'simulated'"), message("a scenario is needed")};
  return std::unique_ptr<DaqSource>(std::make_unique<SimulatedSource>(*r.scenario, r.seed, r.port, r.pace));
}

Result<std::unique_ptr<DaqSource>> makeHammer(const SourceRequest& r) {
  config::ComponentSettings settings(r.settings, "source 'simulated-hammer'", r.asked);
  HammerSourceOptions options;
  options.alongY = settings.choice("axis", 0, {"x", "y"}) == 1;
  options.interval = Seconds(settings.number("interval_s", options.interval.value, 0.6, 60.0));
  options.pace = settings.number("pace", 1.0, 0.0, 1000.0);  // times real time; 0: as fast as it is read
  options.faults = settings.flag("faults", true);
  options.seed = static_cast<std::uint64_t>(settings.whole("seed", 1, 1, 1'000'000));
  if (Status known = settings.finish(); !known) return known.error();
  return std::unique_ptr<DaqSource>(std::make_unique<HammerSource>(options));
}

// The recording's samples alone, with its own rate and channels: the machine of then is not this profile's.
Result<std::unique_ptr<DaqSource>> makeReplay(const SourceRequest& r) {
  const std::string where = "source 'replay'";
  config::ComponentSettings settings(r.settings, where, r.asked);
  const std::string file = settings.text("file", "");
  if (file.empty())
    settings.fault("file", message("is missing"), message("a session, or a recording of any kind that is imported"));
  ReplayOptions options;
  options.pace = settings.number("pace", 1.0, 0.1, 1000.0);  // times real time
  options.clock = r.clock;
  record::ReadOptions reading;
  if (settings.has("rate_hz")) reading.rate = Hertz(settings.number("rate_hz", 1000.0, 100.0, 1e6));
  if (Status known = settings.finish(); !known) return known.error();
  auto reader = record::openRecording(file, reading);
  if (!reader) return reader.error();
  return std::unique_ptr<DaqSource>(std::make_unique<ReplaySource>(std::move(reader).value(), options));
}

Status realChannels(const SourceRequest& r, const std::string& where) {
  if (!r.channels.empty() && r.channels.size() <= kMaxChannels) return Done{};
  return Error{where, message("%1 [[channels]] in the profile", std::to_string(r.channels.size())),
               message("as many as the device sends, 1 to %1", std::to_string(kMaxChannels))};
}

// Bytes over a wire: what frames are in them, and what cannot be seen in them, the rate and the channels.
Result<std::unique_ptr<DaqSource>> makeStream(const SourceRequest& r, const std::string& where,
                                              WireAddress (*addressOf)(config::ComponentSettings&)) {
  config::ComponentSettings settings(r.settings, where, r.asked);
  const WireAddress address = addressOf(settings);
  SourceFormat format;
  format.channels = r.channels;
  if (!settings.has("rate_hz"))
    settings.fault("rate_hz", message("is missing"), message("samples a second, from 100 to 1000000"));
  format.rate = Hertz(settings.number("rate_hz", 1000.0, 100.0, 1e6));
  const double block = settings.number("block_ms", 10.0, 1.0, 200.0) * 1e-3;
  format.blockFrames = std::max(1, static_cast<int>(block * format.rate.value));
  auto decoder = makeDecoder(settings, static_cast<int>(r.channels.size()));
  if (Status known = settings.finish(); !known) return known.error();
  if (Status some = realChannels(r, where); !some) return some.error();
  if (!r.wires || r.clock == nullptr) return Error{where, message("there is no wire to a real device here")};
  auto wire = r.wires(address);
  if (!wire) return wire.error();
  return std::unique_ptr<DaqSource>(
      std::make_unique<StreamSource>(where, std::move(format), std::move(wire).value(), std::move(decoder), *r.clock));
}

Result<std::unique_ptr<DaqSource>> makeTcp(const SourceRequest& r) {
  return makeStream(r, "source 'tcp'", [](config::ComponentSettings& settings) {
    WireAddress address;
    address.host = settings.text("host", "localhost");
    address.port = settings.whole("port", 7820, 1, 65535);
    return address;
  });
}

Result<std::unique_ptr<DaqSource>> makeSerial(const SourceRequest& r) {
  return makeStream(r, "source 'serial'", [](config::ComponentSettings& settings) {
    WireAddress address;
    address.device = settings.text("device", "/dev/ttyACM0");
    address.baud = settings.whole("baud", 115200, 1200, 12'000'000);
    return address;
  });
}

// "0,2": one input for each channel of the profile; left out: the first ones.
std::vector<int> inputsFrom(config::ComponentSettings& settings, std::size_t channels) {
  std::vector<int> inputs(channels);
  std::iota(inputs.begin(), inputs.end(), 0);
  if (!settings.has("inputs")) return inputs;
  const std::string text = settings.text("inputs", "");
  inputs.clear();
  const char* at = text.data();
  const char* end = at + text.size();
  while (at != end) {
    int input = 0;
    const auto [next, error] = std::from_chars(at, end, input);
    if (error != std::errc() || input < 0 || input >= kMaxChannels) break;
    inputs.push_back(input);
    at = next != end && *next == ',' ? next + 1 : next;
    if (at == next && at != end) break;
  }
  if (at != end || inputs.size() != channels) {
    settings.fault(
        "inputs", message("is '%1'", text),
        message("one input from 0 for each of the %1 [[channels]], for example 0,1", std::to_string(channels)));
  }
  return inputs;
}

// What the devices behind a PcmDriver have in common, once `settings` has been read but for `inputs` and `block_ms`.
Result<std::unique_ptr<DaqSource>> makePcm(const SourceRequest& r, const std::string& where, PcmRequest request,
                                           config::ComponentSettings& settings, std::unique_ptr<PcmDriver> driver,
                                           const std::string& package) {
  if (Status some = realChannels(r, where); !some) return some.error();
  request.periodFrames =
      std::max(1, static_cast<int>(settings.number("block_ms", 5.0, 1.0, 200.0) * 1e-3 * request.rate.value));
  std::vector<int> inputs = inputsFrom(settings, r.channels.size());
  if (Status known = settings.finish(); !known) return known.error();
  if (!driver)
    return Error{where, message("such devices are not part of this build"),
                 message("install %1 and build again", package)};
  if (r.clock == nullptr) return Error{where, message("there is no clock here")};
  return std::unique_ptr<DaqSource>(std::make_unique<PcmSource>(where, std::move(request), r.channels,
                                                                std::move(inputs), std::move(driver), *r.clock));
}

Result<std::unique_ptr<DaqSource>> makeAlsa(const SourceRequest& r) {
  const std::string where = "source 'alsa'";
  config::ComponentSettings settings(r.settings, where, r.asked);
  PcmRequest request;
  request.device = settings.text("device", request.device);
  request.rate = Hertz(settings.whole("rate_hz", 48000, 8000, 192000));
  constexpr int kBits[] = {0, 16, 24, 32};
  request.bits = kBits[settings.choice("bits", 0, {"auto", "16", "24", "32"})];
  return makePcm(r, where, std::move(request), settings, r.pcm ? r.pcm() : nullptr, "libasound2-dev");
}

Result<std::unique_ptr<DaqSource>> makeIio(const SourceRequest& r) {
  const std::string where = "source 'iio'";
  config::ComponentSettings settings(r.settings, where, r.asked);
  PcmRequest request;
  request.device = settings.text("device", "");
  if (request.device.empty())
    settings.fault("device", message("is missing"), message("its name, as stillcut-cli devices lists it"));
  if (!settings.has("rate_hz"))
    settings.fault("rate_hz", message("is missing"), message("samples a second, one of the device's"));
  request.rate = Hertz(settings.number("rate_hz", 1000.0, 100.0, 1e6));
  const std::string uri = settings.text("uri", "local:");
  const std::string trigger = settings.has("trigger") ? settings.text("trigger", "") : std::string();
  return makePcm(r, where, std::move(request), settings, r.iio ? r.iio(uri, trigger) : nullptr, "libiio-dev");
}

Result<std::unique_ptr<DaqSource>> makeComedi(const SourceRequest& r) {
  const std::string where = "source 'comedi'";
  config::ComponentSettings settings(r.settings, where, r.asked);
  PcmRequest request;
  request.device = settings.text("device", "/dev/comedi0");
  if (!settings.has("rate_hz"))
    settings.fault("rate_hz", message("is missing"), message("samples a second, from 100 to 1000000"));
  request.rate = Hertz(settings.number("rate_hz", 1000.0, 100.0, 1e6));
  const int range = settings.whole("range", 0, 0, 31);
  const auto reference = static_cast<int>(settings.choice("reference", 2, {"ground", "common", "differential"}));
  return makePcm(r, where, std::move(request), settings, r.comedi ? r.comedi(range, reference) : nullptr,
                 "libcomedi-dev");
}

constexpr std::array<SourceEntry, 9> kSources{{
    {"simulated", "A simulated cut from a scenario file, in real time or as fast as possible", makeSimulated},
    {"replay", "A recording, in real time or at another pace: file, pace, rate_hz where the file does not say",
     makeReplay},
    {"alsa",
     "Audio-class: measurement microphones, USB accelerometers, IEPE conditioners: device, rate_hz, bits, inputs",
     makeAlsa},
    {"comedi", "Data acquisition cards, NI and many others: device, rate_hz, range, reference, inputs", makeComedi},
    {"iio", "Accelerometers of Linux' industrial I/O, here or through iiod: device, rate_hz, uri, inputs, trigger",
     makeIio},
    {"serial", "A microcontroller on a serial port, binary frames or text lines: device, baud, rate_hz, format",
     makeSerial},
    {"simulated-hammer", "A simulated tap test: hammer and two accelerometers at the tip of a tool: axis, interval_s",
     makeHammer},
    {"joined", "Several of these as one, aligned on the clock of the first: 1_id, 1_channels, 1_delay_ms, 2_id ...",
     makeJoined},
    {"tcp", "A bridge that sends the same over a socket: host, port, rate_hz, format", makeTcp},
}};

}  // namespace

std::span<const SourceEntry> sourceTable() {
  return kSources;
}

Result<std::unique_ptr<DaqSource>> makeSource(std::string_view id, const SourceRequest& request) {
  std::string known;
  for (const SourceEntry& e : kSources) {
    if (e.id == id) return e.make(request);
    known += (known.empty() ? "" : ", ") + std::string(e.id);
  }
  return Error{message("source"), message("'%1' is not known", id), message("known: %1", known)};
}

}  // namespace stillcut::daq
