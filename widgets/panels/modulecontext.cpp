// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/modulecontext.h"

#include <QEvent>
#include <QScopedValueRollback>
#include <QWidget>
#include <utility>

#include "model/intent/jog.h"
#include "model/intent/rights.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/travelwords.h"
#include "widgets/common/words.h"

namespace nmc {

namespace {

/// Runs `refresh` at once if its box is visible, or else as soon as it becomes visible.
class RefreshWhenSeen : public QObject {
public:
    RefreshWhenSeen(QWidget* box, std::function<void()> refresh)
        : QObject(box), m_box(*box), m_refresh(std::move(refresh)) {
        box->installEventFilter(this);
    }

    void news() {
        m_stale = true;
        if (m_box.isVisible())
            catchUp();
    }
    void catchUp() {
        if (std::exchange(m_stale, false))
            m_refresh();
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Show)
            catchUp();
        return QObject::eventFilter(watched, event);
    }

private:
    QWidget& m_box;
    std::function<void()> m_refresh;
    bool m_stale = false;
};

}  // namespace

ModuleContext::ModuleContext(const PanelView& view, Requests& requests, QObject* parent)
    : QObject(parent), m_requests(requests) {
    adopt(view);
}

void ModuleContext::adopt(const PanelView& view) {
    m_state = view.module;
    m_settings = view.settings;
    m_connected = view.connected;
    m_age = view.age;
    m_namesake = view.namesake;
    if (view.procedure == nullptr)
        return m_procedures.clear();
    // Only one can run. Of another one, the end may have come while the page was not shown.
    std::erase_if(m_procedures, [&](const auto& other) {
        return other.first != view.procedure->kind && !other.second.over();
    });
    m_procedures.insert_or_assign(view.procedure->kind, *view.procedure);
}

void ModuleContext::show(const PanelView& view) {
    // A status that was already on its way does not end the wait: the module has to answer after the request.
    const bool answered = m_askedAt && view.module.latestTime != *m_askedAt && !view.module.awaited;
    if (answered || !view.connected)
        m_askedAt.reset();
    adopt(view);
    emit changed();
}

QString ModuleContext::named(const QString& objectName) const {
    return look::nameFor(m_state.info.identity.type, objectName);
}

std::optional<ProcedureReport> ModuleContext::procedure(ProcedureKind kind) const {
    const auto found = m_procedures.find(kind);
    return found != m_procedures.end() ? std::optional(found->second) : std::nullopt;
}

bool ModuleContext::runs(ProcedureKind kind) const {
    const auto found = m_procedures.find(kind);
    return m_connected && found != m_procedures.end() && !found->second.over();
}

std::optional<ProcedureReport> ModuleContext::runningProcedure() const {
    for (const auto& [kind, report] : m_procedures)
        if (!report.over())
            return report;
    return std::nullopt;
}

std::optional<Refusal> ModuleContext::whyNot(IntentKind kind) const {
    return m_connected ? nmc::whyNot(kind, m_state) : std::optional(Refusal::NotConnected);
}

QString ModuleContext::reasonFor(IntentKind kind) const {
    const std::optional<Refusal> refusal = whyNot(kind);
    return refusal ? texts::refusal(*refusal) : QString();
}

QString ModuleContext::reasonFor(const Intent& intent) const {
    if (!m_connected)
        return texts::refusal(Refusal::NotConnected);
    const auto steps = plan(intent, m_state);
    return steps ? QString() : texts::refusal(steps.error(), intent, m_state, scale());
}

QString ModuleContext::reasonFor(const bus::HoldToMove& hold) const {
    const auto refusal = m_connected ? nmc::whyNot(hold, m_state) : std::optional(Refusal::NotConnected);
    return refusal ? texts::refusal(*refusal, intent::Move{runOf(hold)}, m_state, scale()) : QString();
}

QString ModuleContext::reasonNow(IntentKind kind) const {
    const QString reason = reasonFor(kind);
    return reason.isEmpty() ? whyBusy() : reason;
}

QString ModuleContext::whyBusy() const {
    return busy() ? tr("Waiting for the module's answer.") : QString();
}

QString ModuleContext::whyLocked() const {
    return texts::whyLocked(m_state);
}

void ModuleContext::ask(const Intent& intent) {
    const bool ofProcedure = std::holds_alternative<intent::CancelProcedure>(intent) ||
                             std::holds_alternative<intent::KeepGains>(intent);
    if (!isStop(intent) && !ofProcedure) {
        if (busy())
            return;
        m_askedAt = m_state.latestTime;
        emit changed();
    }
    emit m_requests.intent(m_state.info.index, intent);
}

void ModuleContext::useWorkOffset(const std::optional<WorkOffset>& offset) {
    emit m_requests.workOffset(m_state.info.index, offset, m_state.home.counts());
}

void ModuleContext::hold(const bus::HoldToMove& hold) {
    emit m_requests.hold(hold);
}

void ModuleContext::release() {
    emit m_requests.holdReleased();
}

void ModuleContext::edit(const SettingsEdit& edit) {
    AxisSettings settings = m_settings;
    edit(settings);
    if (m_showing || whyNotEdited(m_state) || settings == m_settings)
        return;
    m_settings = settings;
    emit m_requests.axisEdited(m_state.info.index, settings);
}

void ModuleContext::whenSeen(QWidget* box, const std::function<void()>& refresh) {
    const auto quietly = [this, refresh] {
        const QScopedValueRollback<bool> showing(m_showing, true);
        refresh();
    };
    auto* seen = new RefreshWhenSeen(box, quietly);
    connect(this, &ModuleContext::changed, seen, &RefreshWhenSeen::news);
    connect(this, &ModuleContext::wanted, seen, &RefreshWhenSeen::catchUp);
    quietly();
}

}  // namespace nmc
