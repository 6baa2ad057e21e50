// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/form.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <algorithm>
#include <vector>

#include "widgets/common/look.h"
#include "widgets/common/words.h"

namespace nmc {

namespace form {

namespace {

/// What a NumberField and a QuantityField have in common.
template <typename Field, typename Spec>
Field* set(Field* field, const Spec& spec) {
    field->setDigits(spec.digits);
    field->setMeaning(spec.meaning);
    field->setPlaceholderText(spec.unknown);
    return field;
}

template <typename Button>
Button* newButton(const Check& check, QWidget* box) {
    auto* button = new Button(check.text, box);
    look::name(button, check.name,
               check.accessible.isEmpty() ? QString(check.text).remove(u'&') : check.accessible);
    button->setToolTip(check.meaning);
    return button;
}

int pixels(const QWidget* box, double units) {
    return static_cast<int>(look::gridUnit(box) * units);
}

template <typename Layout>
Layout* filled(Layout* layout, const QWidget* box, std::initializer_list<Item> items, double spacing) {
    layout->setSpacing(pixels(box, spacing));
    for (const Item& item : items)
        item.addTo(*layout);
    return layout;
}

}  // namespace

NumberField* newNumber(const Number& number, QWidget* box) {
    auto* field = new NumberField(number.decimals, box);
    look::name(field, number.name, number.accessible);
    field->setRange(number.min, number.max);
    field->setWords(number.words.isEmpty() ? number.accessible : number.words, number.unit);
    return set(field, number);
}

QuantityField* newQuantity(const Quantity& quantity, QWidget* box) {
    auto* field = new QuantityField(quantity.kind, box);
    field->setName(quantity.name, quantity.accessible);
    field->setQuantity(quantity.words.isEmpty() ? quantity.accessible : quantity.words);
    field->setNativeRange(quantity.min, quantity.max);
    field->setNativeStep(quantity.step);
    return set(field, quantity);
}

QCheckBox* newCheck(const Check& check, QWidget* box) {
    return newButton<QCheckBox>(check, box);
}

QRadioButton* newRadio(const Check& check, QWidget* box) {
    return newButton<QRadioButton>(check, box);
}

QPushButton* newPush(const Check& check, QWidget* box) {
    return newButton<QPushButton>(check, box);
}

QComboBox* newChoice(const Choice& choice, QWidget* box) {
    auto* field = new QComboBox(box);
    look::name(field, choice.name, choice.accessible);
    for (const Option& option : choice.options)
        field->addItem(option.text, option.value);
    field->setToolTip(choice.meaning);
    return field;
}

void offerModules(QComboBox* choice, int others, int modules) {
    const QSignalBlocker quiet(choice);
    for (int i = 0; i < modules; ++i) {
        const QString name = texts::moduleName(ModuleIndex(static_cast<std::uint8_t>(i)));
        if (choice->count() == others + i)
            choice->addItem(name);
        else if (choice->itemText(others + i) != name)
            choice->setItemText(others + i, name);
    }
}

QLineEdit* newText(const Text& text, QWidget* box) {
    auto* field = new QLineEdit(box);
    look::name(field, text.name, text.accessible);
    field->setMaxLength(text.maxLength);
    field->setPlaceholderText(text.example);
    field->setToolTip(text.meaning);
    return field;
}

QLabel* newLabel(const QString& text, QWidget* control) {
    auto* label = new QLabel(text, control->parentWidget());
    label->setBuddy(control);
    return label;
}

void setBold(QLabel* label) {
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
}

QLabel* newHeading(const QString& text, QWidget* box) {
    auto* label = new QLabel(text, box);
    setBold(label);
    return label;
}

QLabel* newParagraph(const QString& name, const QString& what, QWidget* box, int lines) {
    auto* label = new QLabel(box);
    if (what.isEmpty())
        label->setObjectName(name);
    else
        look::nameText(label, name, what);
    label->setWordWrap(true);
    if (lines > 0) {
        label->setMinimumHeight(lines * label->fontMetrics().lineSpacing());
        label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    }
    return label;
}

QLabel* newRemark(const QString& text, QWidget* box, const QString& name) {
    QLabel* label = look::newMutedLabel(text, box, name);
    label->setWordWrap(true);
    return label;
}

void Item::addTo(QBoxLayout& line) const {
    if (m_widget != nullptr)
        line.addWidget(m_widget, m_stretch);
    else if (m_layout != nullptr)
        line.addLayout(m_layout, m_stretch);
    else
        line.addStretch(1);
}

void Item::addTo(QGridLayout& grid, int row, int column, int columns) const {
    if (m_widget != nullptr)
        grid.addWidget(m_widget, row, column, 1, columns);
    else if (m_layout != nullptr)
        grid.addLayout(m_layout, row, column, 1, columns);
}

QHBoxLayout* newLine(QWidget* box, std::initializer_list<Item> items, double spacing) {
    return filled(new QHBoxLayout, box, items, spacing);
}

QVBoxLayout* newColumn(QWidget* box, std::initializer_list<Item> items, double spacing) {
    return filled(new QVBoxLayout, box, items, spacing);
}

void fill(QWidget* box, QLayout* content, double around) {
    const int side = pixels(box, around);
    content->setContentsMargins(side, side, side, side);
    box->setLayout(content);
}

void clear(QLayout& line) {
    while (QLayoutItem* item = line.takeAt(0)) {
        // It may be the button whose click is being handled.
        if (QWidget* button = item->widget()) {
            button->hide();
            button->deleteLater();
            button->setObjectName(QString());
        }
        delete item;
    }
}

}  // namespace form

FormGrid::FormGrid(QWidget* box, int columns, const Spacing& spacing) : FoldingGrid(box), m_columns(columns) {
    const int side = form::pixels(box, spacing.sides);
    const int end = form::pixels(box, spacing.ends);
    setContentsMargins(side, end, side, end);
    setHorizontalSpacing(form::pixels(box, spacing.across));
    setVerticalSpacing(form::pixels(box, spacing.down));
    if (columns > 3)
        setColumnStretch(3, 1);
}

QLabel* FormGrid::addLabel(const QString& text, QWidget* buddy) {
    auto* label = new QLabel(text, parentWidget());
    label->setBuddy(buddy);
    addWidget(label, m_row, 0);
    return label;
}

void FormGrid::addFrom(int column, std::initializer_list<form::Item> items) {
    for (const form::Item& item : items) {
        item.addTo(*this, m_row, column, item.stretches() ? m_columns - column : 1);
        ++column;
    }
    ++m_row;
}

QLabel* FormGrid::addRow(const QString& label, QWidget* control, std::initializer_list<form::Item> beside) {
    QLabel* name = addLabel(label, control);
    addWidget(control, m_row, 1);
    addFrom(2, beside);
    return name;
}

QLabel* FormGrid::addRow(const QString& label, QuantityField* field,
                         std::initializer_list<form::Item> beside) {
    QLabel* name = addLabel(label, field);
    addWidget(field, m_row, 1);
    addWidget(field->unitLabel(), m_row, 2);
    addWidget(field->otherView(), m_row, 3, 1, beside.size() == 0 ? m_columns - 3 : 1);
    addFrom(4, beside);
    return name;
}

void FormGrid::addLine(std::initializer_list<form::Item> items) {
    addFrom(0, items);
}

QLabel* FormGrid::addTitled(const QString& label, const form::Item& content) {
    QLabel* name = addLabel(label, nullptr);
    addWide(content, 1);
    return name;
}

void FormGrid::addWide(const form::Item& content, int column) {
    content.addTo(*this, m_row++, column, m_columns - column);
}

void FormGrid::addGap(double height) {
    setRowMinimumHeight(m_row++, form::pixels(parentWidget(), height));
}

void FormGrid::align(std::initializer_list<const QWidget*> boxes) {
    std::vector<QGridLayout*> grids;
    int widest = 0;
    for (const QWidget* box : boxes) {
        auto* grid = qobject_cast<QGridLayout*>(box->layout());
        grids.push_back(grid);
        for (int row = 0; row < grid->rowCount(); ++row)
            if (const QLayoutItem* item = grid->itemAtPosition(row, 0))
                if (const auto* name = qobject_cast<const QLabel*>(item->widget()); name && name->buddy())
                    widest = std::max(widest, name->sizeHint().width());
    }
    for (QGridLayout* grid : grids)
        grid->setColumnMinimumWidth(0, widest);
}

}  // namespace nmc
