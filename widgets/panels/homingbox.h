// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>
#include <optional>

#include "widgets/panels/modulecontext.h"

class QLabel;

namespace nmc {

class Command;
class HomingForm;
class LimitStopBox;

/// Everything about home of one module, of either chip: how it is searched for, progress and result of the
/// search, how well it repeats, and, for a PIC-SERVO, the limit stop. Edits are kept in the settings of the
/// axis; they send nothing.
class HomingBox : public QWidget {
    Q_OBJECT

public:
    /// The object names of a stepper's controls begin with "stepper".
    HomingBox(ModuleContext& context, QWidget* parent);

private:
    void keepRecipe();
    void showModule();
    void refresh();
    void refreshProgress();
    [[nodiscard]] QString whyNotNow() const;
    [[nodiscard]] QString whyLocked() const;
    [[nodiscard]] std::optional<ProcedureReport> report() const;
    [[nodiscard]] QString stages() const;

    ModuleContext& m_context;
    HomingForm* m_form;
    LimitStopBox* m_limitStop = nullptr;
    Command* m_home;
    Command* m_cancel;
    QLabel* m_stages;
    QLabel* m_result;
    QLabel* m_hint;
    std::optional<HomingRecipe> m_shown;  ///< recipe in the settings, as last shown
    QList<ProcedureStage> m_course;       ///< stages of the last search; while there is none, of the next
    int m_reached = -1;                   ///< index of the present stage in m_course
};

}  // namespace nmc
