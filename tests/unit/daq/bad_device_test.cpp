// A configuration that cannot be: one line that names the device and the key, and what would be possible, of every
// live source, before a device is touched. What a device itself cannot do is tested beside its library (pcm_test,
// stream_test, comedi_fake, source_peer, alsa_peer), a sensitivity of zero beside the profile (profile_test).
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "core/daq/registry.h"

namespace stillcut::daq {
namespace {

using Settings = std::map<std::string, std::string>;

struct Bad {
  std::string id;
  std::size_t channels;
  Settings settings;
  std::vector<std::string> said;  // device, key, what would be possible
};

std::ostream& operator<<(std::ostream& out, const Bad& bad) {
  out << bad.id;
  for (const auto& [key, value] : bad.settings) out << " " << key << "=" << value;
  return out;
}

class BadDevice : public ::testing::TestWithParam<Bad> {};

TEST_P(BadDevice, IsOneLineWithDeviceKeyAndWhatWouldBePossible) {
  SourceRequest request;
  const SteadyClock clock;
  request.clock = &clock;
  request.wires = [](const WireAddress&) { return Result<std::unique_ptr<ByteChannel>>(nullptr); };  // never opened
  request.channels.resize(GetParam().channels);
  request.settings = GetParam().settings;
  const auto made = makeSource(GetParam().id, request);
  ASSERT_FALSE(made);
  const std::string line = made.error().line();
  EXPECT_EQ(line.find('\n'), std::string::npos);
  for (const std::string& part : GetParam().said) EXPECT_NE(line.find(part), std::string::npos) << part << ": " << line;
}

const Settings kTwo{{"1_id", "tcp"},    {"1_rate_hz", "8000"}, {"1_format", "text"},
                    {"2_id", "serial"}, {"2_rate_hz", "8000"}, {"2_format", "text"}};
Settings with(Settings settings, const Settings& more) {
  for (const auto& [key, value] : more) settings[key] = value;
  return settings;
}

INSTANTIATE_TEST_SUITE_P(
    Rates, BadDevice,
    ::testing::Values(
        Bad{"alsa", 1, {{"rate_hz", "500"}}, {"source 'alsa'", "'rate_hz'", "8000 to 192000"}},
        Bad{"alsa", 1, {{"rate_hz", "48000.5"}}, {"source 'alsa'", "'rate_hz'", "whole number"}},
        Bad{"iio", 1, {{"device", "adxl"}, {"rate_hz", "fast"}}, {"source 'iio'", "'rate_hz'", "100 to"}},
        Bad{"iio", 1, {{"device", "adxl"}}, {"source 'iio'", "'rate_hz' is missing", "one of the device's"}},
        Bad{"comedi", 1, {{"rate_hz", "0"}}, {"source 'comedi'", "'rate_hz'", "100 to"}},
        Bad{"comedi", 1, {}, {"source 'comedi'", "'rate_hz' is missing", "100 to"}},
        Bad{"serial", 1, {{"rate_hz", "-1"}, {"sync", "AA"}}, {"source 'serial'", "'rate_hz'", "100 to"}},
        Bad{"tcp", 1, {{"sync", "AA"}}, {"source 'tcp'", "'rate_hz' is missing", "100 to"}},
        Bad{"joined",
            2,
            with(kTwo, {{"2_rate_hz", "7"}}),
            {"source 'joined'", "device 2", "source 'serial'", "'rate_hz'", "100 to"}},
        Bad{"replay", 1, {{"file", "cut.wav"}, {"pace", "0"}}, {"source 'replay'", "'pace'", "0.1 to 10"}}));

INSTANTIATE_TEST_SUITE_P(
    Channels, BadDevice,
    ::testing::Values(
        Bad{"alsa", 2, {{"inputs", "0,99"}}, {"source 'alsa'", "'inputs'", "each of the 2 [[channels]]"}},
        Bad{"iio",
            2,
            {{"device", "a"}, {"rate_hz", "8000"}, {"inputs", "0"}},
            {"source 'iio'", "'inputs'", "each of the 2 [[channels]]"}},
        Bad{"comedi", 1, {{"rate_hz", "8000"}, {"inputs", "x"}}, {"source 'comedi'", "'inputs'", "from 0"}},
        Bad{"alsa", 0, {}, {"source 'alsa'", "0 [[channels]]", "1 to 32"}},
        Bad{"serial", 0, {{"rate_hz", "8000"}, {"format", "text"}}, {"source 'serial'", "0 [[channels]]", "1 to 32"}},
        Bad{"tcp", 33, {{"rate_hz", "8000"}, {"format", "text"}}, {"source 'tcp'", "33 [[channels]]", "1 to 32"}},
        Bad{"joined", 2, with(kTwo, {{"2_channels", "2"}}), {"source 'joined'", "'2_channels' is 2", "2 in all"}},
        Bad{"joined", 3, kTwo, {"source 'joined'", "3 [[channels]]", "N_channels"}}));

INSTANTIATE_TEST_SUITE_P(
    Frames, BadDevice,
    ::testing::Values(Bad{"serial", 1, {{"rate_hz", "8000"}}, {"source 'serial'", "'sync' is missing", "1 to 8 bytes"}},
                      Bad{"tcp", 1, {{"rate_hz", "8000"}, {"sync", "XY"}}, {"source 'tcp'", "'sync'", "hexadecimal"}},
                      Bad{"tcp",
                          1,
                          {{"rate_hz", "8000"}, {"sync", "AA"}, {"checksum", "md5"}},
                          {"source 'tcp'", "'checksum'", "crc16"}},
                      Bad{"joined",
                          2,
                          with(kTwo, {{"1_format", "binary"}}),
                          {"source 'joined'", "device 1", "source 'tcp'", "'sync' is missing"}}));

INSTANTIATE_TEST_SUITE_P(
    Keys, BadDevice,
    ::testing::Values(
        Bad{"alsa", 1, {{"rate", "48000"}}, {"source 'alsa'", "'rate' is not known", "rate_hz"}},
        Bad{"iio", 1, {{"rate_hz", "8000"}}, {"source 'iio'", "'device' is missing", "devices lists it"}},
        Bad{"comedi",
            1,
            {{"rate_hz", "8000"}, {"reference", "diff"}},
            {"source 'comedi'", "'reference'", "ground, common, differential"}},
        Bad{"serial",
            1,
            {{"rate_hz", "8000"}, {"sync", "AA"}, {"baud", "110"}},
            {"source 'serial'", "'baud'", "1200 to"}},
        Bad{"tcp",
            1,
            {{"rate_hz", "8000"}, {"sync", "AA"}, {"port", "70000"}},
            {"source 'tcp'", "'port'", "1 to 65535"}},
        Bad{"joined", 2, {{"1_rate_hz", "8000"}}, {"source 'joined'", "'1_id' is missing", "1_id, 2_id"}},
        Bad{"joined", 2, with(kTwo, {{"9x", "1"}}), {"source 'joined'", "'9x' is not known", "1_channels"}},
        Bad{"replay", 1, {}, {"source 'replay'", "'file' is missing", "recording"}},
        Bad{"scope", 1, {}, {"'scope' is not known", "alsa"}}));

}  // namespace
}  // namespace stillcut::daq
