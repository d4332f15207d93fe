// Frequency responses from text and MATLAB files, whatever their columns, units and decimal signs.
#include <gtest/gtest.h>
#include <matio.h>

#include "core/milling/identify/import/unit_label.h"
#include "tests/unit/identify/import_files.h"

namespace stillcut::identify {
namespace {

using namespace test;
using Complex = std::complex<double>;

class FrfImport : public testing::Test {
 protected:
  Result<Measurement> import(const std::string& content, const ImportOptions& o = options()) {
    return importMeasurement(folder_.file("frf.txt", content), o);
  }
  // One response, right on every line after the file's own rounding.
  static void expectRight(const Result<Measurement>& got, std::size_t i = 0) {
    ASSERT_TRUE(got.ok()) << got.error().line();
    const Frf si = toCompliance(frfOf(got, i));
    ASSERT_GE(si.frequency.size(), 200u);
    EXPECT_TRUE(si.unitKnown);
    for (std::size_t k = 0; k < si.frequency.size(); ++k) {
      ASSERT_NEAR(std::abs(si.value[k] / compliance(si.frequency[k]) - 1.0), 0.0, 1e-6) << si.frequency[k];
    }
  }
  record::TempFolder folder_;
};

TEST(UnitLabel, KnowsTheUsualSpellings) {
  EXPECT_DOUBLE_EQ(frfUnit("mm/N")->factor, 1e-3);
  EXPECT_EQ(frfUnit("(m/s^2)/N")->quantity, FrfQuantity::Accelerance);
  EXPECT_EQ(frfUnit("1/N*(m/s\xC2\xB2)")->quantity, FrfQuantity::Accelerance);
  EXPECT_EQ(frfUnit("(m/s\xB2)/N")->quantity, FrfQuantity::Accelerance) << "Latin-1";
  EXPECT_EQ(frfUnit("1/kg")->quantity, FrfQuantity::Accelerance);
  EXPECT_EQ(frfUnit("m/s/N")->quantity, FrfQuantity::Mobility);
  EXPECT_NEAR(frfUnit("g/lbf")->factor, 9.80665 / 4.4482216, 1e-6);
  EXPECT_NEAR(frfUnit("in/s^2/lbf")->factor, 0.0254 / 4.4482216, 1e-9);
  EXPECT_DOUBLE_EQ(responseUnit("\xC2\xB5m")->factor, 1e-6);
  EXPECT_DOUBLE_EQ(frfUnit("MM/N")->factor, 1e-3) << "universal files write capitals";
  EXPECT_DOUBLE_EQ(frfUnit("( g ) / ( lb )")->factor, frfUnit("g/lbf")->factor);
  EXPECT_DOUBLE_EQ(*forceUnit("Newtons"), 1.0);
  EXPECT_DOUBLE_EQ(*frequencyUnit("rad/s") * kTwoPi, 1.0);
  EXPECT_FALSE(frfUnit("V/Pa"));
  EXPECT_FALSE(frfUnit("m"));
  EXPECT_FALSE(frfUnit("N/m"));
}

TEST(UnitLabel, SensitivitiesNeedBothUnits) {
  EXPECT_DOUBLE_EQ(sensitivityFromText("2.25 mV/N")->voltsPerUnit, 2.25e-3);
  EXPECT_NEAR(sensitivityFromText("10mV/lbf")->voltsPerUnit, 10e-3 / 4.4482216, 1e-9);
  EXPECT_NEAR(sensitivityFromText("100mV/g")->voltsPerUnit, 0.1 / 9.80665, 1e-12);
  EXPECT_EQ(sensitivityFromText("100 mV/g")->response, FrfQuantity::Accelerance);
  EXPECT_FALSE(sensitivityFromText("100"));
  EXPECT_FALSE(sensitivityFromText("0mV/N"));
  EXPECT_FALSE(sensitivityFromText("5 N/mV"));
}

TEST_F(FrfImport, UnitsOfValueAndFrequencyComeFromTheHeader) {
  const auto scaled = [](double f, double v) {
    return [f, v](double hertz, Complex h) { return cells({f * hertz, v * h.real(), v * h.imag()}); };
  };
  expectRight(import(frfText("Frequency [Hz],Real [m/N],Imag [m/N]\n", scaled(1, 1))));
  expectRight(import(frfText("Frequency [kHz],Real [mm/N],Imag [mm/N]\n", scaled(1e-3, 1e3))));
  expectRight(import(frfText("omega [rad/s],Re [um/N],Im [um/N]\n", scaled(kTwoPi, 1e6))));
  expectRight(import(frfText("X-Axis unit:\tHz\nY-Axis unit:\tmm/N\nX,Real,Imaginary\n", scaled(1, 1e3))));
  expectRight(import(frfText("f,re,im\nkHz,um/N,um/N\n", scaled(1e-3, 1e6))));
}

TEST_F(FrfImport, AccelerancesAndMobilitiesBecomeTheSameCompliance) {
  const auto derived = [](double f, Complex h, int times, double unit) {
    const Complex s(0.0, kTwoPi * f);
    const Complex v = h * (times == 1 ? s : s * s) / unit;
    return cells({f, v.real(), v.imag()});
  };
  for (const auto& [unit, times, factor] :
       {std::tuple{"(m/s\xB2)/N", 2, 1.0}, std::tuple{"1/kg", 2, 1.0}, std::tuple{"g/N", 2, 9.80665},
        std::tuple{"in/s^2/lbf", 2, 0.0254 / 4.4482216152605}, std::tuple{"mm/s/N", 1, 1e-3}}) {
    const std::string header = std::string("Frequency (Hz),Real (") + unit + "),Imag (" + unit + ")\n";
    const int n = times;
    const double by = factor;
    expectRight(import(frfText(header, [&](double f, Complex h) { return derived(f, h, n, by); })));
  }
}

TEST_F(FrfImport, EveryFormOfAComplexNumber) {
  expectRight(import(frfText("f (Hz),FRF (m/N)\n", [](double f, Complex h) {
    char line[99];
    std::snprintf(line, sizeof line, "%.1f,%.9e%+.9ei", f, h.real(), h.imag());
    return std::string(line);
  })));
  expectRight(import(frfText("Freq (Hz);Magnitude (m/N);Phase (deg)\n", [](double f, Complex h) {
    return cells({f, std::abs(h), 360.0 / kTwoPi * std::arg(h)}, ';');
  })));
  expectRight(import(frfText("Freq (Hz),Magnitude (m/N),Phase (rad)\n", [](double f, Complex h) {
    return cells({f, std::abs(h), std::arg(h)});
  })));
  expectRight(import(frfText("Frequenz [Hz];Realteil [m/N];Imaginaerteil [m/N]\n", [](double f, Complex h) {
    std::string line = cells({f, h.real(), h.imag()}, ';');
    for (char& c : line) c = c == '.' ? ',' : c;
    return line;
  })));
  const auto both = import(
      frfText("Freq (Hz),Real (m/N),Imag (m/N),Magnitude (m/N),Phase (deg),Coherence\n", [](double f, Complex h) {
        return cells({f, h.real(), h.imag(), std::abs(h), 0.0, 0.97});
      }));
  expectRight(both);
  EXPECT_DOUBLE_EQ(frfOf(both).coherence.at(7), 0.97);
}

TEST_F(FrfImport, DirectAndCrossResponsesAreToldApart) {
  const std::string both = frfText(
      "Frequency [Hz],Re Gxy [m/N],Im Gxy [m/N],Re Gyy [m/N],Im Gyy [m/N],"
      "Re Gxx [m/N],Im Gxx [m/N]\n",
      [](double f, Complex h) {
        return cells({f, 0.1 * h.real(), 0.1 * h.imag(), 2 * h.real(), 2 * h.imag(), h.real(), h.imag()});
      });
  const auto all = import(both);
  expectRight(all);
  EXPECT_EQ(frfOf(all, 0).axis, Axis::X);
  EXPECT_EQ(frfOf(all, 1).axis, Axis::Y);
  EXPECT_NEAR(frfOf(all, 1).value[5].real(), 2.0 * compliance(25.0).real(), 1e-13);
  ImportOptions y = options();
  y.axes = {Axis::Y};
  const auto one = import(both, y);
  ASSERT_TRUE(one.ok());
  EXPECT_EQ(std::get<std::vector<Frf>>(one->data).size(), 1u);
  const auto unclear = import(frfText("f [Hz],Re A [m/N],Im A [m/N],Re B [m/N],Im B [m/N]\n", [](double f, Complex h) {
    return cells({f, h.real(), h.imag(), h.real(), h.imag()});
  }));
  ASSERT_FALSE(unclear.ok());
  EXPECT_NE(unclear.error().line().find("holds 2 responses: 'a', 'b'"), std::string::npos) << unclear.error().line();
}

// One hammer and two sensors, or each axis hit by itself: "X" and "Y" alone do not say which.
TEST_F(FrfImport, TwoAxesWithoutTheirForceAreAskedAbout) {
  const std::string file =
      frfText("Frequency [Hz],X Re [m/N],X Im [m/N],Y Re [m/N],Y Im [m/N]\n", [](double f, Complex h) {
        return cells({f, h.real(), h.imag(), 0.1 * h.real(), 0.1 * h.imag()});
      });
  const auto asked = import(file);
  ASSERT_FALSE(asked.ok());
  EXPECT_NE(asked.error().line().find("'x' along x, 'y' along y"), std::string::npos) << asked.error().line();
  EXPECT_NE(asked.error().line().find("--axis"), std::string::npos) << asked.error().line();
  ImportOptions hit = options();
  hit.axes = {Axis::X};
  const auto one = import(file, hit);
  expectRight(one);
  EXPECT_EQ(std::get<std::vector<Frf>>(one->data).size(), 1U);
  hit.axes = {Axis::X, Axis::Y};
  const auto both = import(file, hit);
  ASSERT_TRUE(both.ok()) << both.error().line();
  EXPECT_EQ(std::get<std::vector<Frf>>(both->data).size(), 2U) << "each axis was hit by itself";
  const auto alone = import(frfText("Frequency [Hz],Y Re [m/N],Y Im [m/N]\n", [](double f, Complex h) {
    return cells({f, h.real(), h.imag()});
  }));
  expectRight(alone);
  EXPECT_EQ(frfOf(alone).axis, Axis::Y);
  const auto pair = import(frfText("Frequency [Hz],Re X/Y [m/N],Im X/Y [m/N]\n", [](double f, Complex h) {
    return cells({f, h.real(), h.imag()});
  }));
  ASSERT_FALSE(pair.ok());
  EXPECT_NE(pair.error().line().find("is a cross one, by a force along y"), std::string::npos);
}

TEST_F(FrfImport, ACrossResponseIsNeverTakenForADirectOne) {
  const std::string cross = frfText("Frequency [Hz],Re Gyx [m/N],Im Gyx [m/N]\n", [](double f, Complex h) {
    return cells({f, h.real(), h.imag()});
  });
  ImportOptions y = options();
  y.axes = {Axis::Y};
  for (const ImportOptions& o : {options(), y}) {
    const auto refused = import(cross, o);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().line().find("is a cross one, by a force along x"), std::string::npos);
  }
  y.responses = {"Gyx"};
  EXPECT_TRUE(import(cross, y).ok()) << "named by whoever knows";
  y.responses = {"Gzz"};
  EXPECT_NE(import(cross, y).error().line().find("holds no response 'Gzz' (it holds 'gyx')"), std::string::npos);
}

TEST_F(FrfImport, WhatNobodySaysIsAskedForByName) {
  const auto row = [](double f, Complex h) { return cells({f, h.real(), h.imag()}); };
  const auto asks = [](const Result<Measurement>& got, const std::string& option) {
    ASSERT_FALSE(got.ok());
    EXPECT_NE(got.error().line().find(option), std::string::npos) << got.error().line();
  };
  const auto bare = import(frfText("", row));
  ASSERT_TRUE(bare.ok()) << bare.error().line();
  EXPECT_FALSE(frfOf(bare).unitKnown) << "who fits it has to ask";
  ASSERT_EQ(bare->remarks.size(), 1u);
  EXPECT_NE(text(bare->remarks[0]).find("read as Hz"), std::string::npos);
  asks(import(frfText("f [Hz],re [furlong/N],im [furlong/N]\n", row)), "--unit");
  asks(import(frfText("omega,re [m/N],im [m/N]\n", row)), "--frequency-unit");
  asks(import(frfText("", [&](double f, Complex h) { return row(1e-3 * (f + 5000.0), h); })), "--frequency-unit");
  asks(import(frfText("f [Hz],mag [m/N],phase\n",
                      [](double f, Complex h) {
                        return cells({f, std::abs(h), std::arg(h)});
                      })),
       "--phase-unit");
}

TEST_F(FrfImport, DecibelsAreReadWhereTheirReferenceIsKnown) {
  const auto of = [](double reference) {
    return [reference](double f, Complex h) {
      return cells({f, 20.0 * std::log10(std::abs(h) / reference), 360.0 / kTwoPi * std::arg(h)});
    };
  };
  expectRight(import(frfText("f (Hz),Magnitude (dB re 1 m/N),Phase (deg)\n", of(1.0))));
  expectRight(import(frfText("f (Hz),Magnitude (dB re 1e-12 m/N),Phase (deg)\n", of(1e-12))));
  expectRight(import(frfText("f (Hz),Magnitude dB re 1 um/N,Phase (deg)\n", of(1e-6))));
  expectRight(import(frfText("f (Hz),Amplitude dB (mm/N),Phase (deg)\n", of(1e-3))));
  expectRight(import(frfText("f [Hz],Mag [dB um/N],Phase [deg]\n", of(1e-6))));
  for (const char* header :
       {"f (Hz),Magnitude (dB),Phase (deg)\n", "f (Hz),Mag dB,Phase (deg)\n", "f [Hz],mag [dB],phase [deg]\n"}) {
    const auto asked = import(frfText(header, of(1e-12)));
    ASSERT_FALSE(asked.ok()) << header;
    EXPECT_NE(asked.error().line().find("are in decibels, and it does not say of what"), std::string::npos)
        << asked.error().line();
    ImportOptions given = options();
    given.unit = "dB re 1e-12 m/N";
    expectRight(import(frfText(header, of(1e-12)), given));
    given.unit = "um/N";
    expectRight(import(frfText(header, of(1e-6)), given));
  }
  const auto negative = import(frfText("f (Hz),Magnitude (m/N),Phase (deg)\n", of(1.0)));
  ASSERT_FALSE(negative.ok());
  EXPECT_NE(negative.error().line().find("--unit \"dB re 1 m/N\""), std::string::npos) << negative.error().line();
  EXPECT_FALSE(import(frfText("f (Hz),Real (dB re 1 m/N),Imag (dB re 1 m/N)\n", of(1.0))).ok());
}

TEST_F(FrfImport, AUnitThatNobodyKnowsIsAskedForAndNotDropped) {
  const auto row = [](double f, Complex h) { return cells({f, h.real(), h.imag()}); };
  const auto asked = import(frfText("f (Hz),Real (counts),Imag (counts)\n", row));
  ASSERT_FALSE(asked.ok());
  EXPECT_NE(asked.error().line().find("unit 'counts' is not known"), std::string::npos) << asked.error().line();
  ImportOptions given = options();
  given.unit = "m/N";
  expectRight(import(frfText("f (Hz),Real (counts),Imag (counts)\n", row), given));
  expectRight(import(frfText("f (Hz),Re(Gxx) [m/N],Im(Gxx) [m/N]\n", row)));
  expectRight(import(frfText("f (Hz),Real (part),Imag (part)\n", row), given));
  const auto mixed = import(frfText("f (Hz),Real (m/N),Imag (um/N)\n", row));
  ASSERT_FALSE(mixed.ok());
  EXPECT_NE(mixed.error().line().find("its real part is in 'm/N' and its imaginary part in 'um/N'"), std::string::npos);
  expectRight(import(frfText("f (Hz),Real (m/N),Imag (um/N)\n", row), given));
}

TEST_F(FrfImport, ForceOverResponseIsTurnedIntoResponseOverForce) {
  const auto as = [](const std::function<Complex(double, Complex)>& quantity) {
    return [quantity](double f, Complex h) {
      const Complex v = quantity(kTwoPi * f, h);
      return cells({f, v.real(), v.imag()});
    };
  };
  const Complex i(0.0, 1.0);
  const auto stiffness =
      import(frfText("f (Hz),Real (N/um),Imag (N/um)\n", as([](double, Complex h) { return 1e-6 / h; })));
  expectRight(stiffness);
  ASSERT_EQ(stiffness->remarks.size(), 1u);
  EXPECT_NE(text(stiffness->remarks[0]).find("turned into response over force"), std::string::npos);
  expectRight(import(frfText("f (Hz),Real (N/m),Imag (N/m)\n", as([](double, Complex h) { return 1.0 / h; }))));
  const auto mass = [](double w, Complex h) { return w > 0.0 ? 1.0 / (-w * w * h) : Complex(1.0, 0.0); };
  expectRight(import(frfText("f (Hz),Real (kg),Imag (kg)\n", as(mass))));
  expectRight(import(frfText("f (Hz),Real (N/(m/s^2)),Imag (N/(m/s^2))\n", as(mass))));
  expectRight(import(frfText("f (Hz),Real (N s/m),Imag (N s/m)\n", as([i](double w, Complex h) {
                               return w > 0.0 ? 1.0 / (i * w * h) : Complex(1.0, 0.0);
                             }))));
}

TEST_F(FrfImport, TwoResponsesUnderOneNameAreAskedAbout) {
  const std::string file = frfText("f (Hz),Real (m/N),Imag (m/N),Real (m/N),Imag (m/N)\n", [](double f, Complex h) {
    return cells({f, h.real(), h.imag(), 0.1 * h.real(), 0.1 * h.imag()});
  });
  const auto asked = import(file);
  ASSERT_FALSE(asked.ok());
  EXPECT_NE(asked.error().line().find("holds 2 responses: '1', '2'"), std::string::npos) << asked.error().line();
  const auto pandas =
      import(frfText("f (Hz),Real (m/N),Imag (m/N),Real (m/N).1,Imag (m/N).1\n", [](double f, Complex h) {
        return cells({f, h.real(), h.imag(), h.real(), h.imag()});
      }));
  ASSERT_FALSE(pandas.ok());
  EXPECT_NE(pandas.error().line().find("holds 2 responses: '1', '2'"), std::string::npos) << pandas.error().line();
  ImportOptions given = options();
  given.responses = {"1"};
  given.axes = {Axis::Y};
  const auto first = import(file, given);
  expectRight(first);
  EXPECT_EQ(frfOf(first).axis, Axis::Y);
}

TEST_F(FrfImport, ACrossResponseIsTakenWhereOneIsWanted) {
  ImportOptions cross = options();
  cross.cross = true;
  const auto scaled = [](double a, double b) {
    return [a, b](double f, Complex h) { return cells({f, a * h.real(), a * h.imag(), b * h.real(), b * h.imag()}); };
  };
  expectRight(import(frfText("f (Hz),Re Gxx (m/N),Im Gxx (m/N),Re Gxy (m/N),Im Gxy (m/N)\n", scaled(9.0, 1.0)), cross));
  const auto row = [](double f, Complex h) { return cells({f, h.real(), h.imag()}); };
  expectRight(import(frfText("f (Hz),Re Gyx (m/N),Im Gyx (m/N)\n", row), cross));
  expectRight(import(frfText("f (Hz),Re (m/N),Im (m/N)\n", row), cross));
  const auto direct = import(frfText("f (Hz),Re Gxx (m/N),Im Gxx (m/N)\n", row), cross);
  ASSERT_FALSE(direct.ok());
  EXPECT_NE(direct.error().line().find("holds no response along one axis to a force along the other"),
            std::string::npos);
}

TEST_F(FrfImport, FrequenciesWrittenAsComplexNumbersAreFrequencies) {
  ImportOptions given = options();
  given.unit = "m/N";
  expectRight(import(frfText("",
                             [](double f, Complex h) {
                               char line[120];
                               std::snprintf(line, sizeof line, " (%.6e+0.0e+00j)  (%.9e+%.9ej)", f, h.real(),
                                             h.imag());
                               return std::string(line);
                             }),
                     given));
}

TEST_F(FrfImport, LinesWithoutAValueAtZeroHertzAreLeftOut) {
  const auto got = import(frfText("f (Hz),Re (m/N),Im (m/N)\n", [](double f, Complex h) {
    return f == 0.0 ? std::string("0.0,nan,nan") : cells({f, h.real(), h.imag()});
  }));
  expectRight(got);
  EXPECT_NE(text(got->remarks.at(0)).find("1 rows without a finite value are left out"), std::string::npos);
}

TEST_F(FrfImport, OptionsOverruleTheFile) {
  ImportOptions given = options();
  given.kind = MeasurementKind::Frf;
  given.unit = "mm/N";
  given.frequencyUnit = "kHz";
  const auto scaled = [](double f, Complex h) { return cells({1e-3 * f, 1e3 * h.real(), 1e3 * h.imag()}); };
  expectRight(import(frfText("Frequency [Hz],Real [m/N],Imag [m/N]\n", scaled), given));
  given.quantity = FrfQuantity::Mobility;
  given.scale = 1e-3;
  const auto got = import("1 5 5\n2 6 6\n", given);
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_EQ(frfOf(got).quantity, FrfQuantity::Mobility);
  EXPECT_DOUBLE_EQ(frfOf(got).value[0].real(), 5e-3);
  given.scale = 0.0;
  EXPECT_FALSE(import("1 5 5\n2 6 6\n", given).ok());
}

TEST_F(FrfImport, ComplexVectorsOfMatlabFilesAreResponses) {
  const std::string path = folder_ / "frf.mat";
  mat_t* mat = Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5);
  ASSERT_NE(mat, nullptr);
  std::vector<double> f, re, im;
  for (int i = 0; i <= 200; ++i) {
    f.push_back(5.0 * i);
    re.push_back(1e3 * compliance(5.0 * i).real());
    im.push_back(1e3 * compliance(5.0 * i).imag());
  }
  std::size_t dims[2] = {f.size(), 1};
  mat_complex_split_t split{re.data(), im.data()};
  std::size_t unitDims[2] = {1, 4};
  std::string unit = "mm/N";
  matvar_t* made[] = {Mat_VarCreate("f", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, f.data(), 0),
                      Mat_VarCreate("H", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, &split, MAT_F_COMPLEX),
                      Mat_VarCreate("H_unit", MAT_C_CHAR, MAT_T_UTF8, 2, unitDims, unit.data(), 0)};
  for (matvar_t* variable : made) {
    ASSERT_EQ(Mat_VarWrite(mat, variable, MAT_COMPRESSION_NONE), 0);
    Mat_VarFree(variable);
  }
  Mat_Close(mat);
  expectRight(importMeasurement(path, options()));
}

