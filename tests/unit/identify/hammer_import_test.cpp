// Hammer records: which channel is what, in which unit, along which axis; and what is asked for where nobody says.
#include <gtest/gtest.h>

#include "core/formats/sound/wav_reader.h"
#include "core/formats/universal/uff58.h"
#include "tests/support/uff_dataset.h"
#include "tests/unit/identify/import_files.h"

namespace stillcut::identify {
namespace {

using namespace test;

class HammerImport : public testing::Test {
 protected:
  Result<Measurement> import(const std::string& content, const ImportOptions& o = options()) {
    return importMeasurement(folder_.file("tap.csv", content), o);
  }
  // A push of 100 N and an answer that begins at 50 sin(0.9) SI units.
  static void expectRight(const Result<Measurement>& got) {
    ASSERT_TRUE(got.ok()) << got.error().line();
    const HammerRecord& record = hammerOf(got);
    EXPECT_NEAR(record.rate, 1000.0, 1e-3);
    EXPECT_NEAR(record.force.at(11), 100.0, 1e-3);
    EXPECT_NEAR(record.response.at(11), 50.0 * std::sin(0.9) * std::exp(-0.05), 1e-3);
  }
  static void expectAsked(const Result<Measurement>& got, std::initializer_list<const char*> options) {
    ASSERT_FALSE(got.ok());
    for (const char* option : options) {
      EXPECT_NE(got.error().line().find(option), std::string::npos) << got.error().line();
    }
  }
  record::TempFolder folder_;
};

TEST_F(HammerImport, UnitsComeFromTheHeader) {
  expectRight(import(tapText("Time (s),Force (N),Acc (m/s^2)\n", 1, 1, 1)));
  expectRight(import(tapText("Time (ms),Force (kN),Acc (g)\n", 1e3, 1e-3, 1 / 9.80665)));
  expectRight(import(tapText("Time (s),Hammer (lbf),Acc (in/s^2)\n", 1, 1 / 4.4482216152605, 1 / 0.0254)));
  const auto velocity = import(tapText("Time (s),Force (N),Velocity (mm/s)\n", 1, 1, 1e3));
  expectRight(velocity);
  EXPECT_EQ(hammerOf(velocity).quantity, FrfQuantity::Mobility);
  const auto gap = import(tapText("Time (s),Force (N),Displacement (um)\n", 1, 1, 1e6));
  expectRight(gap);
  EXPECT_EQ(hammerOf(gap).quantity, FrfQuantity::Compliance);
}

TEST_F(HammerImport, UnitsOfALabViewFileAreThoseOfItsLabels) {
  std::string text =
      "LabVIEW Measurement\t\nSeparator\tTab\n***End_of_Header***\t\nChannels\t2\nY_Unit_Label\tNewtons\tg\n"
      "Delta_X\t0.001\t0.001\n***End_of_Header***\t\t\nX_Value\tHammer\tAccelerometer\tComment\n";
  for (const char c : tapText("", 1, 1, 1 / 9.80665)) text += c == ',' ? '\t' : c;
  expectRight(import(text));
}

TEST_F(HammerImport, VoltsNeedTheirSensitivities) {
  const std::string volts = tapText("Time (s),Hammer (V),Accel (mV)\n", 1, 2.25e-3, 100.0 / 9.80665);
  expectAsked(import(volts), {"'Hammer'", "'Accel'", "--force-sensitivity", "--response-sensitivity"});
  ImportOptions given = options();
  given.forceSensitivity = "2.25mV/N";
  expectAsked(import(volts, given), {"--response-sensitivity"});
  given.responseSensitivity = "100mV/g";
  expectRight(import(volts, given));
  given.forceSensitivity = "100mV/g";
  expectAsked(import(volts, given), {"is no sensitivity"});
  given.forceSensitivity = "2.25mV/N";
  expectAsked(import(tapText("Time (s),Hammer (N),Accel (g)\n", 1, 1, 1), given), {"is not in volts"});
}

TEST_F(HammerImport, SensitivitiesOfTheHeaderAreUsed) {
  const double g = 9.80665;
  expectRight(import(tapText("Time (s),Hammer [V] (2.25 mV/N),Accel [V] (100 mV/g)\n", 1, 2.25e-3, 0.1 / g)));
  expectRight(import(tapText("Time (s),Hammer (V) 2.25 mV/N,Accel (mV) 100 mV/g\n", 1, 2.25e-3, 100 / g)));
  expectRight(import(tapText("Time (s),Hammer (V) 2.25 mV/N,Accel (V) 10.2 mV/(m/s^2)\n", 1, 2.25e-3, 10.2e-3)));
  expectRight(import(tapText("Time (s),Hammer 2.25 mV/N (V),Accel 100 mV/g (V)\n", 1, 2.25e-3, 0.1 / g)));
  const std::string bare = tapText("Time (s),Hammer (2.25 mV/N),Accel (10.2 mV/(m/s^2))\n", 1, 2.25e-3, 10.2e-3);
  expectAsked(import(bare),
              {"'Hammer', whose sensitivity is 2.25 mV/N, is in V or mV", "--force-unit V", "--response-unit V"});
  ImportOptions given = options();
  given.forceUnit = given.responseUnit = "V";
  expectRight(import(bare, given));
}

TEST_F(HammerImport, ALineOfUnitsMayHaveWords) {
  expectRight(import(tapText("Time,Hammer,Response\nSeconds,Newtons,g\n", 1, 1, 1 / 9.80665)));
}

TEST_F(HammerImport, UnitsNobodySaysAreAskedForTogether) {
  const std::string bare = tapText("Time (s),Force,Acc\n", 1, 1, 1);
  expectAsked(import(bare), {"'Force'", "'Acc'", "--force-unit", "--response-unit"});
  expectAsked(import(tapText("Time (s),Force (N),Acc (blob)\n", 1, 1, 1)), {"'blob'", "--response-unit"});
  ImportOptions given = options();
  given.forceUnit = "N";
  given.responseUnit = "m/s^2";
  expectRight(import(bare, given));
  given.responseUnit = "kg";
  expectAsked(import(bare, given), {"--response-unit", "'kg' is not known"});
}

TEST_F(HammerImport, SoundFilesNeedWhatTheirFullScaleIs) {
  const std::string path = folder_ / "tap.wav";
  auto writer = record::WavWriter::create(path, 2, Hertz(1000.0));
  ASSERT_TRUE(writer.ok());
  SampleBlock block;
  block.allocate(2, 100);
  block.frames = 100;
  block.rate = Hertz(1000.0);
  for (int i = 0; i < 100; ++i) {
    block.channel(0)[static_cast<std::size_t>(i)] = i == 11 ? 0.2F : 0.0F;
    block.channel(1)[static_cast<std::size_t>(i)] =
        i < 11 ? 0.0F : static_cast<float>(0.5 * std::exp(-0.05 * (i - 11)));
  }
  ASSERT_TRUE((*writer)->write(block).ok());
  ASSERT_TRUE((*writer)->finish().ok());
  ImportOptions given = options();
  given.forceUnit = "N";
  given.responseUnit = "V";
  given.responseSensitivity = "100mV/g";
  expectAsked(importMeasurement(path, given), {"full scale", "--force-scale", "--response-scale"});
  given.forceScale = 500.0;
  given.responseScale = 10.0;
  const auto got = importMeasurement(path, given);
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_NEAR(hammerOf(got).force.at(11), 100.0, 1e-3);
  EXPECT_NEAR(hammerOf(got).response.at(11), 0.5 * 10.0 / 0.1 * 9.80665, 1e-3);
}

TEST_F(HammerImport, ChannelsAreFoundByNameByShapeOrByOption) {
  ImportOptions given = options();
  given.forceUnit = "N";
  given.responseUnit = "m/s^2";
  const auto shape = import(tapText("", 1, 1, 1), given);
  expectRight(shape);
  ASSERT_FALSE(shape->remarks.empty());
  EXPECT_NE(text(shape->remarks[0]).find("read as the force"), std::string::npos);
  given.force = "1";
  const auto turned = import(tapText("", 1, 1, 1), given);
  ASSERT_TRUE(turned.ok()) << turned.error().line();
  EXPECT_NEAR(hammerOf(turned).response.at(11), 100.0, 1e-3);
  given.force = "no such";
  expectAsked(import(tapText("", 1, 1, 1), given), {"--force", "there is no channel 'no such'"});
}

TEST_F(HammerImport, SeveralResponsesAreToldApartOrAskedFor) {
  std::string text = "Time (s),Force (N),AccY (m/s^2),AccX (m/s^2)\n";
  for (int i = 0; i < 100; ++i) text += cells({1e-3 * i, i == 10 ? 100.0 : 0.0, 2.0, 1.0}) + "\n";
  expectAsked(import(text), {"'AccY' along y", "'AccX' along x", "--axis"});
  ImportOptions x = options();
  x.axes = {Axis::X};
  const auto one = import(text, x);
  ASSERT_TRUE(one.ok()) << one.error().line();
  EXPECT_EQ(hammerOf(one).response.at(3), 1.0);
  x.axes = {Axis::Y, Axis::X};
  const auto both = import(text, x);
  ASSERT_TRUE(both.ok()) << both.error().line();
  EXPECT_EQ(hammerOf(both, 1).axis, Axis::Y);
  EXPECT_EQ(hammerOf(both, 1).response.at(3), 2.0);
  ImportOptions named = options();
  named.responses = {"AccY"};
  named.axes = {Axis::X};  // the person knows where the sensor sat
  const auto overruled = import(text, named);
  ASSERT_TRUE(overruled.ok()) << overruled.error().line();
  EXPECT_EQ(hammerOf(overruled).axis, Axis::X);
  EXPECT_EQ(hammerOf(overruled).response.at(3), 2.0);
}

uff::Uff58Dataset timeResponse(uff::Uff58Quantity quantity, const std::string& unit, int direction, double value) {
  uff::Uff58Dataset set;
  set.function = uff::Uff58Function::TimeResponse;
  set.ordinate = {quantity, "", unit};
  set.responseDirection = direction;
  for (int i = 0; i < 64; ++i) {
    set.x.push_back(1e-3 * i);
    set.y.emplace_back(i == 10 ? value : 0.0);
  }
  return set;
}

uff::Uff58Dataset frequencyResponse(int response, int reference, const std::string& unit, double value) {
  uff::Uff58Dataset set;
  set.function = uff::Uff58Function::FrequencyResponse;
  set.complex = true;
  set.responseNode = set.referenceNode = 1;
  set.responseDirection = response;
  set.referenceDirection = reference;
  set.ordinate = {uff::Uff58Quantity::Displacement, "", unit};
  set.denominator = {uff::Uff58Quantity::ExcitationForce, "", unit == "NONE" ? "NONE" : "N"};
  for (int i = 0; i < 64; ++i) {
    set.x.push_back(10.0 * i);
    set.y.emplace_back(value, -value);
  }
  return set;
}

std::string ascii(const uff::Uff58Dataset& set) {
  return stillcut::test::uffDataset(set, uff::Uff58Form::Ascii);
}

TEST_F(HammerImport, TheForceOfAUniversalFileSaysWhichResponseIsDirect) {
  const std::string file = ascii(timeResponse(uff::Uff58Quantity::ExcitationForce, "N", 1, 100.0)) +
                           ascii(timeResponse(uff::Uff58Quantity::Acceleration, "m/s^2", 2, 7.0)) +
                           ascii(timeResponse(uff::Uff58Quantity::Acceleration, "m/s^2", -1, 5.0));
  const auto got = import(file);
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_EQ(hammerOf(got).axis, Axis::X);
  EXPECT_NEAR(hammerOf(got).response.at(10), -5.0, 1e-4) << "its direction is -x";
  const std::string alone = ascii(timeResponse(uff::Uff58Quantity::ExcitationForce, "N", 1, 100.0));
  EXPECT_FALSE(import(alone).ok());
}

TEST_F(HammerImport, UniversalFrequencyResponsesByDirectionAndUnit) {
  const std::string file = ascii(frequencyResponse(2, 1, "m", 1e-8)) + ascii(frequencyResponse(-1, 1, "mm", 1e-4)) +
                           ascii(frequencyResponse(2, 2, "um", 0.2));
  const auto got = import(file);
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_EQ(frfOf(got, 0).axis, Axis::X);
  EXPECT_NEAR(frfOf(got, 0).value[5].real(), -1e-7, 1e-12);
  EXPECT_EQ(frfOf(got, 1).axis, Axis::Y);
  EXPECT_NEAR(frfOf(got, 1).value[5].real(), 2e-7, 1e-12);
  ImportOptions cross = options();
  cross.dataset = 0;
  EXPECT_TRUE(import(file, cross).ok()) << "asked for by its number";
  cross.dataset = 3;
  expectAsked(import(file, cross), {"holds 3 frequency responses"});
}

TEST_F(HammerImport, UnitsOfAUniversalFileMayStandInDataset164) {
  const std::string units =
      "    -1\n   164\n         9User: mm N                   2\n"
      "  1.00000000000000000D+03  1.00000000000000000D+00  1.00000000000000000D+00\n  2.73150000000000000D+02\n    "
      "-1\n";
  const auto got = import(units + ascii(frequencyResponse(1, 1, "NONE", 1e-4)));
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_TRUE(frfOf(got).unitKnown);
  EXPECT_NEAR(frfOf(got).value[5].real(), 1e-7, 1e-12);
  const auto silent = import(ascii(frequencyResponse(1, 1, "NONE", 1e-4)));
  ASSERT_TRUE(silent.ok()) << silent.error().line();
  EXPECT_FALSE(frfOf(silent).unitKnown);
  const auto odd = import(ascii(frequencyResponse(1, 1, "furlong", 1e-4)));
  expectAsked(odd, {"furlong", "--unit"});
}

}  // namespace
}  // namespace stillcut::identify
