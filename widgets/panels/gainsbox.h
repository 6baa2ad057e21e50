// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "widgets/panels/gainsmeaning.h"
#include "widgets/panels/stagedform.h"

namespace nmc {

/// The gains of one servo, which Apply sends all at once.
class GainsBox : public StagedForm {
    Q_OBJECT

public:
    GainsBox(ModuleContext& context, QWidget* parent);

    /// If there is very little room, letters replace names.
    void fitInto(int width) override;
    /// Fills the fields, as an edit that can be undone; sends nothing.
    void stage(const servo::SetGain& gains);

signals:
    void responseWanted();

private:
    [[nodiscard]] std::optional<Values> kept() const override;
    [[nodiscard]] std::optional<Values> sent() const override;
    void keep() override;
    [[nodiscard]] bool used(std::size_t field) const override;
    [[nodiscard]] QString remark(std::size_t field, const std::optional<int>& value) const override;
    void refreshRest() override;
    void arrange() override;

    void addSense(FormGrid* grid);
    void addButtons(FormGrid* grid);
    [[nodiscard]] static QString fullName(Gain gain);
    [[nodiscard]] const Field& fieldOf(Gain gain) const { return field(static_cast<std::size_t>(gain)); }
    void fillWith(const std::function<std::optional<int>(Gain)>& value);
    void chooseSense();
    void apply();
    void tryThem();
    [[nodiscard]] bool tries() const;
    void askBeforeLargeStep(const servo::SetGain& gains, const QStringList& steps);
    [[nodiscard]] std::optional<Values> valuesOf(const std::optional<servo::SetGain>& gains) const;
    /// Those in the fields; empty unless all are valid.
    [[nodiscard]] std::optional<servo::SetGain> gains() const;
    [[nodiscard]] std::optional<servo::SetGain> sentGains() const;
    void refreshApply(const QString& problem);
    void refreshTry(const QString& problem);
    [[nodiscard]] QString hintText() const;

    QComboBox* m_sense = nullptr;
    Command* m_zero = nullptr;
    Command* m_start = nullptr;
    Command* m_apply = nullptr;
    Command* m_try = nullptr;
    Command* m_keep = nullptr;
    std::array<Command*, 9> m_buttons{};
    QGridLayout* m_buttonGrid = nullptr;
    std::optional<servo::SetGain> m_tried;  ///< the last gains that were requested to be tried
};

}  // namespace nmc
