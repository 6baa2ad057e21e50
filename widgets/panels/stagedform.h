// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoStack>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "widgets/common/form.h"
#include "widgets/panels/modulecontext.h"

class QCheckBox;
class QLabel;

namespace nmc {

class Command;

/// Values that one command sends together and that no chip reports, so each shows whether it was sent in this
/// connection. Edits are staged: they are kept with the axis, can be undone, and never reach the motor; Apply
/// sends them all. A box derives from it, adds its fields, and says where their values are kept. GUI thread.
class StagedForm : public QWidget {
    Q_OBJECT

public:
    ~StagedForm() override;

    /// Adapts to a width in pixels: if it is small, marks replace words.
    virtual void fitInto(int width);

protected:
    /// One value for each field, in the order in which they were added; empty: unknown, or not a valid
    /// number.
    using Values = std::vector<std::optional<int>>;

    struct Words {
        QString what;      ///< in object names: "Gains"
        QString undo;      ///< read out
        QString redo;      ///< read out
        QString revert;    ///< read out
        QString sentOnes;  ///< what Revert does: restores those last sent
        QString none;      ///< what Revert does as long as nothing was sent
    };
    StagedForm(ModuleContext& context, const Words& words, QWidget* parent);

    struct Field {
        QWidget* control = nullptr;
        NumberField* number = nullptr;  ///< the control, if it is one
        std::function<std::optional<int>()> value;
        std::function<void(const std::optional<int>&)> show;
        QLabel* label = nullptr;
        QLabel* remark = nullptr;  ///< what the value means
        QLabel* state = nullptr;
    };
    /// What a row says besides its value. Its remark and its state have object names with these endings.
    struct Row {
        QString object;
        QString label;
        QString meaning;
    };
    /// Adds a row: label, control, remark, state.
    void addField(FormGrid* grid, const Row& row, NumberField* control);
    void addField(FormGrid* grid, const Row& row, QComboBox* control);
    void addField(FormGrid* grid, const Row& row, QCheckBox* control);
    /// For a quantity that is sent as another number than the one shown.
    void addField(FormGrid* grid, const Row& row, QuantityField* control,
                  std::function<std::optional<int>()> value,
                  std::function<void(const std::optional<int>&)> show);
    /// Makes the buttons that all forms have. To be called when all fields have been added.
    void buildCommands();
    /// Shows what is kept or was sent, and follows the module from then on. To be called last. Enter in a
    /// field acts like `apply`.
    void begin(Command& apply);

    // ---- what the fields are about ----

    [[nodiscard]] virtual std::optional<Values> kept() const = 0;
    [[nodiscard]] virtual std::optional<Values> sent() const = 0;
    /// Keeps the values, which are complete, with the axis.
    virtual void keep() = 0;
    /// False for a field that this version of the chip does not have.
    [[nodiscard]] virtual bool used(std::size_t /*field*/) const { return true; }
    [[nodiscard]] virtual QString remark(std::size_t field, const std::optional<int>& value) const = 0;
    /// Refreshes everything that is not part of a row.
    virtual void refreshRest() = 0;

    // ---- for the derived box ----

    [[nodiscard]] const Field& field(std::size_t number) const { return m_fields.at(number); }
    [[nodiscard]] Values entered() const;
    /// Every field in use has a valid value.
    [[nodiscard]] bool complete() const;
    /// Every field is empty, and nothing was sent.
    [[nodiscard]] bool unknown() const;
    /// What is wrong with the first field that has no valid value.
    [[nodiscard]] QString trouble() const;
    /// Fills in values, as an edit that can be undone; an empty one leaves its field as it is.
    void fill(const Values& values);
    /// Records an edit by the user: of one field, or of several if `field` is empty.
    void edited(std::optional<std::size_t> field);
    void refresh();

    enum class Mark : std::uint8_t { Unknown, Sent, Edited };
    /// Shows whether a value was sent, as a shape followed by words, or as the shape alone.
    void showMark(QLabel* label, Mark mark) const;

    [[nodiscard]] ModuleContext& context() const { return m_context; }
    [[nodiscard]] bool narrow() const { return m_narrow; }
    [[nodiscard]] QLabel* hint() const { return m_hint; }
    [[nodiscard]] Command* undoCommand() const { return m_undo; }
    [[nodiscard]] Command* redoCommand() const { return m_redo; }
    [[nodiscard]] Command* revertCommand() const { return m_revert; }
    /// Called when narrow() has changed.
    virtual void arrange() {}

private:
    /// What a field contains: its value, or the text that is none.
    struct Content {
        std::optional<int> value;
        QString text;
        bool operator==(const Content&) const = default;
    };
    using Contents = std::vector<Content>;
    class Edit;

    /// Adds the labels of a row around its control. A choice has no remark, only its words.
    void add(FormGrid* grid, const Row& row, Field field);
    [[nodiscard]] Contents contents() const;
    [[nodiscard]] Contents contentsOf(const std::optional<Values>& values) const;
    void fillIn(const Contents& contents);
    /// Shows contents as after an edit.
    void show(const Contents& contents);
    void showModule();
    void refreshRow(std::size_t field);
    void refreshUndo();

    ModuleContext& m_context;
    Words m_words;
    std::vector<Field> m_fields;
    QUndoStack m_edits;
    QLabel* m_hint;
    Command* m_undo = nullptr;
    Command* m_redo = nullptr;
    Command* m_revert = nullptr;
    Contents m_before;             ///< contents before the present edit
    bool m_typed = false;          ///< edited since the values were sent or a machine file was opened
    std::optional<Values> m_kept;  ///< as last shown
    std::optional<Values> m_sent;  ///< as last shown
    bool m_narrow = false;
    int m_wideWidth = 0;  ///< pixels that the layout with words needs
};

}  // namespace nmc
