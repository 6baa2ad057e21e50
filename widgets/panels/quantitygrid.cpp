// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/quantitygrid.h"

#include <QGridLayout>
#include <QLabel>
#include <algorithm>
#include <vector>

#include "widgets/common/foldinggrid.h"
#include "widgets/common/look.h"
#include "widgets/common/quantityfield.h"

namespace nmc::quantitygrid {

QGridLayout* newGrid(QWidget* parent) {
    const int unit = look::gridUnit(parent);
    auto* grid = new FoldingGrid(parent);
    grid->setContentsMargins(unit, unit / 2, unit, unit / 2);
    grid->setHorizontalSpacing(unit * 2 / 3);
    grid->setVerticalSpacing(unit / 3);
    grid->setColumnStretch(kButtonColumn - 1, 1);
    return grid;
}

namespace {
QLabel* addWithLabel(QGridLayout* grid, int line, const QString& label, QuantityField* field, int columns) {
    auto* name = new QLabel(label, grid->parentWidget());
    name->setBuddy(field);
    field->setDigits(9);
    grid->addWidget(name, line, 0);
    grid->addWidget(field, line, 1);
    grid->addWidget(field->unitLabel(), line, 2);
    grid->addWidget(field->otherView(), line, 3, 1, columns);
    return name;
}
}  // namespace

void addRow(QGridLayout* grid, int line, const QString& label, QuantityField* field) {
    addWithLabel(grid, line, label, field, kColumns - 3);
}

void addFirstRow(QGridLayout* grid, int line, const QString& label, QuantityField* field) {
    QLabel* name = addWithLabel(grid, line, label, field, 1);
    QFont bold = name->font();
    bold.setBold(true);
    name->setFont(bold);
}

void align(std::initializer_list<const QWidget*> boxes) {
    std::vector<QGridLayout*> grids;
    int widest = 0;
    for (const QWidget* box : boxes) {
        auto* grid = qobject_cast<QGridLayout*>(box->layout());
        grids.push_back(grid);
        for (int line = 0; line < grid->rowCount(); ++line)
            if (const QLayoutItem* item = grid->itemAtPosition(line, 0))
                if (const auto* name = qobject_cast<const QLabel*>(item->widget()); name && name->buddy())
                    widest = std::max(widest, name->sizeHint().width());
    }
    for (QGridLayout* grid : grids)
        grid->setColumnMinimumWidth(0, widest);
}

void follow(QuantityField* field, double native, double nativeBefore) {
    if (native != nativeBefore && field->native() != native)
        field->showNative(native);
}

}  // namespace nmc::quantitygrid
