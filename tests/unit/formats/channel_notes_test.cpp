// What a sound file carries about its channels in a comment, and what foreign comments may not do.
#include "core/formats/channel_notes.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace stillcut::record {
namespace {

RecordedChannel channelOf(const std::string& name, SensorQuantity quantity, const std::string& unit,
                          const std::string& axis) {
  RecordedChannel c;
  c.info.name = name;
  c.info.quantity = quantity;
  c.info.axis = axis;
  c.unit = unit;
  c.quantityKnown = true;
  return c;
}

ExportPlan planOf() {
  ExportPlan plan;
  plan.rate = Hertz(25600.25);
  plan.channels = {channelOf("spindle x", SensorQuantity::Acceleration, "m/s\u00b2", "x"),
                   channelOf("mic", SensorQuantity::Sound, "Pa", ""), channelOf("Fz", SensorQuantity::Force, "N", "z")};
  return plan;
}

// What a reader knows before it has seen the comment.
std::vector<RecordedChannel> bare(std::size_t count) {
  std::vector<RecordedChannel> channels(count);
  for (std::size_t c = 0; c < count; ++c) channels[c].info.name = "channel " + std::to_string(c);
  return channels;
}

TEST(ChannelNotes, GiveBackNamesQuantitiesAxesScalesAndTheExactRate) {
  const ExportPlan plan = planOf();
  const std::string comment = channelNotes(plan, {98.1, 2.0, 500.0});
  EXPECT_EQ(comment.find('\n'), std::string::npos);
  auto channels = bare(3);
  Hertz rate(25600.0);  // a sound file's header knows whole hertz
  applyChannelNotes(comment, channels, rate);
  EXPECT_DOUBLE_EQ(rate.value, 25600.25);
  const double scales[] = {98.1, 2.0, 500.0};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(channels[c].info.name, plan.channels[c].info.name);
    EXPECT_EQ(channels[c].info.quantity, plan.channels[c].info.quantity);
    EXPECT_EQ(channels[c].info.axis, plan.channels[c].info.axis);
    EXPECT_TRUE(channels[c].quantityKnown);
    EXPECT_DOUBLE_EQ(channels[c].info.scale, scales[c]);
  }
}

TEST(ChannelNotes, AnotherRateIsAnotherFile) {
  const std::string comment = channelNotes(planOf(), {1.0, 1.0, 1.0});
  auto channels = bare(3);
  Hertz rate(48000.0);  // somebody resampled it
  applyChannelNotes(comment, channels, rate);
  EXPECT_EQ(rate.value, 48000.0);
}

TEST(ChannelNotes, ACommentForOtherChannelsChangesNothing) {
  const std::string comment = channelNotes(planOf(), {1.0, 1.0, 1.0});
  auto channels = bare(2);
  Hertz rate(25600.0);
  applyChannelNotes(comment, channels, rate);
  EXPECT_EQ(channels[0].info.name, "channel 0");
  EXPECT_EQ(rate.value, 25600.0);
}

TEST(ChannelNotes, ForeignCommentsChangeNothing) {
  for (const char* comment :
       {"", "recorded with a phone", "{", "[]", "{}", "42", "null", "{\"stillcut_channels\": 3}",
        "{\"stillcut_channels\": [1, 2]}", "{\"stillcut_channels\": {}}", "{\"other\": [{}, {}]}"}) {
    auto channels = bare(2);
    Hertz rate(8000.0);
    applyChannelNotes(comment, channels, rate);
    EXPECT_EQ(channels[1].info.name, "channel 1") << comment;
    EXPECT_EQ(rate.value, 8000.0) << comment;
  }
}

TEST(ChannelNotes, ValuesOfTheWrongKindAreLeftOut) {
  auto channels = bare(1);
  Hertz rate(8000.0);
  applyChannelNotes(
      "{\"stillcut_channels\": [{\"name\": 7, \"full_scale\": \"loud\", \"quantity\": \"colour\", "
      "\"axis\": [1]}], \"rate_hz\": \"fast\"}",
      channels, rate);
  EXPECT_EQ(channels[0].info.name, "channel 0");
  EXPECT_EQ(channels[0].info.scale, RecordedChannel{}.info.scale);
  EXPECT_FALSE(channels[0].quantityKnown);
  EXPECT_EQ(rate.value, 8000.0);
}

TEST(ChannelNotes, DamagedCommentsDoNoHarm) {
  const std::string whole = channelNotes(planOf(), {98.1, 2.0, 500.0});
  std::mt19937 random(9);
  for (int trial = 0; trial < 5000; ++trial) {
    std::string comment = whole.substr(0, random() % (whole.size() + 1));
    for (auto flips = random() % 4; flips > 0 && !comment.empty(); --flips) {
      comment[random() % comment.size()] = static_cast<char>(random() % 256);
    }
    auto channels = bare(3);
    Hertz rate(25600.0);
    applyChannelNotes(comment, channels, rate);
    EXPECT_NEAR(rate.value, 25600.0, 0.5);
    for (const RecordedChannel& c : channels) EXPECT_TRUE(std::isfinite(c.info.scale) && c.info.scale != 0.0);
  }
}

}  // namespace
}  // namespace stillcut::record
