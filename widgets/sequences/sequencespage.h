// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoStack>
#include <QWidget>
#include <functional>
#include <optional>

#include "link/dryrun/dryrun.h"
#include "model/module/linkstate.h"
#include "model/sequence/sequencerun.h"
#include "model/settings/machine.h"

class QComboBox;
class QGroupBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QTableView;

namespace nmc {

class Command;
class PointsModel;
class Requests;
class RowsModel;

/// Points and sequences are taught, edited, simulated and run here. Each edit can be undone as one step. What
/// runs a sequence is at the top; the tables below it scroll.
class SequencesPage : public QWidget {
    Q_OBJECT

public:
    explicit SequencesPage(Requests& requests, QWidget* parent = nullptr);

    void showSession(const LinkState& link, const Machine& machine);
    void showRun(const SequenceReport& report);
    void showForesight(const DryRun& dryRun);
    /// The modules have other numbers now: what undoing brings back would mean others.
    void forgetEdits() { m_edits.clear(); }

private:
    class Edit;
    [[nodiscard]] QWidget* buildRun();
    [[nodiscard]] QWidget* buildPoints();
    [[nodiscard]] QWidget* buildSequences();
    [[nodiscard]] QWidget* buildRowButtons(QGroupBox* box);

    void edit(const QString& what, const std::function<void(Program&)>& change);
    void editRows(const QString& what, const std::function<void(Sequence&)>& change);
    void put(const Program& program);
    void showProgram();
    void showAxes();
    void refresh();
    void refreshPoints();
    void refreshRows();
    void refreshRun();

    void teach();
    void start(std::size_t row, bool singleStep);
    void moveRow(int by);
    [[nodiscard]] std::vector<ModuleIndex> chosenAxes() const;
    [[nodiscard]] std::string sequence() const;
    [[nodiscard]] const Point* chosenPoint() const;
    [[nodiscard]] std::optional<std::size_t> chosenRow() const;
    [[nodiscard]] bool running() const { return m_run && !m_run->over(); }
    [[nodiscard]] AxisScale scaleOf(ModuleIndex module) const;
    [[nodiscard]] QString whyNotStarted(const std::string& sequence, std::size_t row,
                                        const Machine& machine) const;
    [[nodiscard]] QString whyNotTaught() const;
    /// Why points and sequences may be used but not changed; empty if they may be changed.
    [[nodiscard]] QString locked() const;

    Requests& m_requests;
    LinkState m_link;
    Machine m_machine;
    std::optional<SequenceReport> m_run;
    bool m_foreseeing = false;
    QString m_named;  ///< the sequence that the field for its name shows
    QUndoStack m_edits;

    PointsModel* m_points;
    RowsModel* m_rows;
    QTableView* m_pointTable = nullptr;
    QTableView* m_rowTable = nullptr;
    QLineEdit* m_pointName = nullptr;
    QListWidget* m_axes = nullptr;
    QComboBox* m_sequence = nullptr;
    QLineEdit* m_sequenceName = nullptr;
    QLabel* m_state = nullptr;
    QLabel* m_foresight = nullptr;
    Command* m_teach = nullptr;
    Command* m_goTo = nullptr;
    Command* m_removePoint = nullptr;
    Command* m_newSequence = nullptr;
    Command* m_removeSequence = nullptr;
    Command* m_addRow = nullptr;
    Command* m_removeRow = nullptr;
    Command* m_duplicateRow = nullptr;
    Command* m_rowUp = nullptr;
    Command* m_rowDown = nullptr;
    Command* m_undo = nullptr;
    Command* m_redo = nullptr;
    Command* m_start = nullptr;
    Command* m_startHere = nullptr;
    Command* m_pause = nullptr;
    Command* m_step = nullptr;
    Command* m_stop = nullptr;
    Command* m_foresee = nullptr;
};

}  // namespace nmc
