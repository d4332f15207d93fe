// Whether a vibration ended faster than anything that vibrates can. A mode of frequency f and damping z rings down by
// 54.6 z f dB a second: 5 dB in a millisecond at 2 kHz and 5 %, which is much for a tool. From within 10 dB of what it
// was to below 30 dB in the second millisecond after that is twice as fast and more: a cable that broke, not a tool
// that left. A millisecond is looked at without its mean, which the filters before it let go of slowly. Thread: any;
// real-time.
#pragma once

#include <span>

namespace stillcut::detect {

// Two windows one after the other, the second far quieter; `hop` frames are a millisecond. False as well where a
// millisecond has fewer than 8 frames.
bool endsAbruptly(std::span<const double> before, std::span<const double> now, int hop) noexcept;

}  // namespace stillcut::detect
