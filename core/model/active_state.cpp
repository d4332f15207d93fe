#include "core/model/active_state.h"

namespace stillcut {

std::string_view actuatorReleaseText(ActuatorRelease why) {
  switch (why) {
    case ActuatorRelease::None:
      return "";
    case ActuatorRelease::Asked:
      return "released";
    case ActuatorRelease::LeaseOver:
      return "nobody renewed the lease";
    case ActuatorRelease::NotFinite:
      return "a value was not finite";
    case ActuatorRelease::Diverging:
      return "the loop diverged";
    case ActuatorRelease::Saturated:
      return "the actuator was at its end and the vibration grew";
    case ActuatorRelease::Worse:
      return "control made the vibration worse";
    case ActuatorRelease::DeadSensor:
      return "the error sensor stands still";
    case ActuatorRelease::DeviceFault:
      return "the device lost a block";
  }
  return "";
}

}  // namespace stillcut
