// Result: a value, or one clear line about what went wrong, where, and why. Used on the set-up path (files, settings,
// devices); never on the sample path, where a fault is a value in Verdict, OverrideRequest, MachineState. Any thread.
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "core/base/message.h"

namespace stillcut {

struct Error {
  Message::Argument where;  // file and place ("cut.csv:12"), key, device: as they are; or a message
  Message what;             // what is wrong: message("column '%1' holds '%2'", ...)
  Message why = {};         // cause or remedy; may be empty

  // "where: what (why)", one line, in English.
  std::string line() const { return text(asMessage()); }
  // The same as one message, for whoever passes it on or translates it.
  Message asMessage() const;
};

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }
  T& value() & { return std::get<0>(state_); }
  const T& value() const& { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  T* operator->() { return &std::get<0>(state_); }
  const T* operator->() const { return &std::get<0>(state_); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  const Error& error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

struct Done {};
using Status = Result<Done>;

}  // namespace stillcut
