// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/manualwindow.h"

#include <QDesktopServices>
#include <QFile>
#include <QHBoxLayout>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTextBrowser>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/help/placing.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
// In line heights.
constexpr int kManualWidth = 56;
constexpr int kManualHeight = 40;
constexpr int kPagesWidth = 14;
constexpr int kSearchWidth = 14;
}  // namespace

/// Shows pages in Markdown, and scales pictures to fit.
class ManualBrowser : public QTextBrowser {
public:
    explicit ManualBrowser(QWidget* parent) : QTextBrowser(parent) {
        setOpenLinks(false);
        connect(this, &QTextBrowser::anchorClicked, this, &ManualBrowser::follow);
    }
    void follow(const QUrl& link) {
        const QUrl url = source().resolved(link);
        if (url.isLocalFile())
            setSource(url, QTextDocument::HtmlResource);
        else
            QDesktopServices::openUrl(url);
    }
    QVariant loadResource(int type, const QUrl& name) override {
        if (type == QTextDocument::ImageResource)
            return fitted(QImage(m_page.resolved(name).toLocalFile()));
        m_page = name;  // source() is still the previous page
        QFile file(name.toLocalFile());
        return file.open(QIODevice::ReadOnly) ? Manual::html(QString::fromUtf8(file.readAll())) : QString();
    }

protected:
    /// Link colours are written into the page, so it must be loaded again.
    void changeEvent(QEvent* event) override {
        QTextBrowser::changeEvent(event);
        if (event->type() == QEvent::PaletteChange && !source().isEmpty())
            reload();
    }

private:
    /// The picture scaled to fit, even with a scroll bar beside it.
    [[nodiscard]] QImage fitted(const QImage& picture) const {
        const int room = width() - verticalScrollBar()->sizeHint().width() - 2 * frameWidth() -
                         2 * qRound(document()->documentMargin());
        if (picture.width() <= room)
            return picture;
        const int pixels = qMin(picture.width(), qRound(room * devicePixelRatioF()));
        QImage image =
            picture.convertToFormat(QImage::Format_ARGB32).scaledToWidth(pixels, Qt::SmoothTransformation);
        image.setDevicePixelRatio(pixels / static_cast<qreal>(room));
        return image;
    }

    QUrl m_page;
};

ManualWindow::ManualWindow(const Manual& manual, QWidget* parent)
    : QDialog(parent), m_manual(manual), m_pages(new QListWidget(this)), m_browser(new ManualBrowser(this)) {
    look::name(this, u"manualWindow"_s, tr("Manual"));
    setWindowTitle(tr("NMC Panel - Manual"));
    look::name(m_pages, u"manualPageList"_s, tr("Pages of the manual"));
    look::name(m_browser, u"manualBrowser"_s, tr("Page of the manual"));
    for (const Manual::Page& page : m_manual.pages())
        m_pages->addItem(page.title);
    auto* content = form::newLine(this, {m_pages, {m_browser, 1}}, form::kUsual);
    setLayout(form::newColumn(this, {buildTop(), {content, 1}}, form::kUsual));
    m_pages->setFixedWidth(fontMetrics().height() * kPagesWidth);
    connect(m_pages, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0)
            m_browser->follow(urlOf(m_manual.pages().at(row).file));
    });
    connect(m_browser, &QTextBrowser::sourceChanged, this, &ManualWindow::follow);
    placeBelowTop(*this, QSize(kManualWidth, kManualHeight) * fontMetrics().height());
}

QPushButton* ManualWindow::newButton(const QString& objectName, const QString& text, const QString& toolTip,
                                     const QKeySequence& key) {
    auto* button =
        form::newPush({objectName, text, {}, toolTip.arg(key.toString(QKeySequence::NativeText))}, this);
    button->setShortcut(key);
    button->setAutoDefault(false);  // Enter in the field searches
    return button;
}

QHBoxLayout* ManualWindow::buildTop() {
    m_back = newButton(u"manualBackButton"_s, tr("Back"), tr("Goes back to the previous page (%1)."),
                       Qt::ALT | Qt::Key_Left);
    m_forward = newButton(u"manualForwardButton"_s, tr("Forward"), tr("Goes forward again (%1)."),
                          Qt::ALT | Qt::Key_Right);
    m_search = new QLineEdit(this);
    look::name(m_search, u"manualSearchField"_s, tr("Search this page"));
    m_search->setPlaceholderText(m_search->accessibleName());
    m_search->setToolTip(tr("Enter finds the next match, Shift+Enter the previous one (Ctrl+F)."));
    m_search->setMinimumWidth(fontMetrics().height() * kSearchWidth);
    m_search->installEventFilter(this);
    m_found = look::newMutedLabel({}, this, u"manualFoundLabel"_s);
    connect(m_back, &QPushButton::clicked, m_browser, &QTextBrowser::backward);
    connect(m_forward, &QPushButton::clicked, m_browser, &QTextBrowser::forward);
    connect(m_browser, &QTextBrowser::backwardAvailable, m_back, &QWidget::setEnabled);
    connect(m_browser, &QTextBrowser::forwardAvailable, m_forward, &QWidget::setEnabled);
    m_back->setEnabled(false);
    m_forward->setEnabled(false);
    connect(new QShortcut(Qt::CTRL | Qt::Key_F, this), &QShortcut::activated, m_search, [this] {
        m_search->setFocus(Qt::ShortcutFocusReason);
        m_search->selectAll();
    });
    return form::newLine(this, {m_back, m_forward, nullptr, m_found, m_search}, form::kUsual);
}

bool ManualWindow::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_search && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
            search(key->modifiers().testFlag(Qt::ShiftModifier));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

QUrl ManualWindow::urlOf(const QString& page) const {
    return QUrl::fromLocalFile(m_manual.folder() + u'/').resolved(QUrl(page));
}

void ManualWindow::openAt(const QString& page) {
    if (m_manual.pages().isEmpty())
        m_browser->setPlainText(tr("The manual is not installed. It belongs in %1.").arg(m_manual.folder()));
    else
        m_browser->follow(urlOf(page));
    look::showInFront(this);
    m_browser->setFocus();
}

/// Selects the page being read in the list of pages.
void ManualWindow::follow(const QUrl& url) {
    const QSignalBlocker blocker(m_pages);
    const QString file = url.fileName();
    const QList<Manual::Page>& pages = m_manual.pages();
    const auto page = std::find_if(pages.begin(), pages.end(),
                                   [&file](const Manual::Page& each) { return each.file == file; });
    m_pages->setCurrentRow(page == pages.end() ? -1 : static_cast<int>(page - pages.begin()));
    m_found->clear();
}

/// Searches from the cursor on, and wraps round at either end of the page.
void ManualWindow::search(bool backwards) {
    const QTextDocument::FindFlags flags =
        backwards ? QTextDocument::FindBackward : QTextDocument::FindFlags();
    const QString words = m_search->text();
    bool found = m_browser->find(words, flags);
    if (!found) {
        const QTextCursor before = m_browser->textCursor();
        m_browser->moveCursor(backwards ? QTextCursor::End : QTextCursor::Start);
        found = m_browser->find(words, flags);
        if (!found)
            m_browser->setTextCursor(before);
    }
    look::setText(m_found, found || words.isEmpty() ? QString() : tr("Not found on this page"));
}

}  // namespace nmc
