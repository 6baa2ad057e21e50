// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <optional>

#include "model/sequence/sequence.h"
#include "protocol/moduletype.h"

namespace nmc {

/// The rows of one sequence as an editable table: what is done, with what, how, a number, and a time limit.
/// It changes nothing by itself: edits are emitted as signals and come back by showRows().
class RowsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Do, What, How, Number, Within, ColumnCount };
    enum Role {
        ChoicesRole = Qt::UserRole,  ///< QStringList; the edit role is the index of the chosen one
        RangeRole,                   ///< QPointF; range of a number, from x to y
        DecimalsRole,                ///< decimals of a number; 0: whole numbers only
    };
    using QAbstractTableModel::QAbstractTableModel;

    /// Shows the sequence of that name, or no rows if there is none. `modules`: how many can be selected;
    /// `types`: those that are known, by ModuleIndex. Returns false if everything is as before.
    bool showRows(const Program& program, const std::string& sequence, int modules,
                  const std::vector<ModuleType>& types = {});
    /// Marks the row of a run that is next or in progress.
    void markRow(std::optional<std::size_t> row);
    [[nodiscard]] const std::vector<Action>& rows() const { return m_rows; }
    /// The initial action of a new row.
    [[nodiscard]] Action newRow() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

signals:
    void rowEdited(int row, const nmc::Action& action);

private:
    template <typename Model, typename Row>
    friend void changeRowCount(Model& model, std::vector<Row>& rows, const std::vector<Row>& now);
    /// The content of a cell, and its alternatives.
    struct Cell {
        QStringList choices{};
        int chosen = -1;
        std::optional<double> number{};
        double min = 0.0;
        double max = 0.0;
        int decimals = 0;
        QString text{};  ///< a number with its unit, or a module that cannot be selected
    };
    [[nodiscard]] Cell cell(std::size_t row, int column) const;
    [[nodiscard]] Cell what(std::size_t row) const;
    [[nodiscard]] Cell how(const Action& action) const;
    [[nodiscard]] static Cell number(const Action& action);
    [[nodiscard]] static Cell within(const Action& action);
    [[nodiscard]] bool isIo(ModuleIndex module) const;
    [[nodiscard]] ModuleIndex firstIo() const;
    /// Sets the module, and keeps the pin or output if the module has it; otherwise selects the first one.
    void takeModule(action::WaitForInput& wait, ModuleIndex module) const;
    void takeModule(action::SetOutput& set, ModuleIndex module) const;
    [[nodiscard]] std::vector<std::size_t> possibleActions(std::size_t row) const;
    [[nodiscard]] Action actionOf(std::size_t kind, std::size_t row) const;
    void choose(Action& action, std::size_t row, int column, int choice) const;

    Program m_program;
    std::string m_sequence;
    std::vector<Action> m_rows;
    std::vector<std::string> m_callable;  ///< sequences that do not lead back to this one
    QStringList m_names;                  ///< of the modules
    std::vector<ModuleType> m_types;
    std::optional<std::size_t> m_marked;
};

}  // namespace nmc
