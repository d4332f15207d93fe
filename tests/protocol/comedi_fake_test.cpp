// Comedi's sources and outputs against a card in memory: the library's functions are defined here, so that the program
// is linked with these in their place. Short reads, an end of the stream, removal and return, and what a card cannot
// do.
#include <comedilib.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/io/comedi_driver.h"
#include "app/io/comedi_output.h"
#include "core/cnc/analog/analog_link.h"
#include "core/daq/registry.h"

struct comedi_t_struct {
  int unused = 0;
};

namespace stillcut {
namespace {

// One card of 16 bits with four inputs that stream, -10 to 10 V, and two outputs, 0 to 10 V.
struct Card {
  comedi_t handle;
  comedi_range inputs{-10.0, 10.0, 0}, outputs{0.0, 10.0, 0};
  std::array<int, 2> stream{-1, -1};
  int removed = -1;
  int absent = 0;  // so many times it cannot be opened
  bool streams = true;
  int flags = 0;
  bool calibrated = false;  // its file is there
  int buffer = 65536, most = 1 << 20, waiting = 0;
  unsigned slowest = 1000;  // ns; its clock is a multiple
  int commands = 0, opened = 0;
  std::map<unsigned, lsampl_t> written;
  std::vector<std::uint16_t> next;  // comes with the next command

  void begin() {
    end();
    ++commands;
    ASSERT_EQ(::pipe2(stream.data(), O_CLOEXEC), 0);
    if (!next.empty()) send(next);
  }
  void end() {
    for (int& side : stream) {
      if (side >= 0) ::close(side);
      side = -1;
    }
  }
  void remove() {  // its file answers no more
    removed = stream[0];
    end();
  }
  void stop() {  // the card ends its command: the buffer was full
    ::close(stream[1]);
    stream[1] = -1;
  }
  void send(const std::vector<std::uint16_t>& values) const {
    ASSERT_EQ(::write(stream[1], values.data(), 2 * values.size()), static_cast<ssize_t>(2 * values.size()));
  }
};
Card card;

}  // namespace
}  // namespace stillcut

using stillcut::card;

extern "C" {
comedi_t* comedi_open(const char*) {
  ++card.opened;
  if (card.absent > 0) {
    --card.absent;
    return nullptr;
  }
  return &card.handle;
}
int comedi_close(comedi_t*) {
  card.end();
  return 0;
}
int comedi_errno(void) {
  return ENODEV;
}
const char* comedi_strerror(int) {
  return "No such device";
}
int comedi_fileno(comedi_t*) {
  return card.stream[0] >= 0 ? card.stream[0] : card.removed;
}
int comedi_get_read_subdevice(comedi_t*) {
  return card.streams ? 0 : -1;
}
int comedi_get_n_channels(comedi_t*, unsigned) {
  return 4;
}
int comedi_get_n_ranges(comedi_t*, unsigned, unsigned) {
  return 1;
}
int comedi_get_subdevice_flags(comedi_t*, unsigned) {
  return card.flags;
}
const char* comedi_get_board_name(comedi_t*) {
  return "pci-6221";
}
int comedi_get_buffer_size(comedi_t*, unsigned) {
  return card.buffer;
}
int comedi_get_max_buffer_size(comedi_t*, unsigned) {
  return card.most;
}
int comedi_set_buffer_size(comedi_t*, unsigned, unsigned bytes) {
  card.buffer = static_cast<int>(bytes);
  return card.buffer;
}
int comedi_get_buffer_contents(comedi_t*, unsigned) {
  return card.waiting;
}
char* comedi_get_default_calibration_path(comedi_t*) {
  return ::strdup("/var/lib/comedi/calibrations/ni_pcimio_pci-6221_comedi0");
}
comedi_calibration_t* comedi_parse_calibration_file(const char*) {
  static comedi_calibration_t calibration{};
  return card.calibrated ? &calibration : nullptr;
}
void comedi_cleanup_calibration(comedi_calibration_t*) {}
// 1 % more than nominal, 20 mV off, and a little bent.
int comedi_get_softcal_converter(unsigned, unsigned, unsigned, comedi_conversion_direction, const comedi_calibration_t*,
                                 comedi_polynomial_t* polynomial) {
  *polynomial = {{0.02, 1.01 * 10.0 / 32768.0, 1e-12, 0.0}, 32768.0, 2};
  return 0;
}
int comedi_get_subdevice_type(comedi_t*, unsigned subdevice) {
  return subdevice == 1 ? COMEDI_SUBD_AO : COMEDI_SUBD_AI;
}
comedi_range* comedi_get_range(comedi_t*, unsigned subdevice, unsigned, unsigned) {
  return subdevice == 1 ? &card.outputs : &card.inputs;
}
lsampl_t comedi_get_maxdata(comedi_t*, unsigned, unsigned) {
  return 65535;
}
int comedi_get_cmd_generic_timed(comedi_t*, unsigned, comedi_cmd* command, unsigned, unsigned period) {
  *command = {};
  command->scan_begin_src = TRIG_TIMER;
  command->scan_begin_arg = std::max(1U, period / card.slowest) * card.slowest;
  return 0;
}
int comedi_command_test(comedi_t*, comedi_cmd*) {
  return 0;
}
int comedi_command(comedi_t*, comedi_cmd*) {
  card.begin();
  return 0;
}
int comedi_cancel(comedi_t*, unsigned) {
  return 0;
}
int comedi_data_write(comedi_t*, unsigned, unsigned channel, unsigned, unsigned, lsampl_t data) {
  card.written[channel] = data;
  return 1;
}
lsampl_t comedi_from_phys(double volts, comedi_range* span, lsampl_t most) {
  return static_cast<lsampl_t>(std::lround((volts - span->min) / (span->max - span->min) * most));
}
}

