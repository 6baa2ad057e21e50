// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>

#include "widgets/panels/modulecontext.h"

class QCheckBox;
class QLabel;

namespace nmc {

class Command;
class FormGrid;
class NumberField;
class QuantityField;

/// The box that provides the velocity of such moves, and the intent that requests them.
class MovesBy {
public:
    virtual ~MovesBy() = default;
    /// Why such moves are not possible; empty if the box has every value that they need.
    [[nodiscard]] virtual QString whyNoMovesBy() const = 0;
    /// Empty if a value is missing.
    [[nodiscard]] virtual std::optional<Intent> movesBy(const Rounds& moves) const = 0;
};

/// Step by N: one click is one move of exactly this distance, or a series of them.
class MoveByBox : public QGroupBox {
    Q_OBJECT

public:
    MoveByBox(ModuleContext& context, const MovesBy& motion, QWidget* parent);

    /// A jog wheel was turned by so many steps: one move, and what comes while it lasts becomes the next one.
    /// Returns why nothing moves; empty if it does.
    QString turn(int steps);
    /// Ends what turn() has begun.
    void endTurns();

signals:
    /// Steps of turn() that waited for the present move to end are not possible, for this reason.
    void turnsDropped(const QString& reason);

private:
    void buildDistance(FormGrid* grid);
    void buildRepeat(FormGrid* grid);
    void step(bool reverse);
    void showModule();
    void refresh();
    [[nodiscard]] QString whyNotNow() const;
    [[nodiscard]] QString moveByTurns();
    [[nodiscard]] std::optional<Intent> wanted(bool reverse) const;
    void refreshStep(Command& command, bool reverse, const QString& reason, const QString& meaning);
    [[nodiscard]] double kept() const;

    ModuleContext& m_context;
    const MovesBy& m_motion;
    QuantityField* m_distance = nullptr;
    Command* m_reverse = nullptr;
    Command* m_forward = nullptr;
    NumberField* m_rounds = nullptr;
    NumberField* m_pause = nullptr;
    QCheckBox* m_backAndForth = nullptr;
    Command* m_end = nullptr;
    QLabel* m_progress = nullptr;
    int m_turns = 0;         ///< steps of a jog wheel that wait for the present move to end
    bool m_turning = false;  ///< a move by such steps was requested
    double m_kept = 0;       ///< counts; distance in the settings, as last seen
};

}  // namespace nmc
