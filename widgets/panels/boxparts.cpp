// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/boxparts.h"

#include <QCoreApplication>

#include "widgets/common/form.h"

namespace nmc {

namespace {
class BoxParts {
    Q_DECLARE_TR_FUNCTIONS(nmc::BoxParts)
};
}  // namespace

QLineEdit* newNameField(const QString& objectName, const QString& accessibleName, QWidget* box) {
    return form::newText({.name = objectName,
                          .accessible = accessibleName,
                          .maxLength = kMaxNameLength,
                          .meaning = BoxParts::tr("Its name on this machine. Sends nothing."),
                          .example = BoxParts::tr("name")},
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
