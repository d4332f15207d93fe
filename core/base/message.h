// Message: what happened, as a code and its arguments. The code is the English form itself, a literal with places
// %1 .. %9, as a message catalogue has it; nothing ever looks for a form in a finished text. The text is made at the
// edge: text() in English for files and the command line, the screens translate by the form (ui/base/say.h).
// Made at set-up and on the threads of devices and files, never on the sample path: see Reason for that. Any thread.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace stillcut {

struct Message {
  struct Argument;

  std::string form;                 // English, with a place for each argument; empty: nothing is said
  std::vector<Argument> arguments;  // in the order of their places

  Message() = default;
  Message(std::string englishForm, std::vector<Argument> values);

  bool empty() const { return form.empty(); }
  friend bool operator==(const Message&, const Message&) = default;
};

// What is echoed (a key, a value, the name of a file or a device, what a library says) stays as it is in every
// language; messages are translated.
struct Message::Argument {
  std::string verbatim;
  std::vector<Message> messages;  // instead of verbatim; several are joined by `separator`
  std::string_view separator = ", ";

  Argument() = default;
  Argument(std::string text) : verbatim(std::move(text)) {}
  Argument(std::string_view text) : verbatim(text) {}
  Argument(const char* text) : verbatim(text) {}
  template <std::integral Number>
  requires(!std::same_as<Number, char> && !std::same_as<Number, bool>) Argument(Number number)
      : verbatim(std::to_string(number)) {}
  Argument(Message message) { messages.push_back(std::move(message)); }
  Argument(std::vector<Message> list, std::string_view between = ", ")
      : messages(std::move(list)), separator(between) {}

  bool empty() const { return verbatim.empty() && messages.empty(); }
  friend bool operator==(const Argument& a, const Argument& b) {
    return a.verbatim == b.verbatim && a.messages == b.messages;
  }
};

inline Message::Message(std::string englishForm, std::vector<Argument> values)
    : form(std::move(englishForm)), arguments(std::move(values)) {}

// The literal of a message, checked when it is compiled: the places %1 .. %N are all there, and no other.
template <std::size_t Arguments>
struct MessageForm {
  const char* text;

  template <std::size_t N>
  consteval MessageForm(const char (&literal)[N]) : text(literal) {
    std::array<bool, 10> found{};
    for (std::size_t k = 0; k + 1 < N; ++k) {
      if (literal[k] != '%' || literal[k + 1] < '1' || literal[k + 1] > '9') continue;
      const auto place = static_cast<std::size_t>(literal[k + 1] - '0');
      if (place > Arguments) throw "the form has a place without an argument";
      found[place] = true;
    }
    for (std::size_t place = 1; place <= Arguments; ++place) {
      if (!found[place]) throw "an argument has no place in the form";
    }
  }
};

// message("column %1 holds %2", name, value). translations/update collects the forms from these calls, so that the
// first argument is always a literal.
template <class... Values>
Message message(std::type_identity_t<MessageForm<sizeof...(Values)>> form, Values&&... values) {
  return {form.text, {Message::Argument(std::forward<Values>(values))...}};
}

// A text that no code of ours made (what the system says of errno, what a library says), as a message of its own. The
// screens translate it where translations/foreign_texts lists it, and else show it as it is.
Message foreign(std::string text);

// In English, as it is. An empty message is an empty text.
std::string text(const Message& message);
std::string text(const Message::Argument& argument);
std::string text(const std::vector<Message>& messages, std::string_view separator = "; ");

}  // namespace stillcut
