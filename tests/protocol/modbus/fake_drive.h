// A spindle drive on a serial line: a Modbus RTU slave of registers, one question after the other, as slow drives are.
// Its answers come late or not at all, in pieces, with the wrong length, or between other bytes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/support/scripted_wire.h"

namespace stillcut::cnc::testing {

class FakeDrive final : public Peer {
 public:
  std::map<int, int> holding, input;  // by address
  double answersAfter = 0.002;        // [s]
  double late = 0.0;                  // [s], of every lateEvery-th answer
  int lateEvery = 0;
  int loseEvery = 0;     // so many questions are never answered
  bool deaf = false;     // while it is late it does not hear
  bool refuses = false;  // exceptions
  std::string before;    // said before each answer
  std::vector<Instant> asked, answered;
  std::vector<int> writes;  // of register 100

  static std::string closed(const std::string& frame) {
    unsigned sum = 0xFFFF;
    for (const char c : frame) {
      sum ^= static_cast<unsigned char>(c);
      for (int i = 0; i < 8; ++i) sum = (sum & 1) != 0 ? (sum >> 1) ^ 0xA001 : sum >> 1;
    }
    return frame + static_cast<char>(sum & 0xFF) + static_cast<char>(sum >> 8);
  }
  static std::string word(int value) {
    return {static_cast<char>((value >> 8) & 0xFF), static_cast<char>(value & 0xFF)};
  }

  void take(std::string_view bytes, Instant now, const Answer& answer) override {
    if (deaf && now < free_) return;
    heard_ += bytes;
    while (heard_.size() >= 8) {
      const std::string question = heard_.substr(0, 8);
      heard_.erase(0, 8);
      if (closed(question.substr(0, 6)) != question) continue;
      ++questions_;
      asked.push_back(now);
      const bool isLate = lateEvery > 0 && questions_ % lateEvery == 0;
      free_ = std::max(free_, now) + toDuration(Seconds(isLate ? late : answersAfter));
      const std::string said = act(question);
      if (loseEvery > 0 && questions_ % loseEvery == 0) continue;
      answered.push_back(free_);
      answer(before + closed(said), secondsBetween(now, free_).value);
    }
  }

 private:
  static int number(const std::string& s, std::size_t at) {
    return static_cast<unsigned char>(s[at]) * 256 + static_cast<unsigned char>(s[at + 1]);
  }
  std::string act(const std::string& q) {
    const int function = static_cast<unsigned char>(q[1]);
    if (refuses) return {q[0], static_cast<char>(function | 0x80), 2};
    if (function == 6) {
      holding[number(q, 2)] = number(q, 4);
      if (number(q, 2) == 100) writes.push_back(number(q, 4));
      return q.substr(0, 6);
    }
    std::string data;
    for (int i = 0; i < number(q, 4); ++i) data += word((function == 3 ? holding : input)[number(q, 2) + i]);
    return std::string{q[0], q[1], static_cast<char>(data.size())} + data;
  }

  std::string heard_;
  int questions_ = 0;
  Instant free_{};
};

}  // namespace stillcut::cnc::testing
