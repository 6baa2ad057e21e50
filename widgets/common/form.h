// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QLayout>
#include <QString>
#include <QVariant>
#include <initializer_list>

#include "widgets/common/foldinggrid.h"
#include "widgets/common/quantityfield.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QRadioButton;

namespace nmc {

/// What forms are made of: controls, each described by one value, and the grid that they stand in. A control
/// is a child of the box that it is made for. Texts have been translated by the caller. GUI thread.
namespace form {

/// A field for a number that belongs to no axis.
struct Number {
    QString name;        ///< object name
    QString accessible;  ///< read out
    QString words{};     ///< the quantity in sentences about the field; empty: as read out
    QString unit{};      ///< the unit in these sentences
    double min = 0;
    double max = 0;
    int decimals = 0;   ///< 0: whole numbers only
    int digits = 11;    ///< width of the field
    QString meaning{};  ///< tool tip
    QString unknown{};  ///< shown while the field is empty
};
[[nodiscard]] NumberField* newNumber(const Number& number, QWidget* box);

/// A field for a position, distance, velocity or acceleration of an axis.
struct Quantity {
    QuantityField::Kind kind;
    QString name;        ///< object name
    QString accessible;  ///< read out
    QString words{};     ///< the quantity in sentences about the field; empty: as read out
    double min = 0;      ///< in the chip's numbers, as are `max` and `step`
    double max = 0;
    double step = 1;    ///< of an arrow key
    int digits = 11;    ///< width of the field
    QString meaning{};  ///< tool tip
    QString unknown{};  ///< shown while the field is empty
};
[[nodiscard]] QuantityField* newQuantity(const Quantity& quantity, QWidget* box);

/// A check box, radio button or push button.
struct Check {
    QString name;  ///< object name
    QString text;
    QString accessible{};  ///< read out; empty: `text` without its &
    QString meaning{};     ///< tool tip
};
[[nodiscard]] QCheckBox* newCheck(const Check& check, QWidget* box);
[[nodiscard]] QRadioButton* newRadio(const Check& check, QWidget* box);
[[nodiscard]] QPushButton* newPush(const Check& check, QWidget* box);

struct Option {
    QString text;
    QVariant value{};
};
/// A box from which one of several values is chosen.
struct Choice {
    QString name;        ///< object name
    QString accessible;  ///< read out
    QList<Option> options{};
    QString meaning{};  ///< tool tip
};
[[nodiscard]] QComboBox* newChoice(const Choice& choice, QWidget* box);
/// The value that is chosen in a box whose options are of type T.
template <typename T>
[[nodiscard]] T chosen(const QComboBox* choice) {
    return static_cast<T>(choice->currentData().toInt());
}
/// Chooses the option with that value, or none if there is no such option.
template <typename T>
void choose(QComboBox* choice, T value) {
    choice->setCurrentIndex(choice->findData(static_cast<int>(value)));
}

/// Offers that many modules, under their present names, after the first `others` options. Emits nothing.
void offerModules(QComboBox* choice, int others, int modules);

/// A field for a text.
struct Text {
    QString name;        ///< object name
    QString accessible;  ///< read out
    int maxLength = 32'767;
    QString meaning{};  ///< tool tip
    QString example{};  ///< shown while the field is empty
};
[[nodiscard]] QLineEdit* newText(const Text& text, QWidget* box);

/// A label that names the control beside it.
[[nodiscard]] QLabel* newLabel(const QString& text, QWidget* control);
void setBold(QLabel* label);
/// A label in bold.
[[nodiscard]] QLabel* newHeading(const QString& text, QWidget* box);
/// A label of plain text in as many lines as it needs. Without `what`, it is a remark that is read out only
/// with its text. It keeps room for that many `lines`, so that nothing moves when its text changes.
[[nodiscard]] QLabel* newParagraph(const QString& name, const QString& what, QWidget* box, int lines = 0);
/// A muted label in as many lines as it needs.
[[nodiscard]] QLabel* newRemark(const QString& text, QWidget* box, const QString& name = {});

/// What a line, a column or a row of a grid is filled with: a widget, a layout, or nullptr for empty space.
/// An item with a `stretch` factor takes up the remaining space, which in a grid is all remaining columns.
class Item {
public:
    Item(QWidget* widget, int stretch = 0) : m_widget(widget), m_stretch(stretch) {}
    Item(QLayout* layout, int stretch = 0) : m_layout(layout), m_stretch(stretch) {}
    Item(std::nullptr_t /*room*/) {}

    void addTo(QBoxLayout& line) const;
    void addTo(QGridLayout& grid, int row, int column, int columns) const;
    [[nodiscard]] bool stretches() const { return m_stretch > 0; }

private:
    QWidget* m_widget = nullptr;
    QLayout* m_layout = nullptr;
    int m_stretch = 0;
};
/// A spacing: that of the layout around, or else of the style.
inline constexpr double kUsual = -1;
/// Makes a line of items, from left to right. `spacing` is in units of look::gridUnit(box).
[[nodiscard]] QHBoxLayout* newLine(QWidget* box, std::initializer_list<Item> items, double spacing = 1);
/// Makes a column of items, from top to bottom.
[[nodiscard]] QVBoxLayout* newColumn(QWidget* box, std::initializer_list<Item> items, double spacing = 1);
/// Fills the box with `content`, and leaves a margin of `around` units.
void fill(QWidget* box, QLayout* content, double around = 0);
/// Removes all widgets from the layout.
void clear(QLayout& line);

}  // namespace form

/// A grid that is filled row by row: a label, the control that it names, and what belongs beside that, each
/// in the next column.
class FormGrid : public FoldingGrid {
    Q_OBJECT

public:
    /// In units of look::gridUnit(box).
    struct Spacing {
        double sides = 1;         ///< left and right of the grid
        double ends = 0.5;        ///< above and below it
        double across = 2.0 / 3;  ///< between columns
        double down = 1.0 / 3;    ///< between rows
    };
    FormGrid(QWidget* box, int columns, const Spacing& spacing);
    /// For quantities, with room for buttons beside them: label, field, unit, value in the other unit,
    /// buttons.
    explicit FormGrid(QWidget* box) : FormGrid(box, 5, {}) {}

    /// Adds a row; returns its label.
    QLabel* addRow(const QString& label, QWidget* control, std::initializer_list<form::Item> beside = {});
    /// The unit of the field and its value in the other unit come before what is beside it.
    QLabel* addRow(const QString& label, QuantityField* field, std::initializer_list<form::Item> beside = {});
    /// Adds a row of items, one in each column.
    void addLine(std::initializer_list<form::Item> items);
    /// Adds a row whose label names all of `content`, which takes the columns after it; returns the label.
    QLabel* addTitled(const QString& label, const form::Item& content);
    /// Adds a row that `content` takes from that column on.
    void addWide(const form::Item& content, int column = 0);
    /// Leaves a gap of that height, in units of look::gridUnit(box).
    void addGap(double height);
    /// The rows above keep their height; room that is left goes below them.
    void end() { setRowStretch(m_row, 1); }
    /// The row that is added next.
    [[nodiscard]] int row() const { return m_row; }

    /// Aligns the controls of boxes one below the other, whatever the width of their labels.
    static void align(std::initializer_list<const QWidget*> boxes);

private:
    QLabel* addLabel(const QString& text, QWidget* buddy);
    void addFrom(int column, std::initializer_list<form::Item> items);

    int m_columns;
    int m_row = 0;
};

}  // namespace nmc
