// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "widgets/panels/stagedform.h"

namespace nmc {

/// How a PIC-SERVO SC drives its amplifier, what its limit inputs do by themselves, and what it keeps across
/// a power cycle (docs/family.md). A wrong choice can destroy an amplifier, so all of this is sent only after
/// confirmation and while the motor is off, except for the step multiplier, which is sent with the gains.
class AmplifierBox : public StagedForm {
    Q_OBJECT

public:
    AmplifierBox(ModuleContext& context, QWidget* parent);

private:
    [[nodiscard]] std::optional<Values> kept() const override;
    [[nodiscard]] std::optional<Values> sent() const override;
    void keep() override;
    [[nodiscard]] QString remark(std::size_t, const std::optional<int>&) const override { return {}; }
    void refreshRest() override;

    void buildDrive(FormGrid& grid);
    void buildSaved(FormGrid& grid);
    void addSetting(FormGrid& grid, const form::Check& check);
    [[nodiscard]] QCheckBox* newBox(const QString& objectName, const QString& text, const QString& meaning);
    /// Empty while it is not selected what the limit inputs do.
    [[nodiscard]] std::optional<servo::ScIoControl> wanted() const;
    [[nodiscard]] servo::HardReset wantedSaved() const;
    void apply();
    void save();
    void erase();
    void setMultiplier();
    /// Asks for confirmation before anything that outlives this panel or could destroy something. The
    /// question is about what the page says when it is answered, and is withdrawn when `of` is no longer
    /// possible.
    void question(const QString& name, const QString& title, const Command& of,
                  const std::function<QString()>& text, const QString& verb,
                  const std::function<Intent()>& intent);
    [[nodiscard]] QString stateText() const;

    QComboBox* m_limits;
    Command* m_apply;
    QLabel* m_state;
    NumberField* m_multiplier;
    Command* m_setMultiplier;
    QCheckBox* m_savesAddress;
    QCheckBox* m_savesAmplifier;
    QCheckBox* m_savesServo;
    Command* m_save;
    Command* m_erase;
    std::optional<Values> m_edited;  ///< for as long as the connection lasts
};

}  // namespace nmc
