// The pages of the window, one line each. GUI thread.
#pragma once

#include <QString>
#include <span>

#include "ui/shell/session_facade.h"

namespace stillcut::ui {

class Page;

struct PageEntry {
  int number;         // Ctrl+number shows it; its place among the pages
  const char* id;     // its object name, and the group of its settings
  const char* title;  // source text, see pageTitle()
  Page* (*make)(SessionFacade& session);
};

std::span<const PageEntry> pageTable();
QString pageTitle(const PageEntry& entry);

}  // namespace stillcut::ui
