// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <string_view>

#include "widgets/panels/modulecontext.h"

class QGridLayout;
class QLabel;

namespace nmc {

class Command;
class GlyphLabel;

/// What the details of both chips have in common: two bytes bit by bit under the data sheet's names, then
/// values, then buttons.
class StatusTable : public QWidget {
    Q_OBJECT

public:
    using BitNames = std::array<std::string_view, 8>;
    /// The meaning of a bit, for its tool tip.
    using Meaning = QString (*)(std::size_t bit);

    StatusTable(ModuleContext& context, QWidget* parent);

protected:
    enum class Byte : std::uint8_t { First, Second };

    /// Bits without a name are left out.
    void addBits(Byte byte, const QString& title, const BitNames& names, Meaning meaning);
    /// Adds a value below the bits and earlier values.
    QLabel* addValue(const QString& label, const QString& objectName);
    void addAnalog(const QString& label);
    /// Adds the home register, the raw bytes, and the buttons: this one and Save as home.
    void addEnd(const Command& first);
    /// Shows everything but the values of addValue(). `aux`: the second of the raw bytes, ", inputs %1".
    void showStatus(const QString& aux);

    ModuleContext& m_context;

private:
    void showBits(Byte byte, std::optional<std::uint8_t> value);

    struct Bit {
        GlyphLabel* glyph = nullptr;
        QLabel* value = nullptr;
    };
    std::array<std::array<Bit, 8>, 2> m_bits;
    QGridLayout* m_grid;
    std::array<QGridLayout*, 2> m_bitGrids{};
    int m_line;
    QLabel* m_analog = nullptr;
    QLabel* m_home = nullptr;
    QLabel* m_raw = nullptr;
    Command* m_saveHome = nullptr;
};

}  // namespace nmc
