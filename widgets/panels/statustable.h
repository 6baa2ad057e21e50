// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <string_view>

class QGridLayout;
class QLabel;

namespace nmc {

class GlyphLabel;

/// Layout of the details of both chips: two bytes bit by bit under the data sheet's names, then values, then
/// buttons.
class StatusTable : public QWidget {
    Q_OBJECT

public:
    using BitNames = std::array<std::string_view, 8>;
    /// The meaning of a bit, for its tool tip.
    using Meaning = QString (*)(std::size_t bit);

    explicit StatusTable(QWidget* parent = nullptr);

protected:
    enum class Byte : std::uint8_t { First, Second };

    /// `prefix`: of the object names of the bits; bits without a name are left out.
    void addBits(Byte byte, const QString& title, const BitNames& names, Meaning meaning,
                 const QString& prefix);
    /// Adds a value below the bits and earlier values.
    QLabel* addValue(const QString& label, const QString& objectName);
    /// Adds the buttons at the end.
    void addButtons(std::initializer_list<QWidget*> buttons);
    void showBits(Byte byte, std::optional<std::uint8_t> value);

private:
    struct Bit {
        GlyphLabel* glyph = nullptr;
        QLabel* value = nullptr;
    };
    std::array<std::array<Bit, 8>, 2> m_bits;
    QGridLayout* m_grid;
    std::array<QGridLayout*, 2> m_bitGrids{};
    int m_line;
};

}  // namespace nmc
