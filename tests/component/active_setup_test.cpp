// The device of the active work-holder as a profile names it.
#include "app/compose/active_setup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "app/compose/profile_rig.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {
namespace {

Result<ActiveParts> partsOf(const std::string& settings) {
  const auto profile =
      config::parseProfile("version = 1\nmachine = \"Mill\"\n[active]\nid = \"alsa\"\n[active.settings]\n" + settings,
                           "test.toml", pipeline::fullCatalog(), knownIds());
  if (!profile) return profile.error();
  return makeActiveParts(*profile);
}

TEST(ActiveSetup, TakesDeviceLimitsAndLinesFromTheProfile) {
  const auto parts = partsOf(
      "device = \"hw:7,0\"\nfull_stroke_um = 3.0\nstroke_um = 2.5\nslew_m_per_s = 0.04\nquieten_hz = \"339, 1024\"\n");
#ifdef STILLCUT_ALSA
  ASSERT_TRUE(parts.ok()) << parts.error().line();
#else
  if (!parts) GTEST_SKIP() << parts.error().line();
#endif
  EXPECT_EQ(parts->device->name(), "hw:7,0");
  EXPECT_DOUBLE_EQ(parts->options.limits[1].amplitude, 2.5e-6);
  EXPECT_DOUBLE_EQ(parts->options.limits[0].slew, 0.04);
  EXPECT_EQ(parts->options.lines, (std::vector<Hertz>{Hertz(339.0), Hertz(1024.0)}));
  // There is no such card here, and the line says which.
  const auto opened = parts->device->open();
  ASSERT_FALSE(opened.ok());
  EXPECT_THAT(opened.error().line(), testing::HasSubstr("hw:7,0"));
}

TEST(ActiveSetup, WhatContradictsItselfIsOneLine) {
  for (const auto& [settings, said] : {std::pair{"quieten_hz = \"339; 1024\"\n", "quieten_hz"},
                                       {"stroke_um = 4.0\n", "stroke_um"},
                                       {"input_x = -1\n", "input_x"},
                                       {"rate_hz = 10\n", "rate_hz"},
                                       {"devise = \"hw:0\"\n", "devise"}}) {
    const auto parts = partsOf(settings);
    ASSERT_FALSE(parts.ok()) << settings;
    EXPECT_THAT(parts.error().line(), testing::HasSubstr(said));
  }
}

TEST(ActiveSetup, AProfileKeepsIt) {
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  const auto profile =
      config::parseProfile("version = 1\nmachine = \"Mill\"\n[active]\nid = \"alsa\"\n[active.settings]\ninput_y = 3\n",
                           "test.toml", catalog, knownIds());
  ASSERT_TRUE(profile.ok()) << profile.error().line();
  const auto again = config::parseProfile(config::profileText(*profile, catalog), "again.toml", catalog, knownIds());
  ASSERT_TRUE(again.ok()) << again.error().line();
  EXPECT_EQ(again->active.id, "alsa");
  EXPECT_EQ(again->active.settings, profile->active.settings);
  const auto unknown =
      config::parseProfile("version = 1\nmachine = \"Mill\"\n[active]\nid = \"asla\"\n", "x.toml", catalog, knownIds());
  ASSERT_FALSE(unknown.ok());
  EXPECT_THAT(unknown.error().line(), testing::HasSubstr("alsa"));
}

}  // namespace
}  // namespace stillcut::app
