// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/panels/modulecontext.h"

class QCheckBox;
class QComboBox;
class QGroupBox;
class QLabel;

namespace nmc {

class Command;
class FormGrid;
class NumberField;

/// How a PIC-SERVO SC drives its amplifier, what its limit inputs do by themselves, and what it keeps across
/// a power cycle (docs/family.md). A wrong choice can destroy an amplifier, so all of this is sent only after
/// confirmation and while the motor is off, except for the step multiplier, which is sent with the gains.
class AmplifierBox : public QWidget {
    Q_OBJECT

public:
    AmplifierBox(ModuleContext& context, QWidget* parent);

private:
    void buildDrive(FormGrid& grid);
    void buildSaved(FormGrid& grid);
    [[nodiscard]] QCheckBox* newBox(const QString& objectName, const QString& text, const QString& meaning);
    [[nodiscard]] servo::ScIoControl wanted() const;
    [[nodiscard]] servo::HardReset wantedSaved() const;
    void apply();
    void save();
    void erase();
    void setMultiplier();
    /// Asks for confirmation before anything that outlives this panel or could destroy something.
    void question(const QString& name, const QString& title, const QString& text, const QString& verb,
                  const Intent& intent);
    void showModule();
    void refresh();
    [[nodiscard]] QString stateText() const;

    ModuleContext& m_context;
    QCheckBox* m_threePhase;
    QCheckBox* m_antiphase;
    QCheckBox* m_steps;
    QComboBox* m_limits;
    QCheckBox* m_fastPath;
    Command* m_apply;
    QLabel* m_state;
    NumberField* m_multiplier;
    Command* m_setMultiplier;
    QCheckBox* m_savesAddress;
    QCheckBox* m_savesAmplifier;
    QCheckBox* m_savesServo;
    Command* m_save;
    Command* m_erase;
    std::optional<servo::ScIoControl> m_shown;
    std::optional<bool> m_kept;  ///< fast path, as last shown from the machine
};

}  // namespace nmc
