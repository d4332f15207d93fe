#include "core/base/message.h"

#include "core/base/result.h"

namespace stillcut {

Message foreign(std::string text) {
  return {std::move(text), {}};
}

std::string text(const Message::Argument& argument) {
  return argument.messages.empty() ? argument.verbatim : text(argument.messages, argument.separator);
}

std::string text(const Message& message) {
  std::string out;
  const std::string& form = message.form;
  for (std::size_t k = 0; k < form.size(); ++k) {
    const char next = k + 1 < form.size() ? form[k + 1] : ' ';
    const auto place = static_cast<std::size_t>(next - '1');
    if (form[k] != '%' || next < '1' || place >= message.arguments.size()) {
      out += form[k];
      continue;
    }
    out += text(message.arguments[place]);
    ++k;
  }
  return out;
}

std::string text(const std::vector<Message>& messages, std::string_view separator) {
  std::string out;
  for (const Message& message : messages) {
    if (!out.empty()) out += separator;
    out += text(message);
  }
  return out;
}

Message Error::asMessage() const {
  if (where.empty()) return why.empty() ? what : message("%1 (%2)", what, why);
  return why.empty() ? message("%1: %2", where, what) : message("%1: %2 (%3)", where, what, why);
}

}  // namespace stillcut
