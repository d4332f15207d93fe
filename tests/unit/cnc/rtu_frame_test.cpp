// Modbus RTU in bytes: questions as the standard writes them, answers that fit and that only look like it, a stream
// with noise, pieces and other units' frames in it.
#include "core/cnc/modbus/rtu_frame.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace stillcut::cnc {
namespace {

using namespace std::string_literals;

// Question to unit 1, function 3, ten registers from 0: the standard's own example of the checksum.
TEST(RtuQuestion, AreTheBytesOfTheStandard) {
  EXPECT_EQ(RtuQuestion::read(1, RegisterTable::Holding, 0, 10).bytes(), "\x01\x03\x00\x00\x00\x0A\xC5\xCD"s);
  EXPECT_EQ(RtuQuestion::write(17, RegisterTable::Holding, 1, 1, {3, 0}).bytes(), "\x11\x06\x00\x01\x00\x03\x9A\x9B"s);
  EXPECT_EQ(RtuQuestion::write(17, RegisterTable::Coil, 0xAC, 1, {1, 0}).bytes(), "\x11\x05\x00\xAC\xFF\x00\x4E\x8B"s);
  EXPECT_EQ(RtuQuestion::write(17, RegisterTable::Holding, 1, 2, {0x0A, 0x0102}).bytes(),
            "\x11\x10\x00\x01\x00\x02\x04\x00\x0A\x01\x02\xC6\xF0"s);
}

constexpr const char* kWord = "\x11\x03\x02\x1F\x40\x70\x47";  // 8000, of unit 17
std::string word() {
  return std::string(kWord, 7);
}

TEST(RtuQuestion, TakesTheAnswerThatFitsAndNoOther) {
  const auto one = RtuQuestion::read(17, RegisterTable::Holding, 0, 1);
  ASSERT_TRUE(one.isAnsweredBy(word()));
  EXPECT_TRUE(one.replyIn(word()).ok);
  EXPECT_EQ(one.replyIn(word()).words[0], 8000);
  EXPECT_FALSE(RtuQuestion::read(17, RegisterTable::Holding, 0, 2).isAnsweredBy(word()));  // of two words
  EXPECT_FALSE(RtuQuestion::read(17, RegisterTable::Input, 0, 1).isAnsweredBy(word()));    // of another table
  EXPECT_FALSE(RtuQuestion::read(18, RegisterTable::Holding, 0, 1).isAnsweredBy(word()));  // of another unit
  const std::string exception = "\x11\x83\x02\xC1\x34"s;
  ASSERT_TRUE(one.isAnsweredBy(exception));
  EXPECT_FALSE(one.replyIn(exception).ok);
  EXPECT_FALSE(RtuQuestion::read(17, RegisterTable::Input, 0, 1).isAnsweredBy(exception));
}

// Some drives answer with what the register holds then.
TEST(RtuQuestion, AWriteIsAnsweredByItsPlaceWhateverTheValue) {
  const auto q = RtuQuestion::write(17, RegisterTable::Holding, 1, 1, {3, 0});
  EXPECT_TRUE(q.isAnsweredBy(q.bytes()));
  EXPECT_TRUE(q.replyIn(q.bytes()).ok);
  const auto other = RtuQuestion::write(17, RegisterTable::Holding, 1, 1, {4, 0});
  EXPECT_TRUE(q.isAnsweredBy(other.bytes()));
  const auto elsewhere = RtuQuestion::write(17, RegisterTable::Holding, 2, 1, {3, 0});
  EXPECT_FALSE(q.isAnsweredBy(elsewhere.bytes()));
}

TEST(RtuReceiver, FindsFramesInPiecesBehindNoiseAndBesideOtherUnits) {
  RtuReceiver r(17);
  const std::string others = "\x12\x03\x02\x00\x01\xFC\x47"s;
  for (const std::string& before : {""s, "\x11"s, "\x11\x03\xFF"s, "noise"s, others}) {
    const std::string all = before + word();
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
      r.put(all.substr(i, 1));
      EXPECT_FALSE(r.next()) << i;
    }
    r.put(all.substr(all.size() - 1));
    const auto frame = r.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(*frame, word());
    EXPECT_FALSE(r.next());
  }
}

TEST(RtuReceiver, TakesNoFrameWithAWrongBit) {
  for (std::size_t bit = 0; bit < 8 * word().size(); ++bit) {
    std::string frame = word();
    frame[bit / 8] = static_cast<char>(frame[bit / 8] ^ (1 << (bit % 8)));
    RtuReceiver r(17);
    r.put(frame);
    EXPECT_FALSE(r.next()) << bit;
  }
}

// Whatever came and however much: the next frame is found.
TEST(RtuReceiver, IsNotChokedByAFlood) {
  std::mt19937 random(5);
  RtuReceiver r(17);
  for (int round = 0; round < 200; ++round) {
    std::string flood(1 + random() % 3000, '\0');
    for (char& c : flood) c = static_cast<char>(random() % 256);
    r.put(flood);
    r.put(word());
    bool found = false;
    while (const auto frame = r.next()) found = found || *frame == word();
    EXPECT_TRUE(found) << round;
  }
}

}  // namespace
}  // namespace stillcut::cnc
