// Interruption: Ctrl-C, a terminal that is closed, or a polite kill, for programs that have a machine in their hands:
// they look, and end in order with its programmed values back, instead of dying where they stand. Nor are they ended
// by a program that has read what they print and has gone.
#pragma once

namespace stillcut::app {

// From now on these are minded; a closed terminal is not where nohup said so. Thread: main.
void mindInterruption() noexcept;
// Any thread.
bool interrupted() noexcept;
// Standard output leads to nobody any more: a pipe whose reader has ended. Any thread.
bool unread() noexcept;

}  // namespace stillcut::app
