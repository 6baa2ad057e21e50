// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QWidget>
#include <array>
#include <optional>

#include "model/intent.h"
#include "widgets/panels/gainsmeaning.h"

class QLabel;
class QPushButton;

namespace nmc {

class GlyphLabel;
class NumberField;

/// The gains of one servo. They cannot be read back, so each says whether it was sent in this connection.
/// Edits are staged per module; Apply sends all of them at once.
class GainsBox : public QWidget {
    Q_OBJECT

public:
    explicit GainsBox(QWidget* parent = nullptr);

    /// Emits nothing. `refused`: why gains cannot be applied at all now.
    void showModule(const ModuleState& module, std::optional<Refusal> refused);
    /// A click was passed on; Apply waits for the module's next word.
    void setBusy(bool busy);

signals:
    void applyRequested(const nmc::servo::SetGain& gains);

private:
    enum class Known : std::uint8_t { Unknown, Sent, Edited };
    struct Row {
        Gain gain = Gain::Kp;
        QLabel* label = nullptr;
        NumberField* field = nullptr;
        QLabel* remark = nullptr;
        QLabel* state = nullptr;
    };
    using Draft = std::array<QString, kAllGains.size()>;

    void addRow(Gain gain, int row, class QGridLayout* grid);
    void fillIn();
    void revert();
    void apply();
    void refresh();
    void refreshRow(Row& row);
    [[nodiscard]] bool used(Gain gain) const { return gain != Gain::Db || m_hasDeadband; }
    [[nodiscard]] std::optional<servo::SetGain> entered() const;
    [[nodiscard]] QString trouble() const;
    void keepDraft();

    std::array<Row, kAllGains.size()> m_rows;
    QLabel* m_hint;
    QPushButton* m_apply;
    QPushButton* m_revert;
    QPushButton* m_fill;
    QHash<int, Draft> m_drafts;  ///< per module; gone with the window
    std::optional<ModuleIndex> m_module;
    std::optional<servo::SetGain> m_sent;
    std::optional<Refusal> m_refused;
    bool m_hasDeadband = true;
    bool m_live = false;
    bool m_busy = false;
};

}  // namespace nmc
