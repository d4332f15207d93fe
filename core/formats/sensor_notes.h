// What a profile tells of a sensor, as attributes of the data set that holds its samples: place, coupling, and the
// sensitivity and input range that its scale was made of. Only what is told is written; what is missing stays untold.
// Thread: its caller's, for as long as it takes; not real-time.
#pragma once

#include <hdf5.h>

#include <string>

#include "core/model/channel.h"

namespace stillcut::record {

bool writeSensor(hid_t dataset, const ChannelInfo& info);
void readSensor(hid_t dataset, ChannelInfo& info);
// Takes over what `from` tells of its sensor; name, quantity, scale and axis stay.
void takeSensor(const ChannelInfo& from, ChannelInfo& to);
// "12.5 mV per unit, 10 V, iepe, at spindle nose"; empty: nothing is told.
std::string sensorText(const ChannelInfo& info);

}  // namespace stillcut::record
