// How a long computation notices a stop in time. Before each piece of work it says how many operations that takes
// (multiplications and additions, roughly; a core does 0.5 to 3 of them in a nanosecond), and it cuts its work so that
// no piece is larger than kLargestPiece: a stop request is then met within some 20 ms on a slow core. That the pieces
// are small is tested by counting, not by a clock.
// Thread: one meter belongs to one thread; the stop may be asked for from any.
#pragma once

#include <algorithm>
#include <stop_token>
#include <utility>

namespace stillcut::milling {

class WorkMeter {
 public:
  static constexpr double kLargestPiece = 1e7;

  explicit WorkMeter(std::stop_token stop = {}) : stop_(std::move(stop)) {}

  // To be asked before a piece of work; false: a stop was asked for, leave it and whatever follows.
  [[nodiscard]] bool proceed(double operations) {
    total_ += operations;
    largest_ = std::max(largest_, operations);
    return !stopped();
  }
  bool stopped() const { return stop_.stop_requested(); }
  double total() const { return total_; }
  double largestPiece() const { return largest_; }

 private:
  std::stop_token stop_;
  double total_ = 0.0;
  double largest_ = 0.0;
};

}  // namespace stillcut::milling
