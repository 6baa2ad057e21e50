// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QObject>
#include <optional>
#include <vector>

#include "model/scope/derivedsignals.h"
#include "widgets/scope/triggerbar.h"

namespace nmc {

/// Waits for what is chosen in the trigger's bar, and provides the picture to show.
class TriggerControl : public QObject {
    Q_OBJECT

public:
    explicit TriggerControl(TriggerBar* bar);

    [[nodiscard]] TriggerBar& bar() { return *m_bar; }
    /// Shows or hides the bar; while it is hidden, the trigger is off.
    void setShown(bool shown);
    /// Sets the length of the picture in s; if the trigger has fired already, that of the next picture.
    void setWindow(double seconds);
    void showModules(const std::vector<ScopeModule>& modules, std::optional<ModuleIndex> selected);
    /// Call once per frame, whatever is shown. `zero`: date and time of the history's zero. With another
    /// history, a trigger that has fired waits again.
    void follow(const History& history, TimePoint now, const QDateTime& zero);
    /// The modules whose samples it needs; none while it is off.
    [[nodiscard]] std::vector<ModuleIndex> modules() const;
    /// The trigger's picture; empty while it is not complete.
    [[nodiscard]] std::optional<ScopeTrigger::Picture> picture() const;
    [[nodiscard]] std::optional<TimePoint> firedAt() const { return m_trigger.firedAt(); }
    /// The signal whose strip shows the level, and the level in counts.
    [[nodiscard]] std::optional<std::pair<SignalRef, double>> level() const;

signals:
    /// The trigger waits from now on, or no longer waits: the live samples are of interest again.
    void restarted();
    /// picture() has become complete.
    void completed(const nmc::History& history);

private:
    /// How long a picture is shown before the next one may come.
    static constexpr Duration kShown = std::chrono::seconds(1);

    void apply();
    void arm();
    void feed(const History& history);
    void showState(const QDateTime& zero, TimePoint historyZero);

    TriggerBar* m_bar;
    ScopeTrigger m_trigger;
    double m_window = 10;
    TimePoint m_now;
    std::optional<TimePoint> m_zero;   ///< of the last history that was fed
    std::vector<std::uint64_t> m_fed;  ///< number of samples, by module
    DerivedSignals m_derived;          ///< the source, if it is derived
    std::uint64_t m_derivedFed = 0;    ///< number of its values
    std::optional<TimePoint> m_completeSince;
};

}  // namespace nmc
