#include "ui/shell/page_table.h"

#include <QCoreApplication>
#include <array>

#include "ui/pages/operate_page.h"

namespace stillcut::ui {
namespace {

// By number: 1 Operate, 2 Analyse, 3 Lobes, 4 Tune, 5 Sessions, 6 Set up.
constexpr std::array kPages{
    PageEntry{1, "operate", QT_TRANSLATE_NOOP("Pages", "Operate"),
              [](SessionFacade&) -> Page* { return new OperatePage; }},
};

}  // namespace

std::span<const PageEntry> pageTable() {
  return kPages;
}

QString pageTitle(const PageEntry& entry) {
  return QCoreApplication::translate("Pages", entry.title);
}

}  // namespace stillcut::ui
