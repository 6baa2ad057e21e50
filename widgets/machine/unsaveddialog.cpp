// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/machine/unsaveddialog.h"

#include <QPushButton>

#include "widgets/common/texts.h"

namespace nmc {

using namespace Qt::StringLiterals;

UnsavedDialog::UnsavedDialog(Before before, const QString& machine, QWidget* parent)
    : AskDialog({u"unsavedDialog"_s, tr("Unsaved changes"), texts::notSaved(machine),
                 before == Before::Closing ? tr("&Save and close") : tr("&Save them"), u"saveFirstButton"_s,
                 tr("S&tay"), u"stayUnsavedButton"_s, u"unsavedText"_s},
                parent) {
    auto* save = findChild<QPushButton*>(u"saveFirstButton"_s);
    save->setDefault(true);
    QPushButton* goOn = addChoice(before == Before::Closing ? tr("&Close: the next start offers them again")
                                                            : tr("&Drop them: the changes are lost"),
                                  u"goOnUnsavedButton"_s);
    // After accept(): what follows may open a dialog of its own.
    connect(save, &QPushButton::clicked, this, &UnsavedDialog::saveChosen);
    connect(goOn, &QPushButton::clicked, this, &UnsavedDialog::goOnChosen);
}

}  // namespace nmc
