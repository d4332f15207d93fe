#include "ui/shell/page_table.h"

#include <QCoreApplication>
#include <array>

#include "ui/pages/analyse_page.h"
#include "ui/pages/file/file_page.h"
#include "ui/pages/lobes_page.h"
#include "ui/pages/operate_page.h"
#include "ui/pages/sessions_page.h"
#include "ui/pages/setup/setup_page.h"
#include "ui/pages/tap/tap_page.h"
#include "ui/pages/tune_page.h"
#include "ui/report/report_files.h"

namespace stillcut::ui {
namespace {

Page* makeAnalyse(SessionFacade& session) {
  auto* page = new AnalysePage;
  QObject::connect(page, &AnalysePage::channelAsked, page, [&session](int channel) { session.showChannel(channel); });
  return page;
}

// By number: 1 Operate, 2 Analyse, 3 Lobes, 4 Tune, 5 Sessions, 6 Set up, 7 Tap test, 8 File.
constexpr std::array kPages{
    PageEntry{1, "operate", QT_TRANSLATE_NOOP("Pages", "Operate"),
              [](SessionFacade&) -> Page* { return new OperatePage; }},
    PageEntry{2, "analyse", QT_TRANSLATE_NOOP("Pages", "Analyse"), makeAnalyse},
    PageEntry{3, "lobes", QT_TRANSLATE_NOOP("Pages", "Lobes"),
              [](SessionFacade& session) -> Page* {
                return new LobesPage([&session] { return session.lobes(); }, session.lobeEntry());
              }},
    PageEntry{4, "tune", QT_TRANSLATE_NOOP("Pages", "Tune"),
              [](SessionFacade& session) -> Page* {
                return new TunePage(session.tuning(), [&session] { return session.active(); });
              }},
    PageEntry{5, "sessions", QT_TRANSLATE_NOOP("Pages", "Sessions"),
              [](SessionFacade& session) -> Page* { return new SessionsPage(session.sessions(), &writeByName); }},
    PageEntry{6, "setup", QT_TRANSLATE_NOOP("Pages", "Set up"),
              [](SessionFacade& session) -> Page* { return new SetupPage(session.setup()); }},
    PageEntry{7, "tap", QT_TRANSLATE_NOOP("Pages", "Tap test"),
              [](SessionFacade& session) -> Page* { return new TapPage(session.tap()); }},
    PageEntry{8, "file", QT_TRANSLATE_NOOP("Pages", "File"),
              [](SessionFacade& session) -> Page* { return new FilePage(session.files(), &writeByName); }},
};

}  // namespace

std::span<const PageEntry> pageTable() {
  return kPages;
}

QString pageTitle(const PageEntry& entry) {
  return QCoreApplication::translate("Pages", entry.title);
}

}  // namespace stillcut::ui
