// Files as loggers, oscilloscopes and people's scripts leave them: what they say of rate and time is taken as it is
// said, and what is unclear is asked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>

#include "core/storage/hdf5_file.h"
#include "tests/support/read_all.h"
#include "tests/support/temp_folder.h"
#include "tests/support/zip_archive.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

class FieldFiles : public testing::Test {
 protected:
  WholeRecording read(const std::string& content, const std::string& name = "cut.csv",
                      const ReadOptions& options = {}) {
    return readAll(folder_.file(name, content), options);
  }
  std::string notesOf(const WholeRecording& all) {
    std::string lines;
    for (const Message& note : all.format.notes) lines += text(note) + "\n";
    return lines;
  }
  TempFolder folder_;
};

std::string rows(int count, const std::function<std::string(int)>& row) {
  std::string lines;
  for (int i = 0; i < count; ++i) lines += row(i) + "\n";
  return lines;
}

std::string figure(double value, int digits, char decimal = '.') {
  char out[40];
  std::snprintf(out, sizeof out, "%.*f", digits, value);
  std::string number(out);
  for (char& c : number) c = c == '.' ? decimal : c;
  return number;
}

std::string sine(int i, char decimal = '.') {
  return figure(std::sin(0.3 * i), 4, decimal);
}

TEST_F(FieldFiles, ARateThatCouldBeReadInTwoWaysIsAsked) {
  const auto german = rows(60, [](int i) { return sine(i, ',') + ";" + sine(i + 5, ','); });
  EXPECT_THAT(read("Abtastrate;102.400 Hz\nX;Y\n" + german).error, HasSubstr("not clear whether the rate '102.400'"));
  EXPECT_EQ(read("Abtastrate;51,2 kHz\nX;Y\n" + german).format.rate.value, 51'200.0);
  ReadOptions given;
  given.rate = Hertz(102'400.0);
  EXPECT_EQ(read("Abtastrate;102.400 Hz\nX;Y\n" + german, "cut.csv", given).error, "");
  const auto english = rows(60, [](int i) { return sine(i) + "," + sine(i + 5); });
  EXPECT_EQ(read("# Sampling rate: 10,000 Hz\nx,y\n" + english).format.rate.value, 10'000.0);
}

TEST_F(FieldFiles, RatesInTheWordsOfManyPrograms) {
  const std::pair<const char*, const char*> headers[] = {{"XInc:,1.0000E-04\nXOrg:,-4.5\n", ","},
                                                         {"# ODR: 10000 Hz\nx,y\n", ","},
                                                         {"Interval;0,1 ms\nX;Y\n", ";"},
                                                         {"\"Sampling\",\"10000 samples/s\"\nx,y\n", ","},
                                                         {"# {\"sample_rate\": 10000, \"unit\": \"g\"}\nx,y\n", ","},
                                                         {"#CLOCK=100.0uS\nx,y\n", ","},
                                                         {"Sample rate (S/min);600000\nX;Y\n", ";"}};
  for (const auto& [header, delimiter] : headers) {
    const char decimal = std::string(header).starts_with("Interval") ? ',' : '.';
    const WholeRecording all = read(header + rows(60, [&, d = std::string(delimiter)](int i) {
                                      return sine(i, decimal) + d + sine(i + 5, decimal);
                                    }));
    EXPECT_EQ(all.error, "") << header;
    EXPECT_NEAR(all.format.rate.value, 10'000.0, 1e-6) << header;
    EXPECT_EQ(all.values.empty() ? 0U : all.values[0].size(), 60U) << header;
  }
}

TEST_F(FieldFiles, ARateBelowTheRows) {
  const WholeRecording all = read("X (g),Y (g)\n" + rows(60, [](int i) { return sine(i) + "," + sine(i + 5); }) +
                                  "Sampling rate,10000\nSamples,60\n");
  ASSERT_EQ(all.error, "");
  EXPECT_EQ(all.format.rate.value, 10'000.0);
  EXPECT_EQ(all.values[0].size(), 60U);
}

TEST_F(FieldFiles, TheUnitOfTimeIsFoundInItsName) {
  for (const char* name : {"t/ms", "Zeit/ms", "Time.ms", "timeMs", "TIME_MS", "\"Time, ms\"", "in ms",
                           "Time (millisec)", "time_ms", "Zeit in ms"}) {
    const WholeRecording all = read(std::string(name) + ",ax,ay\n" + rows(60, [](int i) {
                                      return figure(0.005 * i, 3) + "," + sine(i) + "," + sine(i + 5);
                                    }));
    EXPECT_EQ(all.error, "") << name;
    EXPECT_NEAR(all.format.rate.value, 200'000.0, 1e-6) << name;
    EXPECT_TRUE(all.format.notes.empty()) << name << notesOf(all);
    EXPECT_EQ(all.values.size(), 2U) << name;
  }
}

TEST_F(FieldFiles, SecondsThatAreOnlyAssumedAreTold) {
  const WholeRecording all = read("time,ax\n" + rows(60, [](int i) { return figure(0.005 * i, 3) + "," + sine(i); }));
  EXPECT_NEAR(all.format.rate.value, 200.0, 1e-9);
  EXPECT_THAT(notesOf(all), HasSubstr("seconds are assumed"));
}

template <class T>
std::string npy(const std::string& type, const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  const std::string shape = values.size() == 1 ? "()" : "(" + std::to_string(values.size()) + ",)";
  const std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }\n";
  return std::string("\x93NUMPY\x01\x00", 8) + word(header.size(), 2) + header + bytes;
}

TEST_F(FieldFiles, TimesOfArraysHaveTheirUnitInTheirNameOrInTheirSize) {
  std::vector<double> x(500), ms(500);
  std::vector<std::int64_t> ns(500);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::sin(0.3 * static_cast<double>(i));
    ms[i] = 0.005 * static_cast<double>(i);
    ns[i] = 1'764'144'000'000'000'001 + 500 * static_cast<std::int64_t>(i);
  }
  const auto archive = [&](const std::string& name, const std::string& times) {
    return read(zip({{"x.npy", npy("<f8", x)}, {name + ".npy", times}}, false), "cut.npz");
  };
  EXPECT_NEAR(archive("t_ms", npy("<f8", ms)).format.rate.value, 200'000.0, 1e-6);
  EXPECT_NEAR(archive("timestamp", npy("<i8", ns)).format.rate.value, 2e6, 1e-3);
  EXPECT_NEAR(archive("time", npy("<M8[ns]", ns)).format.rate.value, 2e6, 1e-3);
  EXPECT_NEAR(archive("sr_khz", npy("<f8", std::vector<double>{10.0})).format.rate.value, 10'000.0, 1e-9);
  const WholeRecording untold = archive("time", npy("<f8", ms));
  EXPECT_NEAR(untold.format.rate.value, 200.0, 1e-6);
  EXPECT_THAT(notesOf(untold), HasSubstr("seconds are assumed"));
}

TEST_F(FieldFiles, OneSampleThatIsNoNumberIsAGap) {
  std::vector<double> x(500, 1.0), y(500, 2.0);
  x[300] = NAN;
  const WholeRecording all =
      read(zip({{"x.npy", npy("<f8", x)}, {"y.npy", npy("<f8", y)}, {"fs.npy", npy("<f8", std::vector<double>{1e4})}},
               false),
           "cut.npz");
  ASSERT_EQ(all.error, "");
  EXPECT_EQ(all.values[1].size(), 499U);
  std::fill(x.begin() + 100, x.begin() + 300, NAN);
  const auto torn = zip(
      {{"x.npy", npy("<f8", x)}, {"y.npy", npy("<f8", y)}, {"fs.npy", npy("<f8", std::vector<double>{1e4})}}, false);
  EXPECT_THAT(read(torn, "cut.npz").error, HasSubstr("is not a finite number"));
}

TEST_F(FieldFiles, ThousandsAtThePeaksAreNoGaps) {
  const auto check = [this](const std::string& content) {
    const WholeRecording all = read(content);
    ASSERT_EQ(all.error, "");
    ASSERT_EQ(all.values[0].size(), 60U);
    EXPECT_NEAR(all.values[0][10], -1023.11, 1e-3);
    EXPECT_NEAR(all.values[0][11], 7.5, 1e-6);
  };
  const auto table = [](const std::string& header, const std::string& peak, const std::string& delimiter,
                        char decimal) {
    return header + rows(60, [&](int i) {
             return figure(1e-4 * i, 4, decimal) + delimiter + (i == 10 ? peak : figure(7.5, 2, decimal));
           });
  };
  check(table("Time (s),x (N)\n", "\"-1,023.11\"", ",", '.'));
  check(table("Zeit (s);x (N)\n", "-1.023,11", ";", ','));
  check(table("Zeit (s);x (N)\n",
              "-1\xE2\x80\xAF"
              "023,11",
              ";", ','));
  check(table("Zeit (s);x (N)\n", "-1'023.11", ";", '.'));
}

TEST_F(FieldFiles, HeadersOfOscilloscopesAndDataLoggers) {
  const auto row = [](int i) { return figure(1e-4 * i, 4) + "," + sine(i) + "," + sine(i + 5); };
  const WholeRecording rigol = read("Time(s),CH1(V),CH2(V),t0 = -4.5s, tInc = 0.0001,\n" + rows(60, row));
  EXPECT_EQ(rigol.error, "");
  EXPECT_EQ(rigol.values.size(), 2U);
  const WholeRecording owon = read("Unit:(ms)\n ,CH1_Voltage(mV),CH2_Voltage(mV)\n" + rows(60, [](int i) {
                                     return figure(0.1 * i, 2) + "," + sine(i) + "," + sine(i + 5);
                                   }));
  EXPECT_EQ(owon.error, "");
  EXPECT_NEAR(owon.format.rate.value, 10'000.0, 1e-6);
  const WholeRecording campbell = read(
      "TOA5,CR6,1\n\"TIMESTAMP\",\"RECORD\",\"ax\",\"ay\"\n\"TS\",\"RN\",\"m/s2\",\"m/"
      "s2\"\n\"\",\"\",\"Smp\",\"Smp\"\n" +
      rows(60, [](int i) {
        return "\"2026-11-25 10:11:12." + figure(1e-4 * i, 6).substr(2) + "\"," + std::to_string(i) + "," + sine(i) +
               "," + sine(i + 5);
      }));
  EXPECT_EQ(campbell.error, "");
  ASSERT_EQ(campbell.format.channels.size(), 2U);
  EXPECT_EQ(campbell.format.channels[0].info.name, "ax");
  const WholeRecording keyed =
      read("Kanal;Time;A1;A2\nEinheit;ms;g;g\nNr;0;1;2\n" +
           rows(60, [](int i) { return ";" + figure(0.1 * i, 1, ',') + ";" + sine(i, ',') + ";" + sine(i + 5, ','); }));
  EXPECT_EQ(keyed.error, "");
  EXPECT_NEAR(keyed.format.rate.value, 10'000.0, 1e-6);
  ASSERT_EQ(keyed.format.channels.size(), 2U);
  EXPECT_EQ(keyed.format.channels[0].info.name, "A1");
  EXPECT_EQ(keyed.values[0].size(), 60U);
  const WholeRecording famos =
      read("Name\tax\tay\nX-Einheit\ts\ts\nY-Einheit\tm/s2\tm/s2\nx0\t0\t0\ndx\t0,0001\t0,0001\nWerte\t60\t60\n" +
           rows(60, [](int i) { return "\t" + sine(i, ',') + "\t" + sine(i + 5, ','); }));
  EXPECT_EQ(famos.error, "");
  EXPECT_NEAR(famos.format.rate.value, 10'000.0, 1e-6);
  EXPECT_EQ(famos.values.empty() ? 0U : famos.values[0].size(), 60U);
  const WholeRecording twins = read("time (s)\tY[0]\tY[1]\n" + rows(60, [](int i) {
                                      return figure(1e-4 * i, 4) + "\t" + sine(i) + "\t" + sine(i + 5);
                                    }));
  ASSERT_EQ(twins.format.channels.size(), 2U);
  EXPECT_EQ(twins.format.channels[0].info.name, "Y[0]");
  EXPECT_EQ(twins.format.channels[1].info.name, "Y[1]");
}

TEST_F(FieldFiles, LogsOfArduino) {
  ReadOptions rate;
  rate.rate = Hertz(1000.0);
  const WholeRecording plotter =
      read(rows(60, [](int i) { return "ax:" + sine(i) + " ay:" + sine(i + 5); }), "cut.log", rate);
  ASSERT_EQ(plotter.error, "");
  ASSERT_EQ(plotter.format.channels.size(), 2U);
  EXPECT_EQ(plotter.format.channels[1].info.name, "ay");
  EXPECT_NEAR(plotter.values[0][10], std::sin(3.0), 1e-4);
  const WholeRecording monitor = read(
      rows(60,
           [](int i) { return "10:11:12." + figure(1e-3 * i, 3).substr(2) + " -> " + sine(i) + "," + sine(i + 5); }),
      "cut.log");
  ASSERT_EQ(monitor.error, "");
  EXPECT_NEAR(monitor.format.rate.value, 1000.0, 1e-6);
  EXPECT_EQ(monitor.format.channels.size(), 2U);
  const WholeRecording scope =
      read("Time,Osc Ch 1\n" + rows(60, [](int i) { return figure(1e-4 * i, 6) + "s," + sine(i) + "V"; }));
  ASSERT_EQ(scope.error, "");
  EXPECT_NEAR(scope.format.rate.value, 10'000.0, 1e-6);
  EXPECT_EQ(scope.format.channels[0].unit, "V");
}

TEST_F(FieldFiles, TimeStampsInMoreForms) {
  for (const char* form : {"20261125T235958.%s", "2026-11-25 23:59:58.%s UTC", "25.11.26 23:59:58.%s"}) {
    const WholeRecording all = read("time;a (g);b (g)\n" + rows(60, [&](int i) {
                                      std::string stamp(form);
                                      stamp.replace(stamp.find("%s"), 2, figure(1e-4 * i, 6).substr(2));
                                      return stamp + ";" + sine(i) + ";" + sine(i + 5);
                                    }));
    EXPECT_EQ(all.error, "") << form;
    EXPECT_NEAR(all.format.rate.value, 10'000.0, 1e-3) << form;
  }
}

TEST_F(FieldFiles, StampsCoarserThanTheRowsLeaveTheRateToTheHeader) {
  const auto table = rows(600, [](int i) {
    return "11/25/2026 11:59:" + std::string(i < 300 ? "58" : "59") + " PM," + sine(i) + "," + sine(i + 5);
  });
  const WholeRecording all = read("\"Sample Rate:\",\"300\"\n\"Date/Time\",\"CH0\",\"CH1\"\n" + table);
  ASSERT_EQ(all.error, "");
  EXPECT_EQ(all.format.rate.value, 300.0);
  EXPECT_EQ(all.values[0].size(), 600U);
  EXPECT_THAT(notesOf(all), HasSubstr("too coarse"));
  EXPECT_THAT(read("\"Date/Time\",\"CH0\",\"CH1\"\n" + table).error, HasSubstr("does not grow"));
}

TEST_F(FieldFiles, WhatIsNoTableIsQuoted) {
  EXPECT_THAT(read(rows(60, [](int i) { return "{\"t\":" + figure(1e-4 * i, 4) + ",\"x\":" + sine(i) + "}"; })).error,
              HasSubstr("in line 31, '{\"t\":0.0030"));
}

TEST_F(FieldFiles, ALossOfPowerAndOldLineEnds) {
  std::string table = "Time (s),a (g)\n";
  for (int i = 0; i < 900; ++i)
    table += (i >= 700 && i < 710 ? std::string(12, '\0') : figure(1e-4 * i, 4) + "," + sine(i)) + "\n";
  const WholeRecording all = read(table);
  ASSERT_EQ(all.error, "");
  EXPECT_EQ(all.values[0].size(), 890U);
  std::string old = "Time (s),a (g)\r";
  for (int i = 0; i < 9000; ++i) old += figure(1e-4 * i, 4) + "," + sine(i) + "\r";
  EXPECT_EQ(read(old).values.at(0).size(), 9000U);
}

std::string sound(const std::string& path, int format, int frames) {
  SF_INFO info{};
  info.channels = 1;
  info.samplerate = 8000;
  info.format = format;
  SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
  if (file == nullptr) return {};
  std::vector<float> samples(static_cast<std::size_t>(frames));
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = 0.5F * std::sin(0.3F * static_cast<float>(i));
  sf_writef_float(file, samples.data(), frames);
  sf_close(file);
  return path;
}

TEST_F(FieldFiles, AHeaderThatLagsBehindItsSamplesIsNotBelieved) {
  const std::string path = sound(folder_ / "lag.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 20'000);
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(40);
  const std::string size = word(4000, 4);
  file.write(size.data(), 4);
  file.close();
  const WholeRecording all = readAll(path);
  ASSERT_EQ(all.error, "");
  EXPECT_EQ(all.values[0].size(), 20'000U);
  EXPECT_THAT(notesOf(all), HasSubstr("promises 4000 bytes"));
}

TEST_F(FieldFiles, ChunksBehindTheSamplesAreNoSamples) {
  const std::string path = sound(folder_ / "cut.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 20'000);
  std::ofstream file(path, std::ios::binary | std::ios::app);
  file << "LIST" << word(8000, 4) << std::string(8000, 'a');
  file.close();
  EXPECT_EQ(readAll(path).values.at(0).size(), 20'000U);
  std::ofstream(path, std::ios::binary | std::ios::app) << std::string(9000, '\0');
  EXPECT_EQ(readAll(path).values.at(0).size(), 20'000U);
}

TEST_F(FieldFiles, RareSoundFormatsAreKnownByTheirContent) {
  for (const auto& [name, format] : {std::pair{"a.htk", SF_FORMAT_HTK | SF_FORMAT_PCM_16},
                                     {"a.pvf", SF_FORMAT_PVF | SF_FORMAT_PCM_16},
                                     {"a.sds", SF_FORMAT_SDS | SF_FORMAT_PCM_16},
                                     {"a.xi", SF_FORMAT_XI | SF_FORMAT_DPCM_16},
                                     {"a.mat", SF_FORMAT_MAT5 | SF_FORMAT_PCM_16},
                                     {"b.mat", SF_FORMAT_MAT4 | SF_FORMAT_PCM_16}}) {
    const std::string path = sound(folder_ / name, format, 20'000);
    if (path.empty()) continue;
    const WholeRecording all = readAll(path);
    EXPECT_EQ(all.error, "") << name;
    EXPECT_GE(all.values.empty() ? 0U : all.values[0].size(), 20'000U) << name;
  }
}

TEST_F(FieldFiles, ATableThatIsCalledASoundIsRead) {
  const WholeRecording all =
      read("Time (s),a (g)\n" + rows(60, [](int i) { return figure(1e-4 * i, 4) + "," + sine(i); }), "cut.wav");
  ASSERT_EQ(all.error, "");
  EXPECT_THAT(notesOf(all), HasSubstr("whatever its name says"));
}

TEST_F(FieldFiles, MatlabOfVersionFourSaysWhatToDo) {
  const std::string variable = word(0, 4) + word(100, 4) + word(1, 4) + word(0, 4) + word(2, 4) + std::string("x\0", 2);
  EXPECT_THAT(read(variable + std::string(800, '\0'), "cut.mat").error, HasSubstr("version 4"));
}

TEST_F(FieldFiles, RatesInAttributesOfHdf5) {
  const std::string path = folder_ / "cut.h5";
  const auto write = [&](const std::function<void(hid_t file, hid_t x, hid_t y)>& tell) {
    const Hdf5Id file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    const hsize_t length = 500;
    const std::vector<float> values(500, 1.0F);
    const Hdf5Id space(H5Screate_simple(1, &length, nullptr));
    std::vector<Hdf5Id> sets;
    for (const char* name : {"x", "y"}) {
      sets.emplace_back(
          H5Dcreate2(file.get(), name, H5T_NATIVE_FLOAT, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
      H5Dwrite(sets.back().get(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    }
    tell(file.get(), sets[0].get(), sets[1].get());
  };
  write([](hid_t, hid_t x, hid_t y) {
    writeNumber(x, "SampleRate", 10'000.0);
    writeNumber(y, "SampleRate", 10'000.0);
  });
  EXPECT_EQ(readAll(path).format.rate.value, 10'000.0);
  write([](hid_t file, hid_t, hid_t) { writeText(file, "SampleRate", "10000 Hz"); });
  EXPECT_EQ(readAll(path).format.rate.value, 10'000.0);
  write([](hid_t, hid_t x, hid_t y) {
    writeNumber(x, "fs", 10'000.0);
    writeNumber(y, "fs", 5'000.0);
  });
  EXPECT_THAT(readAll(path).error, HasSubstr("several rates"));
}

TEST_F(FieldFiles, WhatIsLeftOutHasItsReason) {
  const WholeRecording all = read("Time (s),a (g),Score,T (degC)\n" +
                                  rows(60, [](int i) { return figure(1e-4 * i, 4) + "," + sine(i) + ",1.5,21.0"; }));
  ASSERT_EQ(all.format.skipped.size(), 2U);
  ASSERT_EQ(all.format.skippedWhy.size(), 2U);
  EXPECT_THAT(text(all.format.skippedWhy[0]), HasSubstr("has no unit"));
  EXPECT_THAT(text(all.format.skippedWhy[1]), HasSubstr("'degC'"));
}

}  // namespace
}  // namespace stillcut::record
