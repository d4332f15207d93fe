// One number from text as instruments write it: three-digit exponents, Fortran's D exponent or an exponent without its
// letter ("1.5-103"), and fields that touch ("-1.0E-003-2.0E-003"). Independent of the locale. Pure: any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stillcut::uff {

// Reads the number `text` begins with (no leading blanks) and removes it. Empty when there is none. NaN and infinity
// written as words are returned as such: the caller knows what to say about them.
std::optional<double> takeNumber(std::string_view& text);

// The whole of `text`, blanks around it aside, is one number.
std::optional<double> wholeNumber(std::string_view text);

std::string_view trimmed(std::string_view text);

// Next line without its end (LF or CR LF), removed from `rest`.
std::string_view takeLine(std::string_view& rest);

// Text of the file made fit for a one-line message: printable ASCII, at most 40 characters.
std::string printable(std::string_view text);

}  // namespace stillcut::uff