TEST_F(FrfImport, AStructOfAMatlabFileIsLookedInto) {
  const std::string path = folder_ / "struct.mat";
  mat_t* mat = Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5);
  ASSERT_NE(mat, nullptr);
  std::vector<double> f, re, im;
  for (int i = 0; i <= 200; ++i) {
    f.push_back(5.0 * i);
    re.push_back(1e3 * compliance(5.0 * i).real());
    im.push_back(1e3 * compliance(5.0 * i).imag());
  }
  std::size_t dims[2] = {f.size(), 1}, one[2] = {1, 1}, unitDims[2] = {1, 4};
  mat_complex_split_t split{re.data(), im.data()};
  std::string unit = "mm/N";
  const char* names[] = {"f", "H", "H_unit"};
  matvar_t* inner = Mat_VarCreateStruct("frf", 2, one, names, 3);
  Mat_VarSetStructFieldByName(inner, "f", 0, Mat_VarCreate("f", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, f.data(), 0));
  Mat_VarSetStructFieldByName(inner, "H", 0,
                              Mat_VarCreate("H", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, &split, MAT_F_COMPLEX));
  Mat_VarSetStructFieldByName(inner, "H_unit", 0,
                              Mat_VarCreate("H_unit", MAT_C_CHAR, MAT_T_UTF8, 2, unitDims, unit.data(), 0));
  const char* outerNames[] = {"frf"};
  matvar_t* outer = Mat_VarCreateStruct("tap", 2, one, outerNames, 1);
  Mat_VarSetStructFieldByName(outer, "frf", 0, inner);
  ASSERT_EQ(Mat_VarWrite(mat, outer, MAT_COMPRESSION_NONE), 0);
  Mat_VarFree(outer);
  Mat_Close(mat);
  expectRight(importMeasurement(path, options()));
}

