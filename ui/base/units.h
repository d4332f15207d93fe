// The units lengths, feeds and cutting speeds are shown in. Inside the program everything is SI.
#pragma once

namespace stillcut::ui {

enum class UnitSystem { Metric, Inch };

}  // namespace stillcut::ui
