// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/paletteentries.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>

#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/mainwindow/session.h"
#include "widgets/panels/command.h"
#include "widgets/panels/modulepage.h"
#include "widgets/panels/modulepanel.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

using Entries = std::vector<CommandPalette::Entry>;

QString shortcutText(const QAction& action) {
    return action.shortcut().toString(QKeySequence::NativeText);
}

bool hasTip(const QAction& action) {
    return action.toolTip() != action.iconText();
}

void addMenu(const QMenu& menu, Entries& entries) {
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
            return action && hasTip(*action) ? action->toolTip() : CommandPalette::tr("Not possible now.");
        };
        const QString tip = action->isEnabled() && hasTip(*action) ? action->toolTip() : QString();
        entries.push_back({tip, text, menu.title().remove(u'&'), shortcutText(*action),
                           tip.isEmpty() ? CommandPalette::tr("Press Enter to run it.") : tip, reason,
                           [action = QPointer(action)] {
                               if (action)
                                   action->trigger();
                           }});
    }
}

void addPage(ModulePage& page, QAction* pendant, Entries& entries) {
    page.context().catchUp();
    entries.push_back({pendant->text().remove(u'&'), pendant->toolTip(), Common::tr("Module"),
                       shortcutText(*pendant), pendant->toolTip(),
                       [pendant] { return pendant->isEnabled() ? QString() : pendant->toolTip(); },
                       [pendant] { pendant->trigger(); }});
    for (Command* command : page.commands()) {
        if (!command->isVisible())
            continue;
        const auto reason = [command = QPointer(command)] {
            return command ? command->reason() : CommandPalette::tr("Its module is no longer connected.");
        };
        const auto act = [page = QPointer(&page), command = QPointer(command)] {
            if (!page || !command)
                return;
            // It acts on the present state, even if the command's box is not visible.
            page->context().catchUp();
            command->act();
        };
        entries.push_back({command->text().remove(u'&'), command->sentence(),
                           texts::moduleName(page.context().state().info.index), shortcutText(*command),
                           command->toolTip(), reason, act});
    }
}

/// Commands of other modules use values on their pages, which are not visible from here: they are shown there
/// instead of being carried out.
void addOtherModules(ModulePanel& panel, Session& session, Entries& entries) {
    for (const ModuleState& module : session.link().modules) {
        const ModuleIndex index = module.info.index;
        if (&module == session.selected())
            continue;
        const ModulePage* alike = panel.pageLike(session.viewOf(module));
        if (alike == nullptr)
            continue;
        for (const Command* command : alike->commands()) {
            const QString name = command->button()->objectName();
            entries.push_back(
                {command->text().remove(u'&'),
                 command->sentence(),
                 texts::moduleName(index),
                 {},
                 CommandPalette::tr("Press Enter to show it on the module's page. Nothing is sent."),
                 [] { return QString(); },
                 [&panel, &session, index, name] {
                     session.select(index);
                     if (ModulePage* page = panel.page())
                         page->showCommand(name);
                 }});
        }
    }
}

}  // namespace

std::vector<CommandPalette::Entry> paletteEntries(ModulePanel& panel, Session& session, QAction* pendant,
                                                  const QMenuBar& menus) {
    Entries entries;
    if (ModulePage* page = panel.page())
        addPage(*page, pendant, entries);
    // The commands in the menu of the module are those of its page.
    for (const QAction* action : menus.actions())
        if (action->menu() != nullptr && action->menu()->objectName() != u"moduleMenu"_s)
            addMenu(*action->menu(), entries);
    addOtherModules(panel, session, entries);
    return entries;
}

}  // namespace nmc
