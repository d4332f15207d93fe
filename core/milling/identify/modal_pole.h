// What a modal fit looks for first: where a mode lies and how it decays. Plain values: any thread.
#pragma once

namespace stillcut::identify {

struct ModalPole {
  double frequency = 0.0;  // undamped natural frequency [Hz]
  double damping = 0.0;    // ratio
};

}  // namespace stillcut::identify
