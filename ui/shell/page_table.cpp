#include "ui/shell/page_table.h"

#include <QCoreApplication>
#include <array>

#include "ui/pages/analyse_page.h"
#include "ui/pages/lobes_page.h"
#include "ui/pages/operate_page.h"

namespace stillcut::ui {
namespace {

Page* makeAnalyse(SessionFacade& session) {
  auto* page = new AnalysePage;
  QObject::connect(page, &AnalysePage::channelAsked, page, [&session](int channel) { session.showChannel(channel); });
  return page;
}

// By number: 1 Operate, 2 Analyse, 3 Lobes, 4 Tune, 5 Sessions, 6 Set up.
constexpr std::array kPages{
    PageEntry{1, "operate", QT_TRANSLATE_NOOP("Pages", "Operate"),
              [](SessionFacade&) -> Page* { return new OperatePage; }},
    PageEntry{2, "analyse", QT_TRANSLATE_NOOP("Pages", "Analyse"), makeAnalyse},
    PageEntry{3, "lobes", QT_TRANSLATE_NOOP("Pages", "Lobes"),
              [](SessionFacade& session) -> Page* { return new LobesPage([&session] { return session.lobes(); }); }},
};

}  // namespace

std::span<const PageEntry> pageTable() {
  return kPages;
}

QString pageTitle(const PageEntry& entry) {
  return QCoreApplication::translate("Pages", entry.title);
}

}  // namespace stillcut::ui
