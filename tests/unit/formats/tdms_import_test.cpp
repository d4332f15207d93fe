// LabVIEW's TDMS files, made here byte by byte from the published layout.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/support/read_all.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

constexpr std::uint32_t kMeta = 2, kNew = 4, kRaw = 8, kInterleaved = 32, kBig = 64, kDaqMx = 128;

// Numbers in one order of bytes.
struct Writer {
  bool big = false;
  std::string out{};

  template <class T>
  Writer& put(T value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big) std::reverse(bytes.begin(), bytes.end());
    out += bytes;
    return *this;
  }
  Writer& text(const std::string& words) {
    put(static_cast<std::uint32_t>(words.size()));
    out += words;
    return *this;
  }
};

struct Property {
  std::string name, text;
  double number = 0.0;
  std::int64_t seconds = 0;  // since 1904, of a time stamp
};

struct Object {
  std::string path;
  std::uint32_t type = 10;  // double
  std::uint64_t values = 0;
  std::vector<Property> properties{};
  std::uint32_t index = 20;  // 0: as before, 0xFFFFFFFF: none
};

std::string header(const std::vector<Object>& objects, bool big = false) {
  Writer w{big};
  w.put(static_cast<std::uint32_t>(objects.size()));
  for (const Object& o : objects) {
    w.text(o.path).put(o.index);
    if (o.index == 20) w.put(o.type).put(std::uint32_t{1}).put(o.values);
    w.put(static_cast<std::uint32_t>(o.properties.size()));
    for (const Property& p : o.properties) {
      w.text(p.name);
      if (p.seconds != 0) {
        w.put(std::uint32_t{0x44}).put(std::uint64_t{1} << 63U).put(p.seconds);
      } else if (p.text.empty()) {
        w.put(std::uint32_t{10}).put(p.number);
      } else {
        w.put(std::uint32_t{0x20}).text(p.text);
      }
    }
  }
  return w.out;
}

std::string segment(std::uint32_t contents, const std::string& head, const std::string& data, bool unfinished = false) {
  Writer mask;
  mask.put(contents);
  Writer rest{(contents & kBig) != 0};
  rest.put(std::uint32_t{4713})
      .put(unfinished ? ~std::uint64_t{0} : static_cast<std::uint64_t>(head.size() + data.size()))
      .put(static_cast<std::uint64_t>(head.size()));
  return "TDSm" + mask.out + rest.out + head + data;
}

template <class T>
std::string numbers(int from, int count, bool big = false) {
  Writer w{big};
  for (int i = from; i < from + count; ++i) w.put(static_cast<T>(i));
  return w.out;
}

