// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "link/files/machineio.h"
#include "model/path/pathfile.h"
#include "model/path/pathplan.h"
#include "widgets/common/filedialog.h"
#include "widgets/mainwindow/session.h"

class QComboBox;
class QLabel;
class QProgressBar;

namespace nmc {

class Command;
class PathPlot;
class Requests;

/// A path as it was read from a file or drawn.
struct LoadedPath {
    QString name;
    PathTable table;
    std::vector<PathColumn> axes;  ///< of the table's columns, when it was read or drawn
    /// Of the axes, when it was drawn: its points count from there. Empty if it was read.
    std::vector<HomeFact::Origin> origins;
};

/// Opens or draws a path for PIC-SERVO CMC and SC, shows it, and runs it (docs/paths.md). GUI thread.
class PathsPage : public QWidget {
    Q_OBJECT

public:
    explicit PathsPage(Requests& requests, QWidget* parent = nullptr);
    ~PathsPage() override;

    // These emit nothing.
    void showSession(const LinkState& link, const Machine& machine, const Session::Procedures& procedures);
    /// Shows the path that was read, instead of the previous one; ignored if its chain is gone, as are the
    /// problems of a file.
    void showPath(LoadedPath path);
    /// Shows the problems of a file that is not a path; the previous path stays.
    void showProblems(const QString& name, const std::vector<PathProblem>& problems,
                      const std::vector<PathColumn>& axes);
    void showNotRead(const FileError& error);
    /// A sequence has started or ended; no path can be started while one is running.
    void showSequence(bool running);
    /// A file is being read; showPath(), showProblems() or showNotRead() follows.
    void showReading();

private:
    /// Everything that planPath() takes into account, for all modules.
    struct Basis;

    QWidget* buildChoice();
    QWidget* buildRun();
    [[nodiscard]] std::vector<PathColumn> axesNow() const;
    [[nodiscard]] const ProcedureReport* report() const;
    [[nodiscard]] bool running() const;
    [[nodiscard]] QString whyNoAxes() const;
    [[nodiscard]] QString whyNotRun() const;
    [[nodiscard]] QString obstacleText() const;
    /// Why the axes cannot move to the start, as far as that does not depend on what the modules are doing.
    [[nodiscard]] QString whyNotMoved() const;
    /// Why they cannot move there now, if they could otherwise.
    [[nodiscard]] QString whyNotToStart() const;
    [[nodiscard]] Point start() const;
    [[nodiscard]] QString whyOutdated() const;
    [[nodiscard]] AxisScale scaleOf(ModuleIndex module) const;
    [[nodiscard]] QString question() const;
    void lookForObstacles();
    void refresh();
    void refreshSequences();
    void refreshProgress(const QString& notRun);
    void chooseFile();
    void chooseTarget();
    void draw();
    void ask();
    void run();

    Requests& m_requests;
    Command* m_open = nullptr;
    Command* m_save = nullptr;
    Command* m_draw = nullptr;
    Command* m_toStart = nullptr;
    Command* m_run = nullptr;
    Command* m_end = nullptr;
    QComboBox* m_sequence = nullptr;
    QComboBox* m_rate = nullptr;
    QLabel* m_summary = nullptr;
    QLabel* m_state = nullptr;
    QProgressBar* m_progress = nullptr;
    PathPlot* m_plot = nullptr;

    LinkState m_link;
    Machine m_machine;
    Session::Procedures m_procedures;
    std::shared_ptr<const LoadedPath> m_path;
    QStringList m_about;             ///< length and reach; kept, because there may be very many points
    std::uint32_t m_connection = 0;  ///< connection that the path, or the file being read, belongs to
    QString m_problems;              ///< of the file or drawing that was last tried
    bool m_reading = false;
    bool m_sequenceRuns = false;
    bool m_ran = false;              ///< this path has been run since it was opened
    std::unique_ptr<Basis> m_basis;  ///< state for which m_obstacle was determined
    std::optional<PathObstacle> m_obstacle;
};

}  // namespace nmc
