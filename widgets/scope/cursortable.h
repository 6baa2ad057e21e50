// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>
#include <vector>

#include "model/scope/stretchfigures.h"
#include "widgets/scope/scopestrips.h"

namespace nmc {

/// What the two cursors read: their times and the time between, and for each trace the values, their
/// difference, and what the signal comes to in between.
class CursorTable : public QTableWidget {
    Q_OBJECT

public:
    explicit CursorTable(QWidget* parent = nullptr);

    /// False: not everything is up to date, and another call makes more of it so. At most one signal is gone
    /// through in a call, however many samples it has.
    bool showReadings(const ScopeStrips& strips, const History& history);
    /// How far they are apart.
    [[nodiscard]] static QString between(const CursorTimes& times);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, fontMetrics().height() * 4}; }

private:
    /// What was made of a trace, and of which samples.
    struct Kept {
        ModuleSignal of;
        LinearScale scale;
        CursorTimes times{};
        const ModuleHistory* from = nullptr;
        std::uint64_t samples = 0;
        std::optional<StretchFigures> figures{};
    };
    [[nodiscard]] const std::optional<StretchFigures>& figures(const ScopePlot::Trace& trace,
                                                               const CursorTimes& times,
                                                               const DerivedSignals::Source& source,
                                                               TimePoint zero);
    void make(Kept& kept, const DerivedSignals::Source& source, TimePoint zero);
    void setCell(int row, int column, const QString& text);

    std::vector<Kept> m_kept;
    std::vector<SignalPoint> m_points;  ///< room that is used again
    bool m_made = false;                ///< one of them, in this call
    bool m_upToDate = true;
};

}  // namespace nmc
