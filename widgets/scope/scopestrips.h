// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "widgets/scope/scopeplot.h"
#include "widgets/scope/scopesetup.h"
#include "widgets/scope/timewindow.h"

class QSplitter;

namespace nmc {

class StatusLane;

/// The strips and the lane of status bits, one below the other over the same time, and what the mouse and the
/// wheel do there.
class ScopeStrips : public QWidget {
    Q_OBJECT

public:
    explicit ScopeStrips(QWidget* parent = nullptr);

    void setSetup(const ScopeSetup& setup);
    /// How to read the samples; `selected`: the module whose signals are shown where a strip names no module.
    void setModules(const std::vector<ScopeModule>& modules, std::optional<ModuleIndex> selected);
    /// Shows one frame; `now` is in seconds since the history's zero. The rates are counted once a second.
    /// `sharpness`: device pixels per pixel, if they differ from the screen's.
    void showFrame(const History& history, double now, std::optional<double> sharpness = {});
    /// Call when the data are replaced. The next frame places the cursors again, because their times were
    /// those of the data before.
    void forget();

    [[nodiscard]] TimeWindow& time() { return m_time; }
    [[nodiscard]] const TimeWindow& time() const { return m_time; }
    void showCursors(const std::optional<CursorTimes>& cursors);
    /// Shows them at a third and two thirds of the visible time.
    void placeCursors();
    [[nodiscard]] const std::optional<CursorTimes>& cursors() const { return m_cursors; }
    /// Marks the time of an event, in s.
    void showMarker(const std::optional<double>& seconds);
    /// Shows a recording under the live traces in the following frames, during which it must exist; null:
    /// none.
    void showUnder(const Underlay* under) { m_under = under; }
    /// Shows a trigger's level in the strips that show its signal.
    void showLevel(std::optional<std::pair<SignalRef, double>> level);

    void fitValues();
    void zoomValues(double factor);
    void panValues(double share);
    /// Shows the whole of `history`.
    void showEverything(const History& history);

    [[nodiscard]] const std::vector<ScopeModule>& modules() const { return m_modules; }
    [[nodiscard]] std::optional<ModuleIndex> selected() const { return m_selected; }
    [[nodiscard]] std::vector<ScopePlot*> shownPlots() const;
    [[nodiscard]] std::vector<ModuleSignal> shownSignals() const;
    /// Those of the user among them.
    [[nodiscard]] std::vector<CustomSignal> customSignals() const;
    /// Those of the shown signals that samples do not contain.
    [[nodiscard]] const DerivedSignals& derived() const { return m_derived; }
    /// True if derived signals are not complete yet: another frame is needed.
    [[nodiscard]] bool isBehind() const { return m_behind; }
    /// True while strips of the last frame are still to be painted.
    [[nodiscard]] bool isPainting() const { return !m_waiting.empty(); }
    void renderTo(QPainter& painter);

signals:
    /// The mouse or the wheel has changed the visible time; the next frame shows it.
    void timeChanged();
    void everythingWanted();
    void cursorMoved(int cursor, double seconds);
    void resized();
    /// The user has dragged the line between two strips, or made them equal; the order is that of ScopeSetup.
    void heightsChosen(const std::array<double, nmc::ScopeSetup::kStrips>& heights);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] ScopePlot* newPlot(std::size_t strip);
    void arrange();
    [[nodiscard]] std::vector<SignalRef> signalsOf(std::size_t strip) const;
    void shareHeight();
    [[nodiscard]] std::array<double, ScopeSetup::kStrips> heights() const;
    [[nodiscard]] bool followsSelection() const;
    void label(const History& history, double now);
    /// `from`, `to`: the time over which their rates are counted, in s.
    [[nodiscard]] std::vector<ScopePlot::Trace> tracesOf(const std::vector<SignalRef>& strip,
                                                         const History& history, double from,
                                                         double to) const;
    [[nodiscard]] QString labelOf(const SignalRef& signal, const ScopeModule& module) const;
    void align();
    /// Paints one strip after the other: all at once would delay the window, and with it a stop key.
    void paintInTurn(ScopePlot* plot);
    void paintNext();

    QSplitter* m_splitter;
    std::array<ScopePlot*, ScopeSetup::kStrips> m_plots{};
    std::array<std::vector<SignalRef>, ScopeSetup::kStrips> m_signals;  ///< shown in each strip
    DerivedSignals m_derived;
    const Underlay* m_under = nullptr;
    bool m_behind = false;
    bool m_replaced = false;  ///< the data were, and the next frame is the first of the new ones
    StatusLane* m_lane;
    ScopeSetup m_setup;
    std::vector<ScopeModule> m_modules;
    std::optional<ModuleIndex> m_selected;
    TimeWindow m_time;
    std::optional<CursorTimes> m_cursors;
    std::optional<double> m_marker;
    std::optional<std::pair<SignalRef, double>> m_level;
    std::vector<ScopePlot*> m_waiting;  ///< to be painted
    QTimer m_turns;
    std::optional<double> m_labelled;  ///< s, time at which the rates were counted
};

}  // namespace nmc