TEST_F(FrfImport, BadFilesAreOneClearLine) {
  const auto back = import("1 1 1\n3 1 1\n2 1 1\n");
  ASSERT_FALSE(back.ok());
  EXPECT_NE(back.error().line().find("the frequency does not rise at row 3"), std::string::npos) << back.error().line();
  EXPECT_FALSE(importMeasurement("/nowhere/at.all", options()).ok());
  EXPECT_FALSE(importMeasurement("/", options()).ok());
  EXPECT_FALSE(import("a tool of 12 mm\nnothing else\n").ok());
}

TEST(Compliance, MobilityAndAcceleranceBecomeCompliance) {
  Frf frf;
  frf.quantity = FrfQuantity::Accelerance;
  frf.frequency = {0.0, 10.0};
  const double w = kTwoPi * 10.0;
  frf.value = {1.0, -w * w * 2e-6};
  const Frf compliance = toCompliance(frf);
  ASSERT_EQ(compliance.frequency.size(), 1u);  // 0 Hz cannot be integrated
  EXPECT_NEAR(std::abs(compliance.value[0] - 2e-6), 0.0, 1e-18);
  frf.quantity = FrfQuantity::Mobility;
  frf.value[1] = std::complex<double>(0.0, w * 3e-6);
  EXPECT_NEAR(std::abs(toCompliance(frf).value[0] - 3e-6), 0.0, 1e-18);
}

}  // namespace
}  // namespace stillcut::identify
