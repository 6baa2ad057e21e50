// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QObject>
#include <optional>
#include <vector>

#include "model/scope/history.h"
#include "widgets/scope/triggerbar.h"

namespace nmc {

/// Waits for what the trigger's bar says, and tells when there is a picture to show.
class TriggerControl : public QObject {
    Q_OBJECT

public:
    explicit TriggerControl(TriggerBar* bar);

    [[nodiscard]] TriggerBar& bar() { return *m_bar; }
    /// Out of sight it is off.
    void setShown(bool shown);
    /// s; how long a picture is: the next one, where one is there already.
    void setWindow(double seconds);
    void showModules(const std::vector<ScopeModule>& modules, std::optional<ModuleIndex> selected);
    /// Once a frame, whatever is seen. `zero`: when the history's zero was.
    void follow(const History& history, TimePoint now, const QDateTime& zero);
    /// The trigger's picture; nothing while there is none yet.
    [[nodiscard]] std::optional<ScopeTrigger::Picture> picture() const;
    [[nodiscard]] std::optional<TimePoint> firedAt() const { return m_trigger.firedAt(); }
    /// Of the strip that shows it, in counts.
    [[nodiscard]] std::optional<std::pair<SignalRef, double>> level() const;

signals:
    /// It waits from now on, or does not any more: the present is of interest again.
    void restarted();

private:
    /// How long a picture is shown before the next one may come.
    static constexpr Duration kShown = std::chrono::seconds(1);

    void apply();
    void arm();
    void feedAnew(const TriggerSettings& settings);
    void feed(const History& history);
    void showState(const QDateTime& zero, TimePoint historyZero);

    TriggerBar* m_bar;
    ScopeTrigger m_trigger;
    double m_window = 10;
    TimePoint m_now;
    std::optional<TimePoint> m_zero;   ///< of the history that was looked at last
    std::vector<std::uint64_t> m_fed;  ///< samples, by module
    std::optional<TimePoint> m_completeSince;
};

}  // namespace nmc
