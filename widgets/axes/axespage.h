// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "model/settings/machine.h"
#include "widgets/axes/axisrow.h"

class QComboBox;
class QGridLayout;
class QRadioButton;

namespace nmc {

class Requests;

/// All axes in one table, for moving them by hand; only one can be held at a time.
class AxesPage : public QWidget {
    Q_OBJECT

public:
    explicit AxesPage(Requests& requests, QWidget* parent = nullptr);

    /// Shows all modules, in their order; the views are valid only during the call.
    void showModules(const std::vector<PanelView>& views, const Machine& machine);
    /// For another connection: slow again.
    void forgetModules();
    void endHold();
    void showSequence(bool running);

private:
    void showJog();
    void refresh();
    void enableAll();
    void makeEarlier(ModuleIndex module);
    [[nodiscard]] std::vector<ModuleIndex> order() const;
    [[nodiscard]] std::vector<ModuleIndex> possibleToEnable() const;
    [[nodiscard]] QString whyNotHomed() const;

    Requests& m_requests;
    Machine m_machine;
    std::vector<AxisRow*> m_axes;
    QGridLayout* m_grid;
    QRadioButton* m_slow;
    QRadioButton* m_fast;
    QComboBox* m_step;
    Command* m_enableAll;
    Command* m_homeAll;
    bool m_sequenceRuns = false;
};

}  // namespace nmc
