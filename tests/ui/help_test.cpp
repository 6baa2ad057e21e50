// SPDX-License-Identifier: GPL-3.0-or-later
// The manual in the program: what F1 opens, and reading on from there.
#include "widgets/common/look.h"
#include "widgets/common/printdialog.h"
#include "widgets/help/manual.h"
#include "widgets/machine/machinemenu.h"
#include "windowtest.h"

namespace nmc {
namespace {

class Help : public WindowTest {
protected:
    Help() { showServo(); }

    /// Presses a key in the window that has the keyboard.
    static void strike(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        ASSERT_NE(QGuiApplication::focusWindow(), nullptr);
        QTest::keyClick(QGuiApplication::focusWindow(), key, modifiers);
        QApplication::processEvents();
    }
    void focus(const QString& name) { find(name)->setFocus(Qt::OtherFocusReason); }
    QTextBrowser& browser() { return *window->findChild<QTextBrowser*>(u"manualBrowser"_s); }
    /// What is shown, for example "homing.md#limitStopBox".
    QString shown() {
        auto* manual = window->findChild<QWidget*>(u"manualWindow"_s);
        if (manual == nullptr || !manual->isVisible())
            return u"nothing"_s;
        const QUrl url = browser().source();
        return url.hasFragment() ? url.fileName() + u'#' + url.fragment() : url.fileName();
    }
    QString shownTitle() { return browser().document()->firstBlock().text(); }
    bool active(const QString& name) {
        return eventually([&] {
            const QWidget* active = QApplication::activeWindow();
            return active != nullptr && active->objectName() == name;
        });
    }
    /// True if the page can be opened at this place.
    bool hasAnchor(const QTextDocument& document, const QString& name) {
        for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part)
                if (part.fragment().charFormat().anchorNames().contains(name))
                    return true;
        return false;
    }
};

TEST_F(Help, F1OpensWhatIsSaidOfTheFieldThatHasTheFocus) {
    focus(u"goalField"_s);
    strike(Qt::Key_F1);
    EXPECT_EQ(shown(), u"move-and-jog.md#motionBox"_s);
    EXPECT_EQ(shownTitle(), u"Move and jog"_s);
    ASSERT_TRUE(active(u"manualWindow"_s));
    EXPECT_TRUE(browser().hasFocus());
    window->activateWindow();
    ASSERT_TRUE(active(u"mainWindow"_s));
    focus(u"homeButton"_s);
    strike(Qt::Key_F1);
    EXPECT_EQ(shown(), u"homing.md#homingBox"_s) << "in the window that is open already";
    EXPECT_EQ(window->findChildren<QTextBrowser*>(u"manualBrowser"_s).size(), 1);
}

TEST_F(Help, F1OnTheBarOfTabsIsAboutTheTabThatIsShown) {
    auto* tabs = find<QTabWidget>(u"servoPages"_s);
    const int axis = 1;
    QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, {}, tabs->tabBar()->tabRect(axis).center());
    const QWidget* page = tabs->currentWidget();
    tabs->tabBar()->setFocus();
    strike(Qt::Key_F1);
    const QString anchor = browser().source().fragment();
    EXPECT_NE(page->findChild<QWidget*>(anchor), nullptr) << shown().toStdString();
}

TEST_F(Help, F1ActsInOtherWindowsToo) {
    window->findChild<QAction*>(u"groupsAction"_s)->trigger();
    ASSERT_TRUE(active(u"chainDialog"_s));
    strike(Qt::Key_F1);
    EXPECT_EQ(shown(), u"groups-and-sequences.md#groupsPage"_s);
}

TEST_F(Help, F1OfWhatTheManualDoesNotNameIsTheIndex) {
    EXPECT_EQ(Manual().pageOf(nullptr), u"index.md"_s);
    window->setFocus();
    strike(Qt::Key_F1);
    EXPECT_EQ(shown(), u"index.md"_s);
    EXPECT_EQ(shownTitle(), u"NMC Panel: the manual"_s);
}

TEST_F(Help, TheMenuHasTheManualAndItsPageOfKeys) {
    auto* menu = find<QMenu>(u"helpMenu"_s);
    for (const auto& [action, page] : {std::pair{u"keysAction"_s, u"keys.md"_s}}) {
        menu->popup(window->mapToGlobal(QPoint(20, 40)));
        QTest::mouseClick(menu, Qt::LeftButton, {},
                          menu->actionGeometry(window->findChild<QAction*>(action)).center());
        EXPECT_EQ(shown(), page);
    }
}

