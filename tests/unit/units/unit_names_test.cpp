// Units and names as laboratories write them.
#include "core/units/unit_names.h"

#include <gtest/gtest.h>

#include <string>

namespace stillcut::record {
namespace {

struct Spelling {
  const char* text;
  SensorQuantity quantity;
  double toSi;
};

TEST(UnitNames, ManySpellingsOfTheSameUnit) {
  const Spelling spellings[] = {{"m/s^2", SensorQuantity::Acceleration, 1.0},
                                {"m/s\u00b2", SensorQuantity::Acceleration, 1.0},
                                {"[m/s**2]", SensorQuantity::Acceleration, 1.0},
                                {" ( m / s^2 ) ", SensorQuantity::Acceleration, 1.0},
                                {"m/sec^2", SensorQuantity::Acceleration, 1.0},
                                {"mm/s\u00b2", SensorQuantity::Acceleration, 1e-3},
                                {"g", SensorQuantity::Acceleration, 9.80665},
                                {"mg", SensorQuantity::Acceleration, 9.80665e-3},
                                {"\u00b5m", SensorQuantity::Displacement, 1e-6},
                                {"\u03bcm", SensorQuantity::Displacement, 1e-6},
                                {"um", SensorQuantity::Displacement, 1e-6},
                                {"in", SensorQuantity::Displacement, 0.0254},
                                {"mil", SensorQuantity::Displacement, 2.54e-5},
                                {"in/s", SensorQuantity::Velocity, 0.0254},
                                {"\"N\"", SensorQuantity::Force, 1.0},
                                {"lbf", SensorQuantity::Force, 4.4482216152605},
                                {"mPa", SensorQuantity::Sound, 1e-3},
                                {"mA", SensorQuantity::Current, 1e-3},
                                {"1/min", SensorQuantity::SpindleSpeed, 1.0}};
  for (const Spelling& s : spellings) {
    const auto meaning = unitFromText(s.text);
    ASSERT_TRUE(meaning.has_value()) << s.text;
    EXPECT_EQ(meaning->kind, UnitKind::Sensor) << s.text;
    EXPECT_EQ(meaning->quantity, s.quantity) << s.text;
    EXPECT_NEAR(meaning->toSi / s.toSi, 1.0, 1e-12) << s.text;
  }
}

TEST(UnitNames, WhatDoesNotVibrateIsKnownAsSuch) {
  for (const char* text : {"Hz", "deg", "%", "bar", "W", "Nm", "\u00b0C"}) {
    const auto meaning = unitFromText(text);
    ASSERT_TRUE(meaning.has_value()) << text;
    EXPECT_EQ(meaning->kind, UnitKind::Other) << text;
    EXPECT_FALSE(meaning->quantity.has_value()) << text;
  }
  EXPECT_EQ(unitFromText("V")->kind, UnitKind::Voltage);
  EXPECT_EQ(unitFromText("mV")->kind, UnitKind::Voltage);
}

TEST(UnitNames, TimeInItsParts) {
  for (const auto& [text, seconds] : {std::pair{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60.0}}) {
    const auto meaning = unitFromText(text);
    ASSERT_TRUE(meaning.has_value()) << text;
    EXPECT_EQ(meaning->kind, UnitKind::Time);
    EXPECT_EQ(meaning->toSi, seconds);
  }
}

TEST(UnitNames, CaseMattersWhereItDecides) {
  EXPECT_EQ(unitFromText("MPa"), std::nullopt);  // a million of what mPa is a thousandth of
  EXPECT_EQ(unitFromText("n"), std::nullopt);
  for (const char* text : {"", "furlong", "m/s^3", "NN", "()"}) EXPECT_FALSE(unitFromText(text).has_value()) << text;
}

TEST(UnitNames, ANameAndItsUnitArePartedAtTheLastBracket) {
  const auto both = splitNameAndUnit("Accel X (m/s^2)");
  EXPECT_EQ(both.name, "Accel X");
  EXPECT_EQ(both.unit, "m/s^2");
  const auto square = splitNameAndUnit(" Force [kN] ");
  EXPECT_EQ(square.name, "Force");
  EXPECT_EQ(square.unit, "kN");
  const auto nested = splitNameAndUnit("Accel (10.2 mV/(m/s^2))");
  EXPECT_EQ(nested.name, "Accel");
  EXPECT_EQ(nested.unit, "10.2 mV/(m/s^2)");
  for (const char* text : {"Hammer [V] (2.25 mV/N)", "Hammer (V) (2.25 mV/N)"}) {
    const auto volts = splitNameAndUnit(text);
    EXPECT_EQ(volts.name, "Hammer (2.25 mV/N)") << text;
    EXPECT_EQ(volts.unit, "V") << text;
  }
  const auto alone = splitNameAndUnit("Sensor 3");
  EXPECT_EQ(alone.name, "Sensor 3");
  EXPECT_EQ(alone.unit, "");
}

TEST(UnitNames, NamesSayWhatTheyAre) {
  const std::pair<const char*, NameMeaning> names[] = {{"time", NameMeaning::Time},
                                                       {"Zeit", NameMeaning::Time},
                                                       {"Accel X", NameMeaning::Acceleration},
                                                       {"vibration", NameMeaning::Acceleration},
                                                       {"Mic 1", NameMeaning::Sound},
                                                       {"Fx", NameMeaning::Force},
                                                       {"Force Y", NameMeaning::Force},
                                                       {"label", NameMeaning::NoSignal},
                                                       {"index", NameMeaning::NoSignal},
                                                       {"CI Value", NameMeaning::NoSignal},
                                                       {"Tacho", NameMeaning::NoSignal},
                                                       {"blob", NameMeaning::Unknown}};
  for (const auto& [text, meaning] : names) EXPECT_EQ(meaningOfName(text), meaning) << text;
}

TEST(UnitNames, AxesAreReadFromTheEndOfAName) {
  for (const auto& [text, axis] :
       {std::pair{"Accel X", "x"}, {"acc_y", "y"}, {"Fz", "z"}, {"Force Z", "z"}, {"Box", ""}, {"Mic", ""}, {"", ""}}) {
    EXPECT_EQ(axisOfName(text), axis) << text;
  }
}

TEST(UnitNames, TrimmingTakesBlanksAndQuotes) {
  EXPECT_EQ(trimmed("  \"a b\"\r\n"), "a b");
  EXPECT_EQ(trimmed(" \t "), "");
}

}  // namespace
}  // namespace stillcut::record
