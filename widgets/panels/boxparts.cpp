// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/boxparts.h"

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"

namespace nmc {

QLineEdit* newNameField(const QString& objectName, const QString& accessibleName, QWidget* box) {
    QLineEdit* field = form::newText({.name = objectName,
                                      .accessible = accessibleName,
                                      .maxLength = kMaxNameLength,
                                      .example = Common::tr("name")},
                                     box);
    setNameLocked(field, {});
    return field;
}

void setNameLocked(QLineEdit* field, const QString& reason) {
    look::setPossible(field, reason, Common::tr("Its name on this machine. Sends nothing."));
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
