// SPDX-License-Identifier: GPL-3.0-or-later
// Every command of the window: the Module menu, and the palette in which all are found by their words.
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QTimer>

#include "widgets/chain/chainview.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/mainwindow/commandpalette.h"
#include "widgets/mainwindow/mainwindow.h"
#include "widgets/mainwindow/pendant.h"
#include "widgets/panels/command.h"
#include "widgets/panels/modulepage.h"
#include "widgets/panels/modulepanel.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString shortcutText(const QAction& action) {
    return action.shortcut().toString(QKeySequence::NativeText);
}

void addMenu(const QMenu& menu, std::vector<CommandPalette::Entry>& entries) {
    for (QAction* action : menu.actions()) {
        if (action->menu() != nullptr) {
            addMenu(*action->menu(), entries);
            continue;
        }
        if (action->isSeparator() || !action->isVisible())
            continue;
        const QString text = action->text().remove(u'&');
        const auto reason = [action = QPointer(action)] {
            if (action && action->isEnabled())
                return QString();
            const bool told = action && action->toolTip() != action->iconText();
            return told ? action->toolTip() : MainWindow::tr("Not possible now.");
        };
        entries.push_back({text, text, menu.title().remove(u'&'), shortcutText(*action),
                           MainWindow::tr("Press Enter to run it."), reason, [action = QPointer(action)] {
                               if (action)
                                   action->trigger();
                           }});
    }
}

}  // namespace

void MainWindow::fillModuleMenu(QMenu& menu) {
    menu.clear();
    ModulePage* page = m_panel->page();
    if (page == nullptr) {
        menu.addAction(Common::tr("No module"))->setEnabled(false);
        return;
    }
    page->context().catchUp();
    // Commands whose box is not visible are not updated otherwise, so this continues while the menu is open.
    auto* open = new QObject(page);
    connect(&menu, &QMenu::aboutToHide, open, &QObject::deleteLater);
    connect(&page->context(), &ModuleContext::changed, open, [page] { page->context().catchUp(); });
    const QWidget* box = nullptr;
    for (Command* command : page->commands()) {
        if (!command->isVisible())
            continue;
        if (box != nullptr && box != command->box())
            menu.addSeparator();
        box = command->box();
        menu.addAction(command);
    }
    menu.addSeparator();
    menu.addAction(m_pendant->action());
}

void MainWindow::addModuleEntries(std::vector<CommandPalette::Entry>& entries) {
    ModulePage* page = m_panel->page();
    if (page == nullptr)
        return;
    page->context().catchUp();
    QAction* pendant = m_pendant->action();
    entries.push_back({pendant->text().remove(u'&'), pendant->toolTip(), Common::tr("Module"),
                       shortcutText(*pendant), pendant->toolTip(),
                       [pendant] { return pendant->isEnabled() ? QString() : pendant->toolTip(); },
                       [pendant] { pendant->trigger(); }});
    for (Command* command : page->commands()) {
        if (!command->isVisible())
            continue;
        const auto reason = [command = QPointer(command)] {
            return command ? command->reason() : tr("Its module is no longer connected.");
        };
        const auto act = [page = QPointer(page), command = QPointer(command)] {
            if (!page || !command)
                return;
            // With the present state, even if the command's box is not visible.
            page->context().catchUp();
            command->act();
        };
        entries.push_back({command->text().remove(u'&'), command->sentence(),
                           texts::moduleName(page->context().state().info.index), shortcutText(*command),
                           command->toolTip(), reason, act});
    }
}

/// Commands of other modules use values on their pages, which are not visible from here: they are shown there
/// instead of being carried out.
void MainWindow::addOtherModules(std::vector<CommandPalette::Entry>& entries) {
    for (const ModuleState& module : m_session.link().modules) {
        const ModuleIndex index = module.info.index;
        if (index == selectedModule())
            continue;
        const ModulePage* alike = m_panel->pageLike(m_session.viewOf(module));
        if (alike == nullptr)
            continue;
        for (const Command* command : alike->commands()) {
            const QString name = command->button()->objectName();
            entries.push_back({command->text().remove(u'&'),
                               command->sentence(),
                               texts::moduleName(index),
                               {},
                               tr("Press Enter to show it on the module's page. Nothing is sent."),
                               [] { return QString(); },
                               [this, index, name] {
                                   m_session.select(index);
                                   if (ModulePage* page = m_panel->page())
                                       page->showCommand(name);
                               }});
        }
    }
}

void MainWindow::openPalette() {
    std::vector<CommandPalette::Entry> entries;
    addModuleEntries(entries);
    for (const QAction* action : findChild<QMenuBar*>(u"menuBar"_s)->actions())
        if (action->menu() != nullptr && action->menu()->objectName() != u"moduleMenu"_s)
            addMenu(*action->menu(), entries);
    addOtherModules(entries);
    if (m_palette == nullptr)
        m_palette = new CommandPalette(this);
    m_palette->showEntries(std::move(entries));
}

/// Where digits are typed with Shift (AZERTY), Qt does not recognise Ctrl with a digit's key as Ctrl+1,
/// although that is what the user means.
void MainWindow::keyPressEvent(QKeyEvent* event) {
    constexpr quint32 kKeyOf1 = 10;  // on X11 and Wayland: the kernel's KEY_1 plus 8
    constexpr quint32 kDigits = 8;
    const quint32 above1 = event->nativeScanCode() - kKeyOf1;
    if (event->modifiers() != Qt::ControlModifier || event->isAutoRepeat() || above1 >= kDigits)
        return QMainWindow::keyPressEvent(event);
    const QKeySequence wanted(QKeyCombination(Qt::CTRL, static_cast<Qt::Key>(Qt::Key_1 + above1)));
    for (QAction* action : findChildren<QAction*>())
        if (action->isEnabled() && action->shortcut() == wanted)
            return action->trigger();
}

}  // namespace nmc
