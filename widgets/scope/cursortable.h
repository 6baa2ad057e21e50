// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>
#include <vector>

#include "model/scope/stretchfigures.h"
#include "widgets/scope/scopestretch.h"
#include "widgets/scope/scopestrips.h"

namespace nmc {

/// The readings of the two cursors: their times and the time between them and, for each trace, the values,
/// their difference, and the figures of the signal in between.
class CursorTable : public QTableWidget {
    Q_OBJECT

public:
    explicit CursorTable(QWidget* parent = nullptr);

    /// Returns false if not everything is up to date yet, which needs another call. Each call evaluates at
    /// most one signal, however many samples it has.
    bool showReadings(const ScopeStrips& strips, const History& history);
    /// How far apart cursors are, in words.
    [[nodiscard]] static QString between(const CursorTimes& times);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, fontMetrics().height() * 4}; }

private:
    /// The figures of a trace, and the samples from which they were calculated.
    struct Kept {
        ScopeStretch stretch;
        std::optional<StretchFigures> figures{};
    };
    [[nodiscard]] const std::optional<StretchFigures>& figures(const ScopeStretch& stretch);
    void setCell(int row, int column, const QString& text);

    std::vector<Kept> m_kept;
    std::vector<SignalPoint> m_points;  ///< kept only so that its memory is used again
    bool m_made = false;                ///< figures were calculated in this call
    bool m_upToDate = true;
};

}  // namespace nmc
