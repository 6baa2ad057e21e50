// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>
#include <array>
#include <optional>
#include <vector>

#include "model/response/responsefile.h"

namespace nmc {

/// The numbers of the runs that are drawn as A and B.
using ShownRuns = std::array<std::optional<int>, 2>;

/// The runs so far, newest first, each with its gains, two boxes that select whether it is drawn as A or B,
/// and a name and a note that the user may edit.
class ResponseTable : public QTableWidget {
    Q_OBJECT

public:
    explicit ResponseTable(QWidget* parent = nullptr);

    /// Emits at most chosenChanged().
    void showRuns(const std::vector<KeptResponse>& runs, const ShownRuns& shown);
    /// Number of the run in the current row.
    [[nodiscard]] std::optional<int> chosen() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// The user has ticked or cleared a box; `which`: 0 is A, 1 is B.
    void shownWanted(int which, int run, bool shown);
    void chosenChanged();
    /// The user has edited the name or the note.
    void named(int run, const QString& name, const QString& note);

private:
    enum Column { A, B, Run, Name, Module, Time, Kp, Kd, Ki, Overshoot, Settling, Note, kColumns };
    void showRun(int row, const KeptResponse& kept, const ShownRuns& shown);
    QTableWidgetItem* cell(int row, int column);
    [[nodiscard]] int numberAt(int row) const;
    void arrangeRows(const std::vector<KeptResponse>& runs);
};

}  // namespace nmc
