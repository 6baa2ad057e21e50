// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>
#include <array>
#include <optional>
#include <vector>

#include "model/response/responsefile.h"

namespace nmc {

/// The runs that are drawn, by their numbers: A and B.
using ShownRuns = std::array<std::optional<int>, 2>;

/// The runs so far, newest first, each with its gains, two boxes that say whether it is drawn as A or B, and
/// a name and a note that the user may write.
class ResponseTable : public QTableWidget {
    Q_OBJECT

public:
    explicit ResponseTable(QWidget* parent = nullptr);

    /// Emits nothing.
    void showRuns(const std::vector<KeptResponse>& runs, const ShownRuns& shown);
    /// The number of the run whose row is the current one.
    [[nodiscard]] std::optional<int> chosen() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// The user has ticked or cleared a box; `which`: 0 is A, 1 is B.
    void shownWanted(int which, int run, bool shown);
    void chosenChanged();
    /// The user has written them.
    void named(int run, const QString& name, const QString& note);

private:
    enum Column { A, B, Run, Name, Module, Time, Kp, Kd, Ki, Overshoot, Settling, Note, kColumns };
    void showRun(int row, const KeptResponse& kept, const ShownRuns& shown);
    QTableWidgetItem* cell(int row, int column);
    [[nodiscard]] int numberAt(int row) const;
    void arrangeRows(const std::vector<KeptResponse>& runs);
};

}  // namespace nmc
