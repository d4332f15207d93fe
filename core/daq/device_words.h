// What the devices say that a screen translates, in one line's parts (Error: what and why; a doubt). Parts with numbers
// or names in them stay as they are. Any thread.
#pragma once

#include <array>

namespace stillcut::daq {

// The doubt of a device that neither counts its samples nor stamps them (sample_clock.h has the limits).
inline constexpr const char* kUncounted =
    "the device counts nothing: a loss of less than 30 ms or three blocks does not show, a longer one after a second "
    "or two";
inline constexpr const char* kUncalibrated =
    "the card is not calibrated, its volts are nominal; comedi_soft_calibrate calibrates it";
inline constexpr const char* kNotOpened = "cannot be opened";
inline constexpr const char* kIsItFree = "is it there, and free?";
inline constexpr const char* kNothingSent = "nothing is sent";
inline constexpr const char* kDoesItStream = "does the device stream?";
inline constexpr const char* kNoSampleInIt = "bytes come, and no sample of the [[channels]] is in them";
inline constexpr const char* kSameFrames =
    "are format, sync, sample, checksum, baud and the number of channels those of the sender?";
inline constexpr const char* kNoAnswer = "does not answer";
inline constexpr const char* kNoStream = "does not stream";
inline constexpr const char* kNoStart = "does not start";
inline constexpr const char* kNoInputs = "has no inputs that stream";
inline constexpr const char* kSingleValues = "it may read single values only";
inline constexpr const char* kOnlyShared = "it only shares its memory";
inline constexpr const char* kNotRead = "cannot be read";
inline constexpr const char* kNotTogether = "does not take these settings together";
inline constexpr const char* kNotInOnePiece = "has not delivered enough in one piece";
inline constexpr const char* kTheDevice = "the device";

inline constexpr std::array kDeviceWords{kUncounted,    kUncalibrated,  kNotOpened,    kIsItFree,   kNothingSent,
                                         kDoesItStream, kNoSampleInIt,  kSameFrames,   kNoAnswer,   kNoStream,
                                         kNoStart,      kNoInputs,      kSingleValues, kOnlyShared, kNotRead,
                                         kNotTogether,  kNotInOnePiece, kTheDevice};

}  // namespace stillcut::daq
