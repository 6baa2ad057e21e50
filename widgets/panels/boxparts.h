// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shared by the boxes of a panel.

#include <QString>
#include <cstddef>
#include <string>

class QLineEdit;
class QWidget;

namespace nmc {

class NumberField;

/// Maximum number of characters in the name of an axis, an input or an output.
inline constexpr int kMaxNameLength = 40;

[[nodiscard]] constexpr bool bitOf(unsigned mask, std::size_t bit) {
    return (mask >> bit & 1U) != 0;
}

/// A field for the name that something has on this machine.
[[nodiscard]] QLineEdit* newNameField(const QString& objectName, const QString& accessibleName, QWidget* box);
/// `reason`: why the name cannot be edited; empty if it can.
void setNameLocked(QLineEdit* field, const QString& reason);

/// Show what is kept elsewhere, but not while the user may be typing there. They emit nothing that an edit of
/// the user would.
void showUnlessTyped(QLineEdit* field, const std::string& text);
void showUnlessTyped(NumberField* field, double value);

}  // namespace nmc
