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

/// The strips and the lane of status bits, one below the other over the same time, and what mouse and wheel
/// do there.
class ScopeStrips : public QWidget {
    Q_OBJECT

public:
    explicit ScopeStrips(QWidget* parent = nullptr);

    void setSetup(const ScopeSetup& setup);
    /// How to read the samples; `selected`: whose signals stand for "the selected module's".
    void setModules(const std::vector<ScopeModule>& modules, std::optional<ModuleIndex> selected);
    /// One frame; `now` in seconds since the history's zero. The rates are counted anew once a second.
    /// `sharpness`: device pixels in a pixel, where they are not the screen's.
    void showFrame(const History& history, double now, std::optional<double> sharpness = {});
    /// Other data.
    void forget();

    [[nodiscard]] TimeWindow& time() { return m_time; }
    [[nodiscard]] const TimeWindow& time() const { return m_time; }
    void showCursors(const std::optional<CursorTimes>& cursors);
    [[nodiscard]] const std::optional<CursorTimes>& cursors() const { return m_cursors; }
    /// Where something happened, s.
    void showMarker(const std::optional<double>& seconds);
    /// A recording below the live traces, while it lives; null: none.
    void showUnder(const Underlay* under) { m_under = under; }
    /// A trigger's level, in the strips that show this signal.
    void showLevel(std::optional<std::pair<SignalRef, double>> level);

    void fitValues();
    void zoomValues(double factor);
    void panValues(double share);
    /// All that there is of `history`.
    void showEverything(const History& history);

    [[nodiscard]] const std::vector<ScopeModule>& modules() const { return m_modules; }
    [[nodiscard]] std::optional<ModuleIndex> selected() const { return m_selected; }
    [[nodiscard]] std::vector<ScopePlot*> shownPlots() const;
    [[nodiscard]] std::vector<ModuleSignal> shownSignals() const;
    /// What samples have not, of the signals that are shown.
    [[nodiscard]] const DerivedSignals& derived() const { return m_derived; }
    /// There is more of them to come: another frame is wanted.
    [[nodiscard]] bool isBehind() const { return m_behind; }
    void renderTo(QPainter& painter);

signals:
    /// Mouse or wheel have changed what is to be seen, and the next frame shows it.
    void timeChanged();
    void everythingWanted();
    void cursorMoved(int cursor, double seconds);
    void resized();
    /// The user has dragged a line between two strips, or wants them equal: in the order of the setup.
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
    /// `from`, `to`: over what time their rates are counted, s.
    [[nodiscard]] std::vector<ScopePlot::Trace> tracesOf(const std::vector<SignalRef>& strip,
                                                         const History& history, double from,
                                                         double to) const;
    [[nodiscard]] QString labelOf(const SignalRef& signal, const ScopeModule& module) const;
    void align();
    /// One strip after the other: together they would hold up the window, and a key for a stop with it.
    void paintInTurn(ScopePlot* plot);
    void paintNext();

    QSplitter* m_splitter;
    std::array<ScopePlot*, ScopeSetup::kStrips> m_plots{};
    std::array<std::vector<SignalRef>, ScopeSetup::kStrips> m_signals;  ///< that are shown
    DerivedSignals m_derived;
    const Underlay* m_under = nullptr;
    bool m_behind = false;
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
    std::optional<double> m_labelled;  ///< s, when the rates were counted
};

}  // namespace nmc