TEST_F(Help, PagesAreListedAndReadOneAfterTheOther) {
    window->setFocus();
    strike(Qt::Key_F1);
    ASSERT_TRUE(active(u"manualWindow"_s));
    auto* list = find<QListWidget>(u"manualPageList"_s);
    QStringList listed;
    for (int i = 0; i < list->count(); ++i)
        listed << list->item(i)->text();
    ASSERT_TRUE(listed.contains(u"Homing"_s));
    // All existing pages are listed; the index contains the name of a new one.
    EXPECT_EQ(list->count(), QDir(QStringLiteral(MANUAL_DIR)).entryList({u"*.md"_s}).size());
    const int homing = static_cast<int>(listed.indexOf(u"Homing"_s));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(homing)).center());
    EXPECT_EQ(shown(), u"homing.md"_s);
    EXPECT_EQ(shownTitle(), u"Homing"_s);
    EXPECT_FALSE(button(u"manualForwardButton"_s)->isEnabled());
    click(u"manualBackButton"_s);
    EXPECT_EQ(list->currentItem()->text(), listed.front());
    strike(Qt::Key_Right, Qt::AltModifier);
    EXPECT_EQ(shown(), u"homing.md"_s);
    EXPECT_EQ(list->currentRow(), homing);
}

TEST_F(Help, ALinkIsFollowedToItsPlace) {
    focus(u"gainsBox"_s);
    find<QTabWidget>(u"servoPages"_s);
    focus(u"kpField"_s);
    strike(Qt::Key_F1);
    ASSERT_EQ(shown(), u"first-servo.md#gainsBox"_s);
    ASSERT_TRUE(active(u"manualWindow"_s));
    // A place within its words.
    QTextCursor link = browser().document()->find(u"direction check"_s);
    for (QTextBlock block = browser().document()->begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part)
            if (part.fragment().charFormat().anchorHref() == u"tuning.md#try-gains"_s)
                link.setPosition(part.fragment().position() + 2);
    browser().setTextCursor(link);
    browser().ensureCursorVisible();
    QTest::mouseClick(browser().viewport(), Qt::LeftButton, {}, browser().cursorRect(link).center());
    EXPECT_EQ(shown(), u"tuning.md#try-gains"_s);
    EXPECT_GT(browser().verticalScrollBar()->value(), 0) << "it is not shown at its top";
}

