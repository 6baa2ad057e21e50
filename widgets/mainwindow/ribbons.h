// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QLayout;
class QPushButton;
class QWidget;

namespace nmc {

class OperatorLock;
class Pendant;
class Requests;
class Ribbon;
class Session;
struct ModuleState;
struct ProgramsShown;

/// The ribbons at the top of the window: a session that is simulated, read-only, an operator's, open to other
/// programs, lent to one, or moved by the pendant. They stand in this order, and each is visible only while
/// that is so.
class Ribbons : public QObject {
    Q_OBJECT

public:
    Ribbons(Requests& requests, OperatorLock& lock, Pendant& pendant, QWidget* top);

    /// All of them, for the layout of `top`.
    [[nodiscard]] QLayout* column() const { return m_column; }

    void showSession(const Session& session);
    void showPrograms(const ProgramsShown& programs);
    /// `module`: the one that the pendant moves, nullptr if there is none.
    void showPendant(const ModuleState* module);

private:
    [[nodiscard]] QString pendantHelp() const;

    OperatorLock& m_lock;
    Pendant& m_pendant;
    Ribbon* m_simulated;
    Ribbon* m_readOnly;
    Ribbon* m_operator;
    Ribbon* m_programs;
    QPushButton* m_endControl;
    Ribbon* m_lent;
    QPushButton* m_letThrough;
    Ribbon* m_moved;
    QLayout* m_column = nullptr;
};

}  // namespace nmc
