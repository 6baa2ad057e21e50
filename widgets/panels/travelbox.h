// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <array>

#include "widgets/panels/modulecontext.h"

class QComboBox;
class QLabel;

namespace nmc {

class Command;
class FormGrid;
class NumberField;
class QuantityField;

/// How far and how fast an axis may go (model/intent/travel.h): its travel limits, counted from home, whether
/// they are in force, the user's confirmation of its position if no search can find it, its backlash, and
/// when a move has arrived.
class TravelBox : public QGroupBox {
    Q_OBJECT

public:
    /// The object names of a stepper's controls begin with "stepper".
    TravelBox(ModuleContext& context, QWidget* parent);

private:
    enum Limit : std::size_t { Lowest, Highest };

    void buildLimit(FormGrid* grid, Limit limit);
    void buildFastest(FormGrid* grid);
    void buildBacklash(FormGrid* grid);
    void keepBacklash();
    void buildArrival(FormGrid* grid);
    void keepArrival();
    void buildWord(FormGrid* grid);
    [[nodiscard]] std::optional<std::int32_t>& of(TravelSettings& travel, Limit limit) const;
    /// True if the field is empty or has a number within its range.
    [[nodiscard]] static bool usable(const NumberField& field);
    [[nodiscard]] std::vector<QuantityField*> quantities() const;
    [[nodiscard]] bool crossed() const;
    [[nodiscard]] bool homeIsOutOfReach() const;
    void keep();
    void takePosition(Limit limit);
    void askToDeclare();
    void showModule();
    void showField(QuantityField& field, std::optional<double> native);
    void refresh();

    ModuleContext& m_context;
    std::array<QuantityField*, 2> m_limits{};
    std::array<Command*, 2> m_here{};
    QuantityField* m_fastest = nullptr;
    QuantityField* m_backlash = nullptr;
    QComboBox* m_side = nullptr;
    QuantityField* m_tolerance = nullptr;  ///< null for a stepper, as is m_duration
    NumberField* m_duration = nullptr;
    QLabel* m_state = nullptr;
    Command* m_declare = nullptr;
    Command* m_doubt = nullptr;
    QLabel* m_hint = nullptr;
    std::optional<TravelSettings> m_shown;
    std::optional<BacklashSettings> m_shownBacklash;
    std::optional<ArrivalSettings> m_shownArrival;
};

}  // namespace nmc
