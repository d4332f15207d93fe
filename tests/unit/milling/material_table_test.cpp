// The table of materials: every entry usable and with its source, names found as people write them, files that name
// one.
#include "core/milling/material_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/config/toml_reader.h"
#include "core/milling/linear_force.h"
#include "core/milling/model_toml.h"

namespace stillcut::milling {
namespace {

TEST(MaterialTable, ThirtyMaterialsEachWithItsSourceAndSpread) {
  EXPECT_GE(materialTable().size(), 30U);
  std::set<std::string> names;
  for (const TableMaterial& entry : materialTable()) {
    SCOPED_TRACE(entry.name);
    EXPECT_FALSE(entry.source.empty());
    EXPECT_FALSE(entry.remark.empty());
    EXPECT_FALSE(entry.what.empty());
    EXPECT_TRUE(names.insert(entry.name).second);
    for (const std::string& other : entry.also) EXPECT_TRUE(names.insert(other).second) << other;
    const Material m = linearisedAt(entry.material, entry.material.usualChip);
    EXPECT_GT(m.tangential, 3e8);
    EXPECT_LT(m.tangential, 6e9);
    EXPECT_GT(m.radial, 0.1 * m.tangential);
    EXPECT_LT(m.radial, 0.6 * m.tangential);
    EXPECT_GE(m.spread, 0.1);
    EXPECT_GT(m.processDamping, 0.0);
    EXPECT_GT(m.dampingSpread, 0.0);
    EXPECT_TRUE(m.exponent == 1.0 || entry.material.usualChip.value > 0.0) << "no chip to linearise at";
  }
}

// C45 in Kienzle's form: 1500 N/mm2 at 1 mm, 1500 h^-0.22 elsewhere.
TEST(MaterialTable, APowerLawGivesTheForceOfItsSource) {
  const Material m = materialNamed("C45", "test").value();
  for (double mm : {1.0, 0.1, 0.02}) {
    const double perMm = m.tangential * std::pow(1e-3 * mm, m.exponent) * 1e-3;  // N per mm of edge
    EXPECT_NEAR(perMm, 1500.0 * std::pow(mm, 1.0 - 0.22), 1e-6 * perMm) << mm;
  }
}

TEST(MaterialTable, NamesAreFoundAsPeopleWriteThem) {
  for (const char* name : {"7075-T6", "7075 t6", "7075T6", "en aw-7075"})
    EXPECT_NE(findMaterial(name), nullptr) << name;
  EXPECT_EQ(findMaterial("3.7165"), findMaterial("ti6al4v"));
  EXPECT_EQ(findMaterial("unobtainium"), nullptr);
  EXPECT_NE(materialNamed("7075-T8", "cut.toml:3").error().line().find("did you mean '7075-T6'?"), std::string::npos);
}

TEST(MaterialTable, HasTheKindsOfWhichNothingElseIsKnown) {
  for (const char* kind : {"aluminium", "steel", "stainless", "titanium", "cast iron", "brass"})
    EXPECT_NE(findMaterial(kind), nullptr) << kind;
}

CutModel cutFrom(const std::string& material, std::string* error = nullptr) {
  const std::string text = R"([[mode]]
frequency_hz = 900
damping = 0.02
stiffness_n_per_m = 1e7
direction = [1, 0]
[tool]
teeth = 2
[engagement]
radial_immersion = 0.5
side = "down"
)";
  const config::TomlReader in = config::TomlReader::text(material + text, "cut.toml");
  CutModel model = readModel(in.root());
  if (const Status ok = in.finish(); !ok && error != nullptr) *error = ok.error().line();
  return model;
}

TEST(MaterialTable, AFileNamesItsMaterialOrAdaptsOne) {
  const Material table = materialNamed("Ti-6Al-4V", "test").value();
  const Material named = cutFrom("material = \"Ti-6Al-4V\"\n").material;
  EXPECT_EQ(named.tangential, table.tangential);
  EXPECT_EQ(named.exponent, table.exponent);
  EXPECT_EQ(named.spread, table.spread);
  const Material worn =
      cutFrom("[material]\nname = \"Ti-6Al-4V\"\nindentation_n_per_m3 = 3e13\nwear_land_mm = 0.1\n").material;
  EXPECT_EQ(worn.tangential, table.tangential);
  EXPECT_NEAR(worn.processDamping, 0.5 * 3e13 * 1e-8, 1e-3);
  std::string error;
  cutFrom("material = \"Ti-6Al-4W\"\n", &error);
  EXPECT_NE(error.find("cut.toml:1"), std::string::npos) << error;
  EXPECT_NE(error.find("did you mean 'Ti-6Al-4V'?"), std::string::npos) << error;
}

TEST(MaterialTable, WhatIsWrittenReadsBackTheSame) {
  for (const TableMaterial& entry : materialTable()) {
    const config::TomlReader in = config::TomlReader::text(materialText(entry.material), entry.name);
    const Material back = readMaterial(in.root().table("material"));
    ASSERT_TRUE(in.finish().ok());
    EXPECT_EQ(back.tangential, entry.material.tangential) << entry.name;
    EXPECT_EQ(back.spread, entry.material.spread) << entry.name;
    EXPECT_EQ(back.dampingSpread, entry.material.dampingSpread) << entry.name;
    EXPECT_EQ(back.usualChip, entry.material.usualChip) << entry.name;
  }
}

TEST(MaterialTable, LobesTakeAPowerLawAsStraightAtTheFeedOrTheUsualChip) {
  CutModel model = cutFrom("material = \"1045\"\n");
  CutModel fed = model;
  const Metres usual = lineariseForLobes(model, Metres(0.0));
  EXPECT_EQ(usual.value, 5e-5);
  EXPECT_EQ(model.material.exponent, 1.0);
  // d/dh of 1500 h^0.78 N/mm at 0.05 mm.
  EXPECT_NEAR(1e-6 * model.material.tangential, 0.78 * 1500.0 * std::pow(0.05, -0.22), 0.1);
  const Metres mean = lineariseForLobes(fed, Metres(2e-4));
  EXPECT_NEAR(mean.value, 2e-4 * 2.0 / 3.14159265, 1e-8);  // f_z/(pi/2) over a quarter turn
  EXPECT_LT(fed.material.tangential, model.material.tangential);
}

TEST(MaterialTable, ATableThatIsNoTableIsOneLine) {
  EXPECT_FALSE(readMaterialTable("[usual]\n", "t").ok());
  EXPECT_FALSE(readMaterialTable("nonsense", "t").ok());
}

}  // namespace
}  // namespace stillcut::milling
