// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/colourchoice.h"

#include <QAction>
#include <QActionGroup>
#include <QSettings>

#include "widgets/common/palettes.h"
#include "widgets/mainwindow/settingskeys.h"

namespace nmc {

using namespace Qt::StringLiterals;
using settingskeys::kColours;

ColourChoice::ColourChoice(QSettings& settings, QObject* parent) : QObject(parent) {
    auto* group = new QActionGroup(this);
    struct Entry {
        QString name;  ///< of the action, and in the settings
        QString text;
        look::Colours colours;
    };
    for (const Entry& entry : {Entry{u"system"_s, tr("&System"), look::Colours::System},
                               Entry{u"light"_s, tr("&Light"), look::Colours::Light},
                               Entry{u"dark"_s, tr("&Dark"), look::Colours::Dark},
                               Entry{u"highContrast"_s, tr("&High contrast"), look::Colours::HighContrast}}) {
        auto* action = group->addAction(entry.text);
        action->setObjectName(entry.name + u"ColoursAction"_s);
        action->setCheckable(true);
        connect(action, &QAction::triggered, this, [&settings, entry] {
            settings.setValue(kColours, entry.name);
            look::useColours(entry.colours);
        });
        const bool kept = settings.value(kColours).toString() == entry.name;
        if (kept || m_actions.isEmpty()) {
            action->setChecked(true);
            look::useColours(entry.colours);
        }
        m_actions.append(action);
    }
}

}  // namespace nmc
