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

/// A path as it was read from a file or drawn.
struct LoadedPath {
    QString name;
    PathTable table;
    std::vector<PathColumn> axes;  ///< of the table's columns, as they were then
};

/// A path of PIC-SERVO CMC and SC: opened or drawn, looked at, and run (docs/paths.md). GUI thread.
class PathsPage : public QWidget {
    Q_OBJECT

public:
    explicit PathsPage(QWidget* parent = nullptr);
    ~PathsPage() override;

    // Emit nothing.
    void showSession(const LinkState& link, const Machine& machine, const Session::Procedures& procedures);
    void setLatency(Duration latency);
    /// What was read, instead of the path before.
    void showPath(LoadedPath path);
    /// Of a file that is no path; the one before stays.
    void showProblems(const QString& name, const std::vector<PathProblem>& problems,
                      const std::vector<PathColumn>& axes);
    void showNotRead(const FileError& error);
    /// A sequence begins or ends: no path begins beside it.
    void showSequence(bool running);
    /// One of the three above follows.
    void showReading();

signals:
    /// The answer is showPath() or showProblems().
    void openRequested(const QString& file, const std::vector<nmc::PathColumn>& axes);
    void saveRequested(const QString& file, const nmc::FileContent& content);
    /// Its axes are to go there, as to a taught point.
    void placeRequested(const nmc::Point& place);
    void asked(nmc::ModuleIndex module, const nmc::Intent& intent);

private:
    /// Whatever planPath() looks at, of all modules.
    struct Basis;

    QWidget* buildChoice();
    QWidget* buildRun();
    [[nodiscard]] std::vector<PathColumn> axesNow() const;
    [[nodiscard]] const ProcedureReport* report() const;
    [[nodiscard]] bool running() const;
    [[nodiscard]] QString whyNoAxes() const;
    [[nodiscard]] QString whyNotRun() const;
    [[nodiscard]] QString obstacleText() const;
    /// As far as that does not depend on what its modules do.
    [[nodiscard]] QString whyNotMoved() const;
    [[nodiscard]] bool unchanged() const;
    [[nodiscard]] AxisScale scaleOf(ModuleIndex module) const;
    [[nodiscard]] QString question() const;
    void lookForObstacles();
    void refresh();
    void refreshSequences();
    void refreshProgress(const QString& notRun);
    void chooseFile();
    void chooseTarget();
    void draw();
    void moveToStart();
    void ask();
    void run();

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
    QStringList m_about;             ///< what it takes and where it leads: it may have very many points
    std::uint32_t m_connection = 0;  ///< that the path is of
    QString m_problems;              ///< of what was opened or drawn last
    bool m_reading = false;
    bool m_sequenceRuns = false;
    bool m_ran = false;  ///< this path, since it was opened
    Duration m_latency{};
    std::unique_ptr<Basis> m_basis;  ///< of m_obstacle
    std::optional<PathObstacle> m_obstacle;
};

}  // namespace nmc
