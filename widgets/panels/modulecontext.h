// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <optional>

#include "model/intent/intent.h"
#include "widgets/panels/panelview.h"

class QWidget;

namespace nmc {

class Requests;

/// One module of one connection, as its page sees it, and for the lifetime of that page. Boxes read here what
/// they show, and request here what the user wants; a panel keeps nothing about a module anywhere else. GUI
/// thread.
class ModuleContext : public QObject {
    Q_OBJECT

public:
    ModuleContext(const PanelView& view, Requests& requests, QObject* parent = nullptr);

    [[nodiscard]] const ModuleState& state() const { return m_state; }
    [[nodiscard]] const AxisSettings& settings() const { return m_settings; }
    [[nodiscard]] AxisScale scale() const { return scaleOf(m_state, m_settings); }
    /// The chip's direction for a direction as the user sees it.
    [[nodiscard]] bool chipReverse(bool reverse) const { return reverse != scale().reversed(); }
    [[nodiscard]] bool connected() const { return m_connected; }
    /// The object name of a control that the window may have once for each type of module.
    [[nodiscard]] QString named(const QString& objectName) const;
    /// Age in s of a state that is older than it should be.
    [[nodiscard]] std::optional<double> age() const { return m_age; }
    /// Another module of the chain whose axis has the same name.
    [[nodiscard]] std::optional<ModuleIndex> namesake() const { return m_namesake; }
    /// The last procedure of that kind on this module.
    [[nodiscard]] std::optional<ProcedureReport> procedure(ProcedureKind kind) const;
    [[nodiscard]] bool runs(ProcedureKind kind) const;
    /// The procedure of any kind that is running.
    [[nodiscard]] std::optional<ProcedureReport> runningProcedure() const;

    [[nodiscard]] std::optional<Refusal> whyNot(IntentKind kind) const;
    /// Why it cannot be requested, in words; empty if it can.
    [[nodiscard]] QString reasonFor(IntentKind kind) const;
    /// Why this very motion cannot be requested, with the travel limit or speed limit that prevents it.
    [[nodiscard]] QString reasonFor(const Intent& intent) const;
    /// Why the motor cannot be held in this motion.
    [[nodiscard]] QString reasonFor(const bus::HoldToMove& hold) const;
    /// Why it cannot be requested now, in words. Until the module has answered the last request, everything
    /// but a stop has to wait.
    [[nodiscard]] QString reasonNow(IntentKind kind) const;
    /// True while what the last click requested has not ended, or the module has not answered since: a double
    /// click is one command.
    [[nodiscard]] bool busy() const { return m_askedAt.has_value(); }
    /// Why it is busy, in words; empty if it is not.
    [[nodiscard]] QString whyBusy() const;
    /// Why the settings of the axis cannot be edited, in words; empty if they can.
    [[nodiscard]] QString whyLocked() const;

    /// Passes the request on, unless busy; stops, and requests to a procedure that is running, are always
    /// passed on.
    void ask(const Intent& intent);
    /// Changes the settings of the axis; sends nothing. Has no effect while boxes are refreshed, because what
    /// a field says then does not come from the user.
    void edit(const SettingsEdit& edit);
    /// Positions count from that work offset, which itself counts from the present home, or by the counter.
    /// Sends nothing.
    void useWorkOffset(const std::optional<WorkOffset>& offset);
    void hold(const bus::HoldToMove& hold);
    void release();

    /// Calls `refresh` now, and after each change: at once while `box` is visible, or else when it becomes
    /// visible.
    void whenSeen(QWidget* box, const std::function<void()>& refresh);

    /// Refreshes boxes that are not visible, too.
    void catchUp() { emit wanted(); }

    /// For the page that owns it; emits nothing but changed().
    void show(const PanelView& view);

signals:
    /// The module, the settings or busy() has changed.
    void changed();
    void wanted();
    /// A hold in progress must end.
    void holdMustEnd();
    /// The chain is searched for again: speeds are low again, and goals are forgotten.
    void lookedForAnew();

private:
    void adopt(const PanelView& view);

    Requests& m_requests;
    ModuleState m_state;
    AxisSettings m_settings;
    std::map<ProcedureKind, ProcedureReport> m_procedures;
    bool m_connected = false;
    bool m_showing = false;
    std::optional<double> m_age;
    std::optional<ModuleIndex> m_namesake;
    std::optional<TimePoint> m_askedAt;  ///< time of the latest status at the last request
};

}  // namespace nmc