TEST_F(Help, WordsOfThePageAreFoundOneAfterTheOther) {
    window->findChild<QAction*>(u"keysAction"_s)->trigger();
    ASSERT_TRUE(active(u"manualWindow"_s));
    strike(Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(find<QLineEdit>(u"manualSearchField"_s), u"SEQUENCES"_s);
    strike(Qt::Key_Return);
    const QTextCursor first = browser().textCursor();
    EXPECT_EQ(first.selectedText(), u"sequences"_s);
    strike(Qt::Key_Return);
    const QTextCursor second = browser().textCursor();
    EXPECT_GT(second.position(), first.position());
    strike(Qt::Key_Return, Qt::ShiftModifier);
    EXPECT_EQ(browser().textCursor().position(), first.position());
    strike(Qt::Key_Return, Qt::ShiftModifier);
    EXPECT_GE(browser().textCursor().position(), second.position()) << "the search goes on at the end";
    EXPECT_EQ(text(u"manualFoundLabel"_s), u""_s);
    strike(Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(find<QLineEdit>(u"manualSearchField"_s), u"xyzzy"_s);
    strike(Qt::Key_Return);
    EXPECT_EQ(text(u"manualFoundLabel"_s), u"Not found on this page"_s);
    EXPECT_TRUE(find(u"manualWindow"_s)->isVisible());
}

TEST_F(Help, TheWindowLeavesStopAllInSight) {
    for (const QSize size : {QSize(1280, 864), QSize(800, 600)}) {
        window->resize(size);
        QApplication::processEvents();
        window->activateWindow();
        ASSERT_TRUE(active(u"mainWindow"_s));
        strike(Qt::Key_F1);
        const QWidget* stop = find(u"stopAllButton"_s);
        const QRect place(stop->mapToGlobal(QPoint(0, 0)), stop->size());
        EXPECT_FALSE(find(u"manualWindow"_s)->frameGeometry().intersects(place)) << size.width();
        find(u"manualWindow"_s)->close();
    }
}

TEST_F(Help, LinksCanBeReadOnEveryPalette) {
    window->setFocus();
    strike(Qt::Key_F1);
    for (const QPalette& palette : {darkPalette(), QPalette(Qt::white, Qt::black)}) {
        QApplication::setPalette(palette);  // while it is open
        QApplication::processEvents();
        int links = 0;
        for (QTextBlock block = browser().document()->begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part) {
                const QTextCharFormat format = part.fragment().charFormat();
                if (format.anchorHref().isEmpty())
                    continue;
                ++links;
                EXPECT_GE(
                    look::contrast(format.foreground().color(), browser().palette().color(QPalette::Base)),
                    4.5)
                    << format.anchorHref().toStdString();
            }
        EXPECT_GT(links, 10);
    }
    QApplication::setPalette(QPalette());
}

class HelpPage : public Help, public testing::WithParamInterface<std::string> {
protected:
    HelpPage() : file(QString::fromStdString(GetParam())) {
        window->findChild<QAction*>(u"manualAction"_s)->trigger();
        browser().setSource(QUrl::fromLocalFile(Manual::installedFolder() + u'/' + file),
                            QTextDocument::HtmlResource);
    }
    const QString file;
};

TEST_P(HelpPage, LinksAndPicturesAreThere) {
    int links = 0;
    for (QTextBlock block = browser().document()->begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            const QTextCharFormat format = part.fragment().charFormat();
            if (format.isImageFormat()) {
                const auto picture =
                    browser().loadResource(QTextDocument::ImageResource, QUrl(format.toImageFormat().name()));
                EXPECT_FALSE(picture.value<QImage>().isNull()) << format.toImageFormat().name().toStdString();
                EXPECT_LE(picture.value<QImage>().deviceIndependentSize().width(),
                          browser().viewport()->width());
            }
            const QUrl url = browser().source().resolved(QUrl(format.anchorHref()));
            if (format.anchorHref().isEmpty() || !url.isLocalFile())
                continue;
            ++links;
            QFile there(url.toLocalFile());
            ASSERT_TRUE(there.open(QIODevice::ReadOnly)) << format.anchorHref().toStdString();
            QTextDocument target;
            target.setHtml(Manual::html(QString::fromUtf8(there.readAll())));
            EXPECT_TRUE(!url.hasFragment() || hasAnchor(target, url.fragment()))
                << format.anchorHref().toStdString();
        }
    EXPECT_FALSE(browser().horizontalScrollBar()->isVisible());
    EXPECT_EQ(find<QListWidget>(u"manualPageList"_s)->currentItem()->text(), shownTitle());
    EXPECT_TRUE(links > 0 || file != Manual::kIndex);
    EXPECT_FALSE(browser().toPlainText().contains(QRegularExpression(u"[\uE000\uE001]|<a "_s)));
    window->findChild<QWidget*>(u"manualWindow"_s)
        ->grab()
        .save(QStringLiteral(SCREENSHOT_DIR "/manual-") + file.chopped(3) + u".jpg"_s);
}

QSet<QString> ownAnchors(const QString& page) {
    static const QRegularExpression anchor(u"<a id=\"(\\w+)\"></a>"_s);
    QFile file(QStringLiteral(MANUAL_DIR "/") + page);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    QSet<QString> names;
    for (const auto& each : anchor.globalMatch(QString::fromUtf8(file.readAll())))
        names << each.captured(1);
    return names;
}

TEST_P(HelpPage, EachOfItsAnchorsCanBeJumpedTo) {
    for (const QString& name : ownAnchors(file))
        EXPECT_TRUE(hasAnchor(*browser().document(), name)) << name.toStdString();
}

std::vector<std::string> pagesOfTheManual() {
    std::vector<std::string> pages;
    for (const QString& page : QDir(QStringLiteral(MANUAL_DIR)).entryList({u"*.md"_s}))
        pages.push_back(page.toStdString());
    return pages;
}
INSTANTIATE_TEST_SUITE_P(Manual, HelpPage, testing::ValuesIn(pagesOfTheManual()), [](const auto& page) {
    return QString::fromStdString(page.param).chopped(3).remove(u'-').toStdString();
});

/// Each anchor is a widget of some module, some dock or some dialog.
TEST_F(Help, EachAnchorOfTheManualIsAWidget) {
    QSet<QString> wanted;
    for (const std::string& page : pagesOfTheManual())
        wanted += ownAnchors(QString::fromStdString(page));
    ASSERT_GT(wanted.size(), 80);
    const auto look = [&] {
        for (const QWidget* widget : window->findChildren<QWidget*>())
            wanted.remove(widget->objectName());
    };
    for (const auto& [type, version] :
         {std::pair{ModuleType::Servo, std::uint8_t{5}}, std::pair{ModuleType::Servo, std::uint8_t{10}},
          std::pair{ModuleType::Stepper, std::uint8_t{1}}, std::pair{ModuleType::Io, std::uint8_t{1}}}) {
        showInEveryDock({type, version});
        look();
    }
    for (const QString& action : {u"chainDoctorAction"_s, u"copyAxisAction"_s, u"findCommandAction"_s,
                                  u"lendLineAction"_s, u"operatorAction"_s, u"scopeSignalsAction"_s})
        window->findChild<QAction*>(action)->trigger();
    click(u"scopeCustomTracesButton"_s);
    window->machineMenu().showDifferences(u"mill.json"_s, {});
    (new PrintDialog({}, window->requests(), window.get()))->show();
    showServo();
    click(u"workOutUnitButton"_s);
    click(u"scopeCursorsButton"_s);
    click(u"scopeSpectrumButton"_s);
    click(u"scopeXyButton"_s);
    look();
    EXPECT_TRUE(wanted.isEmpty()) << wanted.values().join(u' ').toStdString();
}

}  // namespace
}  // namespace nmc
