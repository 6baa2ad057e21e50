// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>

#include "widgets/scope/scopestrips.h"

namespace nmc {

/// What the two cursors read: their times and the time between, and for each trace the values and their
/// difference.
class CursorTable : public QTableWidget {
    Q_OBJECT

public:
    explicit CursorTable(QWidget* parent = nullptr);

    void showReadings(const ScopeStrips& strips, const History& history);
    [[nodiscard]] QSize sizeHint() const override;

private:
    void setCell(int row, int column, const QString& text);
};

}  // namespace nmc
