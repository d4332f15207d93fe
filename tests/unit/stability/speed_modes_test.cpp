// Modes that change with the spindle's speed: at each speed the lobes are those of the modes there.
#include <gtest/gtest.h>

#include <cmath>

#include "core/milling/model_toml.h"
#include "core/milling/stability/forced_vibration.h"
#include "core/milling/stability/limit_band.h"
#include "core/milling/stability/lobe_sweep.h"
#include "tests/unit/stability/reference_cases.h"

namespace stillcut::milling {
namespace {

// Softer and lower as the spindle turns faster.
CutModel spindle() {
  CutModel model = textbookHalf();
  for (Mode& m : model.modes) {
    const Mode rest = m;
    m.atSpeeds = {{Rpm(0.0), rest.frequency, rest.damping, rest.stiffness},
                  {Rpm(10000.0), 0.9 * rest.frequency, 1.2 * rest.damping, 0.8 * rest.stiffness},
                  {Rpm(20000.0), 0.8 * rest.frequency, 1.5 * rest.damping, 0.6 * rest.stiffness}};
  }
  return model;
}

CutModel scaled(double frequency, double damping, double stiffness) {
  CutModel model = textbookHalf();
  for (Mode& m : model.modes) {
    m.frequency = frequency * m.frequency;
    m.damping *= damping;
    m.stiffness *= stiffness;
  }
  return model;
}

double limitOf(const CutModel& model, double rpm, LobeMethod method) {
  SweepOptions options;
  options.method = method;
  options.limits.maxAxialDepth = Metres(0.010);
  const auto sweep = sweepLobes(model, std::vector<Rpm>{Rpm(rpm)}, options, "spindle");
  if (!sweep || !sweep->speeds.front().hasLimit()) return -1.0;
  return sweep->speeds.front().crossings.front().depth.value;
}

TEST(SpeedModes, EverySpeedHasTheModesOfItsTable) {
  const struct {
    double rpm;
    CutModel model;
  } known[] = {{5000.0, scaled(0.95, 1.1, 0.9)},
               {10000.0, scaled(0.9, 1.2, 0.8)},
               {15000.0, scaled(0.85, 1.35, 0.7)},
               {26000.0, scaled(0.8, 1.5, 0.6)}};
  int limited = 0;
  for (const auto& k : known) {
    for (LobeMethod method : {LobeMethod::Exact, LobeMethod::SemiDiscretization, LobeMethod::ZerothOrder}) {
      const double depth = limitOf(k.model, k.rpm, method);
      limited += depth > 0.0 ? 1 : 0;
      EXPECT_NEAR(limitOf(spindle(), k.rpm, method), depth, 1e-9 * std::abs(depth)) << k.rpm;
    }
    const auto there = forcedVibration(spindle(), Rpm(k.rpm), Metres(1e-3), Metres(1e-4));
    const auto known1 = forcedVibration(k.model, Rpm(k.rpm), Metres(1e-3), Metres(1e-4));
    ASSERT_TRUE(there && known1);
    EXPECT_NEAR(there->acceleration, known1->acceleration, 1e-9 * known1->acceleration);
    const ModelSpread spread{0.01, 0.1, 0.1, 0.1};
    const std::vector<Rpm> speeds{Rpm(k.rpm)};
    const auto band = limitBands(spindle(), speeds, Metres(0.010), spread, 1, "spindle");
    const auto bandThere = limitBands(k.model, speeds, Metres(0.010), spread, 1, "spindle");
    ASSERT_TRUE(band.ok() && bandThere.ok());
    EXPECT_NEAR(band->speeds.front().low.value, bandThere->speeds.front().low.value, 1e-9);
  }
  EXPECT_GE(limited, 9);
}

Result<CutModel> read(const std::string& text) {
  config::TomlReader reader = config::TomlReader::text(text, "spindle.toml");
  CutModel model = readModel(reader.root());
  if (Status ok = reader.finish(); !ok) return ok.error();
  if (Status ok = check(model, "spindle.toml"); !ok) return ok.error();
  return model;
}

TEST(SpeedModes, ATableReadsBackAndABadOneIsRefused) {
  const std::string text = modelText(spindle());
  const auto back = read(text);
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_EQ(modelText(*back), text);
  ASSERT_EQ(back->modes.front().atSpeeds.size(), 3u);
  CutModel falling = spindle();
  std::swap(falling.modes.front().atSpeeds[0], falling.modes.front().atSpeeds[1]);
  const auto refused = read(modelText(falling));
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().line().find("must rise"), std::string::npos) << refused.error().line();
  std::string shorter = text;
  const auto comma = shorter.find(", ", shorter.find("speeds_rpm"));
  shorter.erase(comma, shorter.find(']', comma) - comma);
  const auto uneven = read(shorter);
  ASSERT_FALSE(uneven.ok());
  EXPECT_NE(uneven.error().line().find("one number for each"), std::string::npos) << uneven.error().line();
}

}  // namespace
}  // namespace stillcut::milling