namespace stillcut {
namespace {

class ComediFake : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!app::makeComediDriver(0, 0)) GTEST_SKIP() << "this build has no Comedi";
    card.end();
    card = Card{};
  }
  void TearDown() override { card.end(); }
  Result<std::unique_ptr<daq::DaqSource>> make(const std::map<std::string, std::string>& settings,
                                               std::size_t channels) {
    daq::SourceRequest request;
    request.channels.resize(channels);
    request.clock = &clock_;
    request.comedi = app::makeComediDriver;
    request.settings = settings;
    return daq::makeSource("comedi", request);
  }
  std::string problemOf(const std::map<std::string, std::string>& settings, std::size_t channels) {
    const auto source = make(settings, channels);
    if (!source) return source.error().line();
    const auto opened = (*source)->open();
    return opened ? "" : opened.error().line();
  }
  void open() {
    auto made = make({{"rate_hz", "10000"}, {"block_ms", "1"}}, 2);
    ASSERT_TRUE(made) << made.error().line();
    source_ = std::move(made).value();
    const auto format = source_->open();
    ASSERT_TRUE(format) << format.error().line();
    frames_ = format->blockFrames;
    volts_ = format->channels[0].scale;
    doubt_ = text(format->doubt);
    block_.allocate(2, frames_);
  }
  // Frame n: n codes above the middle on the first input, as many below it on the second.
  std::vector<std::uint16_t> frames(int from, int count) const {
    std::vector<std::uint16_t> values;
    for (int n = from; n < from + count; ++n) {
      values.push_back(static_cast<std::uint16_t>(32768 + n));
      values.push_back(static_cast<std::uint16_t>(32768 - n));
    }
    return values;
  }

  SteadyClock clock_;
  std::unique_ptr<daq::DaqSource> source_;
  SampleBlock block_;
  int frames_ = 0;
  double volts_ = 0.0;
  std::string doubt_;
};

TEST_F(ComediFake, CodesAreVoltsAndShortReadsMakeWholeBlocks) {
  open();
  EXPECT_NEAR(volts_, 10.0, 1e-9);
  const std::vector<std::uint16_t> all = frames(0, 2 * frames_);
  const std::size_t split = 5;  // in the middle of a frame
  card.send({all.begin(), all.begin() + split});
  card.send({all.begin() + split, all.end()});
  for (int k = 0; k < 2; ++k) {
    ASSERT_TRUE(source_->read(block_));
    ASSERT_EQ(block_.frames, frames_);
    for (int f = 0; f < frames_; ++f) {
      const auto at = static_cast<std::size_t>(f);
      ASSERT_NEAR(block_.channel(0)[at] * volts_, 10.0 * (k * frames_ + f) / 32768.0, 1e-6);
      ASSERT_NEAR(block_.channel(1)[at] * volts_, -10.0 * (k * frames_ + f) / 32768.0, 1e-6);
    }
    EXPECT_FALSE(block_.has(kBlockGap));
  }
}

// 0 to 10 V: the middle of the codes is 5 V and not zero.
TEST_F(ComediFake, ARangeOfOneSignKeepsItsPlace) {
  card.inputs = {0.0, 10.0, 0};
  open();
  card.send(frames(0, frames_));
  ASSERT_TRUE(source_->read(block_));
  for (std::size_t f = 0; f < static_cast<std::size_t>(frames_); ++f) {
    ASSERT_NEAR(block_.channel(0)[f] * volts_, 5.0 + 10.0 * static_cast<double>(f) / 65536.0, 1e-6);
    ASSERT_NEAR(block_.channel(1)[f] * volts_, 5.0 - 10.0 * static_cast<double>(f) / 65536.0, 1e-6);
  }
}

TEST_F(ComediFake, ACardThatIsCalibratedInSoftwareIsReadByItsCalibration) {
  card.flags = SDF_SOFT_CALIBRATED;
  open();
  EXPECT_NE(doubt_.find("is not calibrated"), std::string::npos) << doubt_;
  card.calibrated = true;
  open();
  EXPECT_EQ(doubt_, "");
  card.send(frames(1000, frames_));
  ASSERT_TRUE(source_->read(block_));
  for (std::size_t f = 0; f < static_cast<std::size_t>(frames_); ++f) {
    const double code = 1000.0 + static_cast<double>(f);
    ASSERT_NEAR(block_.channel(0)[f] * volts_, 0.02 + 1.01 * 10.0 * code / 32768.0 + 1e-12 * code * code, 1e-6);
  }
}

