// OneProgramLink: a link to a machine that only one program may hold: linuxcncrsh goes down when two ask it at once,
// and two on one serial port read each other's answers. open() takes a lock named by each wire's address, in a folder
// that all users of this computer share; it is let go with the link, also by a program that is killed. Where no lock
// can be made the machine is held without one. Thread: as CncLink.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/cnc/cnc_link.h"
#include "core/cnc/registry.h"

namespace stillcut::app {

// cnc::makeLink(), held so. `locks`: the folder; empty: /run/lock, or the user's own. `owner`: the process it is held
// for; 0: this one. A holder that has died may have left somebody behind who brings the machine home: he is waited for.
Result<std::unique_ptr<cnc::CncLink>> makeOneProgramLink(std::string_view id, cnc::LinkRequest request,
                                                         const std::string& locks = "", int owner = 0);

}  // namespace stillcut::app
