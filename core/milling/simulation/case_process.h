// The `process` part of a reference cut: what varies over time. Used by case_json.cpp.
// A list NAME_segments holds objects {from_s, to_s, from_UNIT, to_UNIT, shape}; NAME tells the quantity, UNIT how it is
// counted. What would change the cut and is not understood is refused; text and lone numbers are remarks.
// Thread: set-up. Errors are thrown as Error, with the place.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/milling/simulation/scenario.h"

namespace stillcut::milling {

// `where` names the file; tool, engagement and nominal speed of the scenario are known already.
void readCaseProcess(const nlohmann::json& process, const std::string& where, Scenario& scenario);

// A number under `key`; throws when it is missing or no number.
double caseNumber(const nlohmann::json& object, const std::string& key, const std::string& where);

}  // namespace stillcut::milling
