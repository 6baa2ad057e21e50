// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <optional>

#include "widgets/panels/gainsmeaning.h"
#include "widgets/panels/modulecontext.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QUndoStack;

namespace nmc {

class Command;
class NumberField;

/// The gains of one servo. They cannot be read back, so each shows whether it was sent in this connection.
/// Edits are staged per module and can be undone; Apply sends all of them at once.
class GainsBox : public QWidget {
    Q_OBJECT

public:
    GainsBox(ModuleContext& context, QWidget* parent);
    ~GainsBox() override;

    /// Adapts to a width in pixels: if it is small, marks replace words; if it is very small, letters replace
    /// names.
    void fitInto(int width);
    /// Fills the fields, as an edit that can be undone; sends nothing.
    void stage(const servo::SetGain& gains);

signals:
    void responseWanted();

private:
    enum class Known : std::uint8_t { Unknown, Sent, Edited };
    /// The contents of the fields, valid or not.
    using Texts = std::array<QString, kAllGains.size()>;
    class Edit;
    struct Row {
        Gain gain = Gain::Kp;
        QLabel* label = nullptr;
        NumberField* field = nullptr;
        QLabel* remark = nullptr;
        QLabel* state = nullptr;
    };

    void addRow(Gain gain, int row, QGridLayout* grid);
    void addSense(int line, QGridLayout* grid);
    void addButtons(int line, QGridLayout* grid);
    [[nodiscard]] static QString fullName(Gain gain);
    void nameRows(bool letters);
    void arrange(bool narrow);
    /// Records an edit by the user, of one field or, if `gain` is empty, of all.
    void edited(std::optional<Gain> gain);
    void fill(const std::function<std::optional<int>(Gain)>& value);
    void revert();
    void apply();
    void tryThem();
    [[nodiscard]] bool tries() const;
    void askBeforeLargeStep(const servo::SetGain& gains, const QStringList& steps);
    void chooseSense(int sense);
    [[nodiscard]] Texts shown() const;
    void fillIn(const Texts& texts);
    void show(const Texts& texts);
    [[nodiscard]] Texts textsOf(const std::optional<servo::SetGain>& gains) const;
    void keep();
    void showModule();
    void refresh();
    void refreshRow(Row& row);
    void refreshApply(const QString& problem);
    void refreshTry(const QString& problem);
    void refreshUndo();
    [[nodiscard]] QString hint() const;
    [[nodiscard]] Row& rowOf(Gain gain) { return m_rows[static_cast<std::size_t>(gain)]; }
    [[nodiscard]] const Row& rowOf(Gain gain) const { return m_rows[static_cast<std::size_t>(gain)]; }
    [[nodiscard]] bool used(Gain gain) const;
    [[nodiscard]] std::optional<servo::SetGain> entered() const;
    [[nodiscard]] QString trouble() const;

    ModuleContext& m_context;
    std::array<Row, kAllGains.size()> m_rows;
    QComboBox* m_sense = nullptr;
    QLabel* m_hint;
    Command* m_apply = nullptr;
    Command* m_revert = nullptr;
    Command* m_try = nullptr;
    Command* m_keep = nullptr;
    Command* m_undo = nullptr;
    Command* m_redo = nullptr;
    std::array<Command*, 9> m_buttons{};
    QGridLayout* m_buttonGrid = nullptr;
    bool m_narrow = false;
    int m_wideWidth = 0;  ///< pixels that the wide layout needs
    QUndoStack* m_edits;
    Texts m_before;        ///< contents before the present edit
    bool m_typed = false;  ///< edited since the gains were sent or a machine file was opened
    /// The gains of the axis and those that were sent, both as last shown.
    std::optional<servo::SetGain> m_kept;
    std::optional<servo::SetGain> m_sent;
    std::optional<servo::SetGain> m_tried;  ///< the last gains that were requested to be tried
};

}  // namespace nmc
