// The one door of a Vamp library: the host asks for its plugins by number.

#include <vamp-sdk/PluginAdapter.h>
#include <vamp/vamp.h>

#include "app/vamp/chatter_plugin.h"

extern "C" const VampPluginDescriptor* vampGetPluginDescriptor(unsigned int version, unsigned int index) {
  static Vamp::PluginAdapter<stillcut::app::ChatterPlugin> chatter;
  return version >= 1 && index == 0 ? chatter.getDescriptor() : nullptr;
}
