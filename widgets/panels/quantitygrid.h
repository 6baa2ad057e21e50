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

/// Returns a grid with the panel's spacing, as the layout of `parent`.
[[nodiscard]] QGridLayout* newGrid(QWidget* parent);
void addRow(QGridLayout* grid, int line, const QString& label, QuantityField* field);
/// Adds the first row for a kind of motion: its label is bold, and names the motion.
void addFirstRow(QGridLayout* grid, int line, const QString& label, QuantityField* field);
/// Aligns the fields of these boxes, which are one below the other, whatever the width of their labels.
void align(std::initializer_list<const QWidget*> boxes);
/// Shows a value that is kept elsewhere, if it has changed and the field does not contain it already, so that
/// the value being typed is kept.
void follow(QuantityField* field, double native, double nativeBefore);

}  // namespace quantitygrid
}  // namespace nmc
