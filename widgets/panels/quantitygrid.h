// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <initializer_list>

class QGridLayout;
class QWidget;

namespace nmc {

class QuantityField;

/// The rows that the boxes of a panel have in common: label, field, unit, other view, and room for buttons.
namespace quantitygrid {

inline constexpr int kButtonColumn = 4;
inline constexpr int kColumns = 5;

/// A grid with the panel's spacing, in the widget that is about to get its layout.
[[nodiscard]] QGridLayout* newGrid(QWidget* parent);
void addRow(QGridLayout* grid, int line, const QString& label, QuantityField* field);
/// The first of a kind of motion: its label is bold, and says which.
void addFirstRow(QGridLayout* grid, int line, const QString& label, QuantityField* field);
/// The fields of these boxes, one below the other, stand in line, whatever their labels are called.
void align(std::initializer_list<const QWidget*> boxes);
/// Shows a value that is kept elsewhere, unless that is what the field stands for already: what is being
/// typed stays as it is.
void follow(QuantityField* field, double native, double nativeBefore);

}  // namespace quantitygrid
}  // namespace nmc
