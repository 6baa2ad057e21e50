// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <optional>

#include "widgets/panels/panelview.h"

class QWidget;

namespace nmc {

/// One module of one connection, as its page sees it: made with it, gone with it. What a box shows it reads
/// here; what its user wants it says here. Nothing of a module is kept anywhere else in a panel. GUI thread.
class ModuleContext : public QObject {
    Q_OBJECT

public:
    explicit ModuleContext(const PanelView& view, QObject* parent = nullptr);

    [[nodiscard]] const ModuleState& state() const { return m_state; }
    [[nodiscard]] const AxisSettings& settings() const { return m_settings; }
    [[nodiscard]] AxisScale scale() const { return scaleOf(m_state, m_settings); }
    /// What the user's direction is to the chip.
    [[nodiscard]] bool chipReverse(bool reverse) const { return reverse != scale().reversed(); }
    [[nodiscard]] bool connected() const { return m_connected; }
    /// s, of what is older than it should be.
    [[nodiscard]] std::optional<double> age() const { return m_age; }
    /// The last one of that kind, of this module.
    [[nodiscard]] std::optional<ProcedureReport> procedure(ProcedureKind kind) const;
    /// Of whatever kind, while it runs.
    [[nodiscard]] std::optional<ProcedureReport> runningProcedure() const;

    [[nodiscard]] std::optional<Refusal> whyNot(IntentKind kind) const;
    /// Why it can't be asked for, in words; empty where it can.
    [[nodiscard]] QString reasonFor(IntentKind kind) const;
    /// Why that very motion can't be asked for, with the limit of travel or of speed in its way.
    [[nodiscard]] QString reasonFor(const Intent& intent) const;
    /// The same of what waits for the module's answer to what was asked before: everything but a stop.
    [[nodiscard]] QString reasonNow(IntentKind kind) const;
    /// A click was passed on, and what it asked for has not ended, or the module has not spoken since: a
    /// double click is one command.
    [[nodiscard]] bool busy() const { return m_askedAt.has_value(); }
    /// Why, in words; empty when it is not busy.
    [[nodiscard]] QString whyBusy() const;

    /// Nothing while it is busy; a stop always goes.
    void ask(const Intent& intent);
    /// Changes what the panel knows of the axis; sends nothing. Boxes that show news edit nothing: what a
    /// field says then is not its user's.
    void edit(const SettingsEdit& edit);
    void hold(const bus::HoldToMove& hold) { emit holdAsked(hold); }
    void release() { emit holdReleased(); }

    /// Calls `refresh` now, and then when there is news while `box` is visible, or when it comes in sight.
    void whenSeen(QWidget* box, const std::function<void()>& refresh);

    /// What is out of sight is made as it is now, too.
    void catchUp() { emit wanted(); }

    /// Of the page that owns it; nothing is emitted but changed().
    void show(const PanelView& view);
    /// Between the news that a held button gives, ms.
    void setHoldInterval(int milliseconds) { emit holdIntervalChanged(milliseconds); }

signals:
    /// The module, the settings, or whether it is busy.
    void changed();
    void wanted();
    /// What is held ends.
    void holdMustEnd();
    /// The chain is looked for anew: low speeds again, and no goals.
    void lookedForAnew();
    void holdIntervalChanged(int milliseconds);

    // ---- to whoever carries it out ----
    void asked(const nmc::Intent& intent);
    void edited(const nmc::AxisSettings& settings);
    void holdAsked(const nmc::bus::HoldToMove& hold);
    void holdReleased();

private:
    void adopt(const PanelView& view);

    ModuleState m_state;
    AxisSettings m_settings;
    std::map<ProcedureKind, ProcedureReport> m_procedures;
    bool m_connected = false;
    bool m_showing = false;
    std::optional<double> m_age;
    std::optional<TimePoint> m_askedAt;  ///< the latest status then
};

}  // namespace nmc
