// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "model/machinefile/axiscopy.h"
#include "model/module/linkstate.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace nmc {

class Requests;

/// Chooses settings of one axis, and the axes of the same type that are to get them. Lists only what differs.
/// Changes and sends nothing: the program then shows the differences. For the chain for which it was opened.
/// Not modal. GUI thread.
class CopyDialog : public QDialog {
    Q_OBJECT

public:
    CopyDialog(const Machine& machine, const LinkState& link, std::optional<ModuleIndex> from,
               Requests& requests, QWidget* window);

    /// True if the chain is still that for which it was opened.
    [[nodiscard]] bool isFor(const LinkState& link) const;
    /// Offers what differs now; what was ticked stays so. Emits nothing.
    void showMachine(const Machine& machine);

private:
    [[nodiscard]] ModuleIndex from() const;
    [[nodiscard]] AxisCopy chosen() const;
    void fill();
    void refresh();

    Machine m_machine;
    const LinkState m_link;
    QComboBox* m_from;
    QListWidget* m_to;
    QListWidget* m_parts;
    QLabel* m_hint;
    QPushButton* m_show;
};

}  // namespace nmc
