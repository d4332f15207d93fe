// What several devices say in the same words (Error: what and why; a warning). Thread: set-up and the device's own.
#pragma once

#include "core/base/message.h"

namespace stillcut::daq {

// Of a device that neither counts its samples nor stamps them (sample_clock.h has the limits).
inline Message uncounted() {
  return message(
      "the device counts nothing: a loss of less than 30 ms or three blocks does not show, a longer one after a second "
      "or two");
}
inline Message uncalibrated() {
  return message("the card is not calibrated, its volts are nominal; comedi_soft_calibrate calibrates it");
}
inline Message notOpened() {
  return message("cannot be opened");
}
inline Message isItFree() {
  return message("is it there, and free?");
}
inline Message nothingSent() {
  return message("nothing is sent");
}
inline Message doesItStream() {
  return message("does the device stream?");
}
inline Message noSampleInIt() {
  return message("bytes come, and no sample of the [[channels]] is in them");
}
inline Message sameFrames() {
  return message("are format, sync, sample, checksum, baud and the number of channels those of the sender?");
}
inline Message noAnswer() {
  return message("does not answer");
}
inline Message noStream() {
  return message("does not stream");
}
inline Message noStart() {
  return message("does not start");
}
inline Message noInputs() {
  return message("has no inputs that stream");
}
inline Message singleValues() {
  return message("it may read single values only");
}
inline Message onlyShared() {
  return message("it only shares its memory");
}
inline Message notRead() {
  return message("cannot be read");
}
inline Message notTogether() {
  return message("does not take these settings together");
}
inline Message notInOnePiece() {
  return message("has not delivered enough in one piece");
}
inline Message theDevice() {
  return message("the device");
}

}  // namespace stillcut::daq
