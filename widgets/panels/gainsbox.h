// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QWidget>
#include <array>
#include <functional>
#include <optional>

#include "widgets/panels/gainsmeaning.h"
#include "widgets/panels/panelview.h"

class QComboBox;
class QLabel;
class QPushButton;
class QUndoStack;

namespace nmc {

class NumberField;

/// The gains of one servo. They cannot be read back, so each says whether it was sent in this connection.
/// Edits are staged per module and can be undone; Apply sends all of them at once.
class GainsBox : public QWidget {
    Q_OBJECT

public:
    explicit GainsBox(QWidget* parent = nullptr);
    ~GainsBox() override;

    /// Emits nothing.
    void showModule(const PanelView& view);
    /// A click was passed on; Apply waits for the module's next word.
    void setBusy(bool busy);
    /// Fills the fields of the module that is shown, as an edit that can be undone; sends nothing.
    void stage(const servo::SetGain& gains);

signals:
    void stepResponseWanted();
    void applyRequested(const nmc::servo::SetGain& gains);
    void settingsEdited(const nmc::SettingsEdit& edit);

private:
    enum class Known : std::uint8_t { Unknown, Sent, Edited };
    /// What stands in the fields, values or not.
    using Texts = std::array<QString, kAllGains.size()>;
    class Edit;
    struct Row {
        Gain gain = Gain::Kp;
        QLabel* label = nullptr;
        NumberField* field = nullptr;
        QLabel* remark = nullptr;
        QLabel* state = nullptr;
    };

    void addRow(Gain gain, int row, class QGridLayout* grid);
    void addSense(int line, class QGridLayout* grid);
    void addButtons(int line, class QGridLayout* grid);
    QPushButton* newButton(const QString& icon, const QString& text, const QString& objectName,
                           const QString& name, const QString& toolTip);
    /// By the user's hand, in one field or in all (`gain` empty).
    void edited(std::optional<Gain> gain);
    void fill(const std::function<std::optional<int>(Gain)>& value);
    void revert();
    void apply();
    void askBeforeLargeStep(const servo::SetGain& gains, const QStringList& steps);
    void chooseSense(int sense);
    [[nodiscard]] Texts shown() const;
    void show(const Texts& texts);
    [[nodiscard]] Texts textsOf(const std::optional<servo::SetGain>& gains) const;
    [[nodiscard]] QUndoStack& undoStack();
    void keep();
    void refresh();
    void refreshRow(Row& row);
    void refreshApply(const QString& problem);
    void refreshUndo();
    [[nodiscard]] QString hint() const;
    [[nodiscard]] Row& rowOf(Gain gain) { return m_rows[static_cast<std::size_t>(gain)]; }
    [[nodiscard]] const Row& rowOf(Gain gain) const { return m_rows[static_cast<std::size_t>(gain)]; }
    [[nodiscard]] bool used(Gain gain) const { return gain != Gain::Db || m_hasDeadband; }
    [[nodiscard]] std::optional<servo::SetGain> entered() const;
    [[nodiscard]] QString trouble() const;

    std::array<Row, kAllGains.size()> m_rows;
    QComboBox* m_sense = nullptr;
    QLabel* m_hint;
    QPushButton* m_apply = nullptr;
    QPushButton* m_revert = nullptr;
    QPushButton* m_fill = nullptr;
    QPushButton* m_zero = nullptr;
    QPushButton* m_undo = nullptr;
    QPushButton* m_redo = nullptr;
    /// Typed and not sent.
    struct Draft {
        Texts texts;
        /// What the axis had then: others since, from a machine file, win.
        std::optional<servo::SetGain> axis;
    };
    QHash<int, Draft> m_drafts;  ///< of modules whose fields differ from what was sent
    QHash<int, QUndoStack*> m_undoStacks;
    Texts m_before;  ///< what stood there before the edit that is being made
    std::optional<ModuleIndex> m_module;
    AxisSettings m_settings;
    std::optional<servo::SetGain> m_sent;
    std::optional<Refusal> m_refused;
    bool m_hasDeadband = true;
    bool m_live = false;
    bool m_busy = false;
};

}  // namespace nmc
