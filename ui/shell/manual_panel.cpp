#include "ui/shell/manual_panel.h"

#include <QFile>
#include <QHBoxLayout>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <algorithm>

#include "ui/shell/raised_panel.h"
#include "ui/widgets/touch_button.h"

static void loadManualResource() {
  Q_INIT_RESOURCE(manual);  // a static library's resources are not registered by themselves
}

namespace stillcut::ui {
namespace {

constexpr int kPartLevel = 2;  // "## Operate"
const QString kManual = QStringLiteral("/manual/");

// As a link names a heading: "Back to 100 %" is #back-to-100-.
QString anchorOf(const QString& heading) {
  QString anchor;
  for (const QChar c : heading.toLower()) {
    if (c.isLetterOrNumber() || c == u'-') anchor += c;
    if (c == u' ') anchor += u'-';
  }
  return anchor;
}

template <class Accept>
QTextBlock findHeading(const QTextDocument& document, Accept&& accept) {
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() > 0 && accept(block)) return block;
  }
  return {};
}

void scrollTo(QTextBrowser& text, const QTextBlock& block) {
  if (!block.isValid()) return;
  (void)text.document()->pageCount();  // laid out to its end, else the bar ends where the layout has come to
  text.setTextCursor(QTextCursor(block));
  text.verticalScrollBar()->setValue(text.verticalScrollBar()->value() + text.cursorRect().top());
}

}  // namespace

QUrl chapterUrl(const QString& name, Language language) {
  loadManualResource();
  for (const QString& file : {name + u'.' + languageCode(language), name}) {
    if (QFile::exists(QStringLiteral(":/manual/%1.md").arg(file))) {
      return QUrl(QStringLiteral("qrc:/manual/%1.md").arg(file));
    }
  }
  return {};
}

ManualPanel::ManualPanel(Language language, QWidget* parent)
    : QWidget(parent),
      language_(language),
      theme_(makeTheme(ThemeKind::Light, 1.0)),
      text_(new QTextBrowser),
      contents_(new TouchButton(tr("CONTENTS"))),
      back_(new TouchButton(tr("BACK"))),
      close_(new TouchButton(tr("CLOSE"))) {
  setObjectName(QStringLiteral("manual"));
  setAccessibleName(tr("Manual"));
  text_->setAccessibleName(tr("Manual"));
  text_->setOpenLinks(false);
  contents_->setObjectName(QStringLiteral("manual-contents"));
  back_->setObjectName(QStringLiteral("manual-back"));
  close_->setObjectName(QStringLiteral("manual-close"));
  close_->setHint(QStringLiteral("F1"));
  auto* column = new QVBoxLayout(this);
  auto* line = new QHBoxLayout;
  for (TouchButton* button : {contents_, back_, close_}) {
    button->setBaseHeight(50);
    line->addWidget(button);
  }
  line->insertStretch(2, 1);
  column->addLayout(line);
  column->addWidget(text_, 1);
  connect(text_, &QTextBrowser::anchorClicked, this, &ManualPanel::follow);
  connect(text_, &QTextBrowser::sourceChanged, this, &ManualPanel::dress);
  connect(text_, &QTextBrowser::backwardAvailable, back_, &TouchButton::setEnabled);
  connect(contents_, &TouchButton::clicked, this,
          [this] { text_->setSource(chapterUrl(QStringLiteral("index"), language_)); });
  connect(back_, &TouchButton::clicked, text_, &QTextBrowser::backward);
  connect(close_, &TouchButton::clicked, this, &QWidget::hide);
  back_->setEnabled(false);
  hide();
}

void ManualPanel::openAt(int number) {
  raise();
  show();
  layout()->activate();
  text_->setSource(chapterUrl(QStringLiteral("screens"), language_));
  dress();  // even where the chapter is the one that was open: the panel may have another height now
  int part = 0;
  scrollTo(*text_, findHeading(*text_->document(), [&](const QTextBlock& block) {
    return block.blockFormat().headingLevel() == kPartLevel && ++part == number;
  }));
}

QUrl ManualPanel::chapter() const {
  return text_->source();
}

QString ManualPanel::headingOnTop() const {
  QTextBlock block = text_->cursorForPosition(QPoint(text_->viewport()->width() / 2, 4)).block();
  while (block.isValid() && block.blockFormat().headingLevel() == 0) block = block.previous();
  return block.text();
}

// A chapter that this language has is taken from it, whatever language the link was written in.
void ManualPanel::openLink(const QString& link) {
  raise();
  show();
  layout()->activate();
  if (text_->source().isEmpty()) text_->setSource(chapterUrl(QStringLiteral("screens"), language_));
  dress();
  follow(QUrl(link));
}

void ManualPanel::follow(const QUrl& link) {
  const QUrl whole = text_->source().resolved(link);
  const QString file = whole.path();
  if (!file.startsWith(kManual) || !file.endsWith(QStringLiteral(".md"))) return;
  const QUrl chapter = chapterUrl(file.mid(kManual.size()).chopped(3), language_);
  if (chapter.isEmpty()) return;
  text_->setSource(chapter);
  if (!whole.hasFragment()) return;
  scrollTo(*text_, findHeading(*text_->document(),
                               [&](const QTextBlock& block) { return anchorOf(block.text()) == whole.fragment(); }));
}

void ManualPanel::dress() {
  QTextDocument& document = *text_->document();
  // So far that the last heading can stand at the top as well.
  QTextFrameFormat page = document.rootFrame()->frameFormat();
  page.setBottomMargin(text_->viewport()->height());
  document.rootFrame()->setFrameFormat(page);
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
      const QTextFragment fragment = piece.fragment();
      QTextCursor cursor(block);
      cursor.setPosition(fragment.position());
      cursor.setPosition(fragment.position() + fragment.length(), QTextCursor::KeepAnchor);
      if (fragment.charFormat().isImageFormat()) {
        QTextImageFormat picture = fragment.charFormat().toImageFormat();
        picture.setWidth(text_->viewport()->width() - theme_.px(32));
        cursor.setCharFormat(picture);
      } else if (fragment.charFormat().isAnchor()) {
        QTextCharFormat look;
        look.setForeground(theme_.colors.advice);
        cursor.mergeCharFormat(look);
      }
    }
  }
  for (QTextFrame* frame : document.rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (table == nullptr) continue;
    QTextTableFormat look = table->format();
    look.setCellPadding(theme_.px(5));
    look.setCellSpacing(0);
    look.setBorderCollapse(true);
    look.setBorder(1);
    look.setBorderBrush(theme_.colors.border);
    look.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    table->setFormat(look);
  }
}

void ManualPanel::applyTheme(const Theme& theme) {
  theme_ = theme;
  const int margin = theme.px(14);
  layout()->setContentsMargins(margin, margin, margin, margin);
  layout()->setSpacing(std::max(theme.px(12), pixelsFor(kTouchGapMm, this)));
  text_->setFont(theme.font(type_size::kBody));
  if (!text_->source().isEmpty()) dress();
}

void ManualPanel::paintEvent(QPaintEvent*) {
  QPainter p(this);
  drawRaised(p, rect(), theme_);
}

}  // namespace stillcut::ui
