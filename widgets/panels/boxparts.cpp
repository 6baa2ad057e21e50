// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/boxparts.h"

#include "widgets/common/form.h"
#include "widgets/common/sharedwords.h"

namespace nmc {

QLineEdit* newNameField(const QString& objectName, const QString& accessibleName, QWidget* box) {
    return form::newText({.name = objectName,
                          .accessible = accessibleName,
                          .maxLength = kMaxNameLength,
                          .meaning = Common::tr("Its name on this machine. Sends nothing."),
                          .example = Common::tr("name")},
                         box);
}

void showUnlessTyped(QLineEdit* field, const std::string& text) {
    if (const QString shown = QString::fromStdString(text); field->text() != shown && !field->hasFocus())
        field->setText(shown);
}

void showUnlessTyped(NumberField* field, double value) {
    if (field->value() != value && !field->hasFocus())
        field->showValue(value);
}

}  // namespace nmc
