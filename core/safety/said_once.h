// SaidOnce: what the gate has told already, so that it tells each thing once and again only after it was over.
// Nothing here decides what is commanded. Thread: worker. Real-time.
#pragma once

#include "core/base/realtime.h"
#include "core/model/reason.h"

namespace stillcut::safety {

class SaidOnce {
 public:
  // True: it is news, and counts as told from now on.
  bool trouble(ReasonCode code) STILLCUT_RT {
    if (trouble_ == code) return false;
    trouble_ = code;
    return true;
  }
  void troubleOver() STILLCUT_RT { trouble_ = ReasonCode::None; }

  bool coolDown() STILLCUT_RT { return news(coolDown_); }
  void coolDownOver() STILLCUT_RT { coolDown_ = false; }

  bool limits() STILLCUT_RT { return news(limits_); }
  void limitsOver() STILLCUT_RT { limits_ = false; }

  enum class LinkNews { None, Lost, Back };
  LinkNews link(bool up) STILLCUT_RT {
    const Link before = link_;
    if (up) link_ = Link::Up;
    if (!up && before == Link::Up) link_ = Link::Lost;
    if (up && before == Link::Lost) return LinkNews::Back;
    return !up && before == Link::Up ? LinkNews::Lost : LinkNews::None;
  }

 private:
  enum class Link { NeverSeen, Up, Lost };
  static bool news(bool& told) STILLCUT_RT {
    const bool is = !told;
    told = true;
    return is;
  }

  ReasonCode trouble_ = ReasonCode::None;
  bool coolDown_ = false;
  bool limits_ = false;  // until something else is asked
  Link link_ = Link::NeverSeen;
};

}  // namespace stillcut::safety