TEST_F(ComediFake, AnInputAtItsLimitIsClipped) {
  open();
  std::vector<std::uint16_t> codes = frames(0, frames_);
  codes[6] = 65535;
  card.send(codes);
  ASSERT_TRUE(source_->read(block_));
  EXPECT_TRUE(block_.has(kBlockClipped));
}

// What still waits in the card's buffer is younger than what was read.
TEST_F(ComediFake, ItsBufferHoldsTwoSecondsAndAgesTheSamples) {
  open();
  EXPECT_EQ(card.buffer, 2 * 10000 * 2 * 2);
  card.waiting = 4 * 5000;  // half a second of frames
  const Instant before = clock_.now();
  card.send(frames(0, frames_));
  ASSERT_TRUE(source_->read(block_));
  const double age = secondsBetween(block_.end(), before).value;
  EXPECT_GT(age, 0.4);
  EXPECT_LT(age, 0.5);
}

TEST_F(ComediFake, CardsAreListedWithTheirRanges) {
  std::string folder = ::testing::TempDir() + "comedi-XXXXXX";
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  EXPECT_TRUE(app::comediDevices(folder).empty());
  std::ofstream(folder + "/comedi0") << "";
  const auto cards = app::comediDevices(folder);
  std::filesystem::remove_all(folder);
  ASSERT_EQ(cards.size(), 1U);
  EXPECT_EQ(cards[0].name, folder + "/comedi0");
  EXPECT_EQ(cards[0].label, "pci-6221");
  EXPECT_EQ(cards[0].range, "0 to 3 ('inputs'), up to 1000000 Hz for one, 16 bits; 'range' 0: -10 to 10 V");
}

TEST_F(ComediFake, StreamThatEndedIsBegunAgainWithAGap) {
  open();
  card.send(frames(0, frames_ + 1));
  ASSERT_TRUE(source_->read(block_));
  card.stop();
  ASSERT_TRUE(source_->read(block_));  // what was whole comes out first
  EXPECT_EQ(block_.frames, 1);
  EXPECT_EQ(card.commands, 2);
  card.send(frames(0, frames_));
  ASSERT_TRUE(source_->read(block_));
  EXPECT_TRUE(block_.has(kBlockGap));
  EXPECT_EQ(card.opened, 1);
}

TEST_F(ComediFake, CardThatGoesIsTakenUpAgainWhenItIsBack) {
  open();
  card.send(frames(0, frames_));
  ASSERT_TRUE(source_->read(block_));
  card.remove();
  card.absent = 1;
  card.next = frames(0, frames_);
  ASSERT_TRUE(source_->read(block_));  // tried at once, and again half a second later
  EXPECT_EQ(card.opened, 3);
  EXPECT_TRUE(block_.has(kBlockGap));
  EXPECT_GT(block_.lostFrames, 0U);
}

TEST_F(ComediFake, WhatTheCardCannotDoIsOneLine) {
  EXPECT_NE(problemOf({{"rate_hz", "10000"}}, 5).find("has no input 4 ('inputs') (it has 0 to 3)"), std::string::npos);
  EXPECT_NE(problemOf({{"rate_hz", "10000"}, {"range", "3"}}, 1).find("has no range 3 ('range')"), std::string::npos);
  card.slowest = 30000;  // a third of the period
  const std::string rate = problemOf({{"rate_hz", "10000"}}, 1);
  EXPECT_NE(rate.find("'rate_hz' = 10000 is not among its rates"), std::string::npos) << rate;
  EXPECT_NE(rate.find("the nearest is 11111"), std::string::npos) << rate;
  card.streams = false;
  EXPECT_NE(problemOf({{"rate_hz", "10000"}}, 1).find("has no inputs that stream"), std::string::npos);
  card.absent = 1;
  EXPECT_NE(problemOf({{"rate_hz", "10000"}}, 1).find("cannot be opened (No such device)"), std::string::npos);
}

TEST_F(ComediFake, OutputsTakeVoltsInsideTheirRangeOnly) {
  const auto output = app::makeComediOutput();
  ASSERT_TRUE(output);
  cnc::AnalogDevice device;
  device.subdevice = 0;
  const Status inputs = output->open(device);
  ASSERT_FALSE(inputs.ok());
  EXPECT_NE(inputs.error().line().find("subdevice 0 is no analog output"), std::string::npos);
  device.subdevice = 1;
  const auto right = app::makeComediOutput();
  ASSERT_TRUE(right->open(device).ok());
  EXPECT_TRUE(right->write(0, 5.0));
  EXPECT_NEAR(card.written[0], 32768.0, 1.0);
  EXPECT_FALSE(right->write(1, 10.5));
  EXPECT_FALSE(right->write(1, -0.1));
  EXPECT_FALSE(card.written.contains(1));
}

}  // namespace
}  // namespace stillcut