std::vector<Property> wave(double increment) {
  return {{"wf_increment", "", increment}, {"unit_string", "g"}, {"wf_start_time", "", 0.0, 3'850'000'000}};
}

class Tdms : public testing::Test {
 protected:
  WholeRecording read(const std::string& bytes, const std::string& inner = "") {
    return readAll(folder_.file("cut.tdms", bytes) + inner);
  }
  TempFolder folder_;
};

TEST_F(Tdms, SegmentsOfOneChannelAreOneRecording) {
  const Object x{"/'Cut'/'Acc X'", 10, 100, wave(1e-3)};
  const std::string bytes =
      segment(kMeta | kNew | kRaw, header({{"/", 10, 0, {}, 0xFFFFFFFF}, x}),
              numbers<double>(0, 300)) +  // three chunks
      segment(kRaw, "", numbers<double>(300, 100)) +
      segment(kMeta | kRaw, header({{"/'Cut'/'Acc X'", 10, 0, {}, 0}}), numbers<double>(400, 100));
  const WholeRecording all = read(bytes);
  ASSERT_EQ(all.error, "");
  EXPECT_EQ(all.format.kind, "LabVIEW TDMS");
  EXPECT_NEAR(all.format.rate.value, 1000.0, 1e-9);
  ASSERT_EQ(all.values.size(), 1U);
  ASSERT_EQ(all.values[0].size(), 500U);
  EXPECT_EQ(all.format.channels[0].info.name, "Acc X");
  for (std::size_t i : {0U, 99U, 100U, 299U, 499U})
    EXPECT_NEAR(all.values[0][i], 9.80665 * static_cast<double>(i), 1e-2) << i;
  // 3 850 000 000.5 s after 1904.
  EXPECT_EQ(all.format.started_ns, (3'850'000'000 - 2'082'844'800) * 1'000'000'000 + 500'000'000);
  EXPECT_TRUE(all.format.notes.empty());
}

TEST_F(Tdms, ALastSegmentThatIsCutOffEndsAllChannelsTogether) {
  const std::string head = header(
      {{"/", 10, 0, {{"SampleRate", "", 8000.0}}, 0xFFFFFFFF}, {"/'G'/'x'", 9, 50, {}}, {"/'G'/'y'", 9, 50, {}}});
  const WholeRecording all = read(segment(kMeta | kNew | kRaw, head, numbers<float>(0, 50) + numbers<float>(0, 50)) +
                                  segment(kRaw, "", numbers<float>(50, 50) + numbers<float>(50, 20), true));
  ASSERT_EQ(all.error, "");
  ASSERT_EQ(all.values.size(), 2U);
  EXPECT_EQ(all.values[0].size(), 70U);
  EXPECT_EQ(all.values[1].size(), 70U);
  EXPECT_EQ(all.format.rate.value, 8000.0);
}

TEST_F(Tdms, ChannelsSideBySideOrOneAfterTheOtherInEitherOrderOfBytes) {
  const std::vector<Object> both{{"/'G'/'x'", 2, 50, wave(1e-4)}, {"/'G'/'y'", 9, 50, wave(1e-4)}};
  for (const bool big : {false, true}) {
    const std::uint32_t order = big ? kBig : 0;
    const WholeRecording apart = read(segment(kMeta | kNew | kRaw | order, header(both, big),
                                              numbers<std::int16_t>(-20, 50, big) + numbers<float>(1000, 50, big)));
    ASSERT_EQ(apart.error, "") << big;
    Writer mixed{big};
    for (int i = 0; i < 50; ++i) mixed.put(static_cast<std::int16_t>(i - 20)).put(static_cast<float>(1000 + i));
    const WholeRecording together =
        read(segment(kMeta | kNew | kRaw | kInterleaved | order, header(both, big), mixed.out));
    ASSERT_EQ(together.error, "") << big;
    EXPECT_EQ(apart.values, together.values);
    EXPECT_NEAR(apart.values.at(0).at(3), 9.80665 * -17.0, 1e-4);
    EXPECT_NEAR(apart.values.at(1).at(49), 9.80665 * 1049.0, 1e-2);
  }
}

TEST_F(Tdms, AChannelIsScaledByItsStraightLine) {
  Object x{"/'G'/'x'", 2, 100, wave(1e-3)};
  for (const Property& p : std::vector<Property>{{"NI_Scaling_Status", "unscaled"},
                                                 {"NI_Number_Of_Scales", "", 1.0},
                                                 {"NI_Scale[0]_Scale_Type", "Linear"},
                                                 {"NI_Scale[0]_Linear_Slope", "", 0.5},
                                                 {"NI_Scale[0]_Linear_Y_Intercept", "", 3.0}})
    x.properties.push_back(p);
  const std::string data = numbers<std::int16_t>(0, 100);
  EXPECT_NEAR(read(segment(kMeta | kNew | kRaw, header({x}), data)).values.at(0).at(10), 9.80665 * 8.0, 1e-4);
  x.properties[x.properties.size() - 3].text = "Polynomial";
  EXPECT_THAT(read(segment(kMeta | kNew | kRaw, header({x}), data)).error, HasSubstr("no straight line"));
}

// Fractions of 2^-64 s, then seconds since 1904, in either order of bytes.
std::string stamps(int count, double step, bool big) {
  Writer w{big};
  for (int i = 0; i < count; ++i) {
    const double seconds = i * step;
    const auto whole = static_cast<std::int64_t>(seconds);
    const auto fraction = static_cast<std::uint64_t>(std::ldexp(seconds - static_cast<double>(whole), 64));
    if (big) {
      w.put(3'850'000'000 + whole).put(fraction);
    } else {
      w.put(fraction).put(3'850'000'000 + whole);
    }
  }
  return w.out;
}

TEST_F(Tdms, AChannelOfTimeStampsIsTheTimeAndNoVibration) {
  for (const bool big : {false, true}) {
    const std::string head = header({{"/'G'/'when'", 0x44, 5000}, {"/'G'/'x'", 10, 5000}}, big);
    const WholeRecording all = read(
        segment(kMeta | kNew | kRaw | (big ? kBig : 0), head, stamps(5000, 5e-4, big) + numbers<double>(0, 5000, big)));
    ASSERT_EQ(all.error, "");
    ASSERT_EQ(all.format.channels.size(), 1U);
    EXPECT_EQ(all.format.channels[0].info.name, "x");
    EXPECT_EQ(all.format.rate.value, 2000.0);
    EXPECT_EQ(all.format.started_ns, (3'850'000'000 - 2'082'844'800) * 1'000'000'000);
    EXPECT_TRUE(all.format.notes.empty());
    EXPECT_EQ(all.values[0][4999], 4999.0);
  }
}

TEST_F(Tdms, TheFirstSampleMayComeAfterTheStart) {
  Object x{"/'G'/'x'", 10, 100, wave(1e-3)};
  x.properties.push_back({"wf_start_offset", "", 2.25});
  const WholeRecording all = read(segment(kMeta | kNew | kRaw, header({x}), numbers<double>(0, 100)));
  EXPECT_EQ(all.format.started_ns, (3'850'000'000 - 2'082'844'800) * 1'000'000'000 + 2'750'000'000);
}

TEST_F(Tdms, APlaceInsideIsOneGroup) {
  const std::string bytes =
      segment(kMeta | kNew | kRaw, header({{"/'a'/'x'", 10, 100, wave(1e-3)}, {"/'b'/'it''s'", 10, 100, wave(1e-2)}}),
              numbers<double>(0, 200));
  const WholeRecording b = read(bytes, ":/b");
  ASSERT_EQ(b.error, "");
  EXPECT_EQ(b.format.channels.at(0).info.name, "it's");
  EXPECT_NEAR(b.format.rate.value, 100.0, 1e-9);
  EXPECT_THAT(read(bytes, ":/c").error, HasSubstr("there is no such channel"));
}

TEST_F(Tdms, AKilledRecorderLeavesWhatItWrote) {
  const Object x{"/'G'/'x'", 10, 100, wave(1e-3)};
  const std::string bytes = segment(kMeta | kNew | kRaw, header({x}), numbers<double>(0, 100)) +
                            segment(kRaw, "", numbers<double>(100, 50), true);
  const WholeRecording all = read(bytes);
  ASSERT_EQ(all.error, "");
  EXPECT_EQ(all.values.at(0).size(), 150U);
  ASSERT_EQ(all.format.notes.size(), 1U);
  EXPECT_THAT(text(all.format.notes[0]), HasSubstr("was not finished"));
}

TEST_F(Tdms, WhatCannotBeReadIsOneLine) {
  const std::string head = header({{"/'G'/'x'", 10, 100, wave(1e-3)}});
  EXPECT_THAT(read(segment(kMeta | kNew | kRaw | kDaqMx, head, numbers<double>(0, 100))).error,
              HasSubstr("unscaled values of a DAQmx device"));
  EXPECT_THAT(read(segment(kMeta | kNew, header({{"/'G'/'x'", 10, 0, {}, 0xFFFFFFFF}}), "")).error,
              HasSubstr("holds no values"));
  EXPECT_THAT(read("TDSm" + std::string(200, '\x7f')).error, HasSubstr("TDMS"));
  // Cut anywhere and with any byte changed: a line or a recording, never a crash.
  const std::string whole = segment(kMeta | kNew | kRaw, head, numbers<double>(0, 100));
  for (std::size_t keep = 4; keep < whole.size(); keep += 13) (void)read(whole.substr(0, keep));
  for (std::size_t at = 4; at < head.size() + 28; ++at) {
    std::string odd = whole;
    odd[at] = static_cast<char>(odd[at] ^ 0x55);
    (void)read(odd);
  }
}

}  // namespace
}  // namespace stillcut::record
