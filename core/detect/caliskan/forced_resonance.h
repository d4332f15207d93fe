// Forced vibration on a resonance: a harmonic of the tooth passing that meets a mode. It shakes the cut as chatter
// does, and no other speed than one that moves the harmonic off the mode helps; but it neither grows nor leaves its
// order. Forces of tooth passing fall off from harmonic to harmonic, and so does the velocity of a structure that is
// not at resonance; one that stands out of both its neighbours by 6 dB and holds most of the forced vibration is a
// resonance. The first harmonic is the largest anyway and is not called one. Thread: worker; everything real-time.
#pragma once

#include "core/detect/caliskan/energy_chain.h"

namespace stillcut::detect {

class ForcedResonance {
 public:
  // eta: of the energy ratio's weights (Caliskan 2018 eq. 28), which make a velocity of the signal.
  void prepare(int teeth, int eta);
  void reset();
  // One hop: what the harmonic filter holds of a channel.
  void endHop(const EnergyChain& chain, int channel);
  // It has stood out for some turns.
  bool stands() const { return part_ > kStands; }

 private:
  static constexpr double kStands = 0.7;
  bool standsOut(const EnergyChain& chain, int channel) const;

  int teeth_ = 0;
  int eta_ = 0;
  double part_ = 0.0;  // of the last turns in which it stood out
};

}  // namespace stillcut::detect
