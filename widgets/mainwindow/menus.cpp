// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/menus.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>

#include "widgets/chain/chainmenu.h"
#include "widgets/common/languages.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/help/manualwindow.h"
#include "widgets/machine/machinemenu.h"
#include "widgets/mainwindow/bell.h"
#include "widgets/mainwindow/colourchoice.h"
#include "widgets/mainwindow/connectionbar.h"
#include "widgets/mainwindow/mainwindow.h"
#include "widgets/mainwindow/operatorlock.h"
#include "widgets/scope/scopefiles.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

class Menus {
    Q_DECLARE_TR_FUNCTIONS(Menus)
};

void openBox(MainWindow& window, const QString& objectName, const QString& title, const QString& text,
             const QString& more) {
    auto* box = new QMessageBox(QMessageBox::NoIcon, title, text, QMessageBox::Close, &window);
    box->setInformativeText(more);
    box->setAttribute(Qt::WA_DeleteOnClose);
    look::name(box, objectName, title);
    // Not modal: the panel stays usable, and STOP ALL with it.
    box->setModal(false);
    box->show();
}

void openAbout(MainWindow& window) {
    openBox(
        window, u"aboutDialog"_s, Menus::tr("About NMC Panel"),
        Common::tr("NMC Panel %1").arg(QCoreApplication::applicationVersion()),
        Menus::tr(
            "A control panel for PIC-SERVO, PIC-STEP and PIC-I/O modules on one serial line.\n\n"
            "Free software under the GNU General Public License, version 3 or later. Icons: Tabler, MIT licence. Built with Qt %1.")
            .arg(QLatin1StringView(qVersion())));
}

void openSafety(MainWindow& window) {
    const Message safety = texts::safety();
    openBox(window, u"safetyDialog"_s, Menus::tr("Safety"), safety.headline, safety.body);
}

template <typename Act>
QAction* addAction(QMenu* menu, const QString& objectName, const QString& text, const QKeySequence& key,
                   MainWindow& window, const Act& act) {
    QAction* action = look::newAction(menu, objectName, text, {}, key);
    menu->addAction(action);
    QObject::connect(action, &QAction::triggered, &window, act);
    return action;
}

/// Stores the language at once; it is read at the next start.
void chooseLanguage(MainWindow& window, QSettings& settings, const QString& language) {
    if (settings.value(languages::kSetting).toString() == language)
        return;
    settings.setValue(languages::kSetting, language);
    openBox(window, u"languageDialog"_s, Menus::tr("Language"),
            Menus::tr("The new language takes effect the next time you start NMC Panel."), {});
}

/// Lists each language under its own name, so that users who cannot read the others find it.
void addLanguages(QMenu& view, MainWindow& window, QSettings& settings) {
    QMenu* menu = view.addMenu(Menus::tr("&Language"));
    look::name(menu, u"languageMenu"_s, Menus::tr("Language"));
    auto* group = new QActionGroup(menu);
    const QString chosen = settings.value(languages::kSetting).toString();
    for (const QString& language : QStringList{QString()} + languages::available()) {
        const QString text = language.isEmpty() ? Menus::tr("&System") : languages::nameOf(language);
        QAction* action =
            addAction(menu, u"languageAction_"_s + (language.isEmpty() ? u"system"_s : language), text, {},
                      window, [&window, &settings, language] { chooseLanguage(window, settings, language); });
        action->setCheckable(true);
        action->setChecked(language == chosen);
        group->addAction(action);
    }
}

}  // namespace

void fillMenus(QMenuBar& bar, MainWindow& window, QSettings& settings) {
    QMenu* file = bar.addMenu(Menus::tr("&File"));
    look::name(file, u"fileMenu"_s, Menus::tr("File"));
    window.machineMenu().addTo(*file);
    file->addSeparator();
    file->addAction(window.scopeFiles().openAction());
    file->addAction(window.scopeFiles().underAction());
    file->addSeparator();
    file->addAction(window.operatorLock().action());
    file->addSeparator();
    addAction(file, u"quitAction"_s, Menus::tr("&Quit"), Qt::CTRL | Qt::Key_Q, window, &QWidget::close);

    QMenu* chain = bar.addMenu(Common::tr("Chain"));
    look::name(chain, u"chainMenu"_s, Common::tr("Chain"));
    chain->setToolTipsVisible(true);
    chain->addAction(window.connectionBar().readOnlyAction());
    chain->addSeparator();
    window.chainMenu().addTo(*chain);

    QMenu* module = bar.addMenu(Common::tr("Module"));
    look::name(module, u"moduleMenu"_s, Common::tr("Module"));
    module->setToolTipsVisible(true);
    QObject::connect(module, &QMenu::aboutToShow, &window,
                     [&window, module] { window.fillModuleMenu(*module); });
    // A command's key acts while its box is visible; in a closed menu, it would act everywhere.
    QObject::connect(module, &QMenu::aboutToHide, module, &QMenu::clear, Qt::QueuedConnection);

    QMenu* view = bar.addMenu(Menus::tr("&View"));
    look::name(view, u"viewMenu"_s, Menus::tr("View"));
    view->setToolTipsVisible(true);
    view->addActions(window.layouts().actions());
    view->addSeparator();
    int number = 1 + static_cast<int>(window.layouts().actions().size());
    for (QDockWidget* dock : window.layouts().docks()) {
        QAction* toggle = dock->toggleViewAction();
        toggle->setObjectName(dock->objectName() + u"Action"_s);
        if (toggle->shortcut().isEmpty())
            toggle->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_0 + number++)));
        view->addAction(toggle);
    }
    view->addSeparator();
    QMenu* colours = view->addMenu(Menus::tr("Colour&s"));
    look::name(colours, u"coloursMenu"_s, Menus::tr("Colours"));
    colours->setToolTipsVisible(true);
    colours->addActions(window.colours().actions());
    view->addAction(window.bell().action());
    addLanguages(*view, window, settings);
    addAction(view, u"resetLayoutAction"_s, Menus::tr("&Reset layout"), {}, window, &MainWindow::resetLayout);

    QMenu* help = bar.addMenu(Menus::tr("&Help"));
    look::name(help, u"helpMenu"_s, Menus::tr("Help"));
    QAction* manual = addAction(help, u"manualAction"_s, Menus::tr("&Manual"), Qt::Key_F1, window,
                                [&window] { window.manual().openFor(QApplication::focusWidget()); });
    manual->setShortcutContext(Qt::ApplicationShortcut);  // in every window
    addAction(help, u"keysAction"_s, Menus::tr("&Keyboard shortcuts"), {}, window,
              [&window] { window.manual().openAt(u"keys.md"_s); });
    addAction(help, u"findCommandAction"_s, Menus::tr("&Find a command…"), Qt::CTRL | Qt::Key_K, window,
              &MainWindow::openPalette);
    addAction(help, u"safetyAction"_s, Menus::tr("&Safety"), {}, window, [&window] { openSafety(window); });
    addAction(help, u"reportProblemAction"_s, Menus::tr("&Report a problem…"), {}, window,
              &MainWindow::openProblemReport);
    addAction(help, u"aboutAction"_s, Menus::tr("&About NMC Panel"), {}, window,
              [&window] { openAbout(window); });
}

}  // namespace nmc
