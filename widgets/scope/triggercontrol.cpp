// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/triggercontrol.h"

#include <cmath>

namespace nmc {

using namespace Qt::StringLiterals;

TriggerControl::TriggerControl(TriggerBar* bar) : QObject(bar), m_bar(bar) {
    connect(bar, &TriggerBar::edited, this, &TriggerControl::apply);
    connect(bar, &TriggerBar::armRequested, this, &TriggerControl::arm);
}

void TriggerControl::setShown(bool shown) {
    m_bar->setVisible(shown);
    if (!shown)
        m_bar->setMode(TriggerBar::Mode::Off);
    apply();
}

void TriggerControl::setWindow(double seconds) {
    constexpr double kSame = 1e-9;  // moving the window along rounds its width
    if (std::abs(seconds - m_window) <= kSame * m_window)
        return;
    m_window = seconds;
    if (m_trigger.state() == ScopeTrigger::State::Armed) {
        m_trigger.setWindow(m_window);
        m_trigger.arm(m_now);
    }
}

void TriggerControl::showModules(const std::vector<ScopeModule>& modules,
                                 std::optional<ModuleIndex> selected) {
    m_bar->showModules(modules, selected);
    apply();
}

/// Other settings start the trigger again.
void TriggerControl::apply() {
    auto wanted = m_bar->settings();
    const bool off = m_trigger.state() == ScopeTrigger::State::Off;
    if (wanted)
        wanted->window = m_trigger.settings().window;
    if (wanted ? !off && *wanted == m_trigger.settings() : off)
        return;
    if (wanted) {
        wanted->window = m_window;
        m_trigger.set(*wanted);
        m_derived = DerivedSignals();
        m_derivedFed = 0;
        if (const auto source = m_trigger.derivedSource())
            m_derived.want({*source}, wanted->custom);
        return arm();
    }
    m_trigger.disarm();
    emit restarted();
}

void TriggerControl::arm() {
    m_completeSince.reset();
    m_trigger.setWindow(m_window);  // as long as the time that is visible now
    m_trigger.arm(m_now);
    emit restarted();
}

void TriggerControl::follow(const History& history, TimePoint now, const QDateTime& zero) {
    m_now = now;
    feed(history);
    if (m_trigger.state() == ScopeTrigger::State::Complete && !m_completeSince) {
        m_completeSince = now;
        emit completed(history);
    }
    if (m_completeSince && now - *m_completeSince >= kShown &&
        m_trigger.settings().mode == TriggerSettings::Mode::Normal) {
        m_completeSince.reset();
        m_trigger.setWindow(m_window);
        m_trigger.arm(now);
    }
    showState(zero, history.zero().value_or(TimePoint{}));
}

void TriggerControl::feed(const History& history) {
    if (history.zero() != m_zero || history.modules() != m_fed.size()) {
        m_zero = history.zero();
        m_fed.assign(history.modules(), 0);
        m_derived.forget();
        m_derivedFed = 0;
        m_trigger.forgetSamples();
        // What triggered is of a chain that is no longer shown.
        if (m_trigger.firedAt())
            arm();
    }
    for (std::size_t i = 0; i < m_fed.size(); ++i) {
        const ModuleIndex index(static_cast<std::uint8_t>(i));
        const ModuleHistory& module = *history.module(index);
        m_fed[i] = module.visitSince(
            m_fed[i], [&](const ScopeSample& sample) { m_trigger.feed(index, sample); },
            DerivedSignals::kAtOnce);
    }
    const auto derived = m_trigger.derivedSource();
    if (!derived)
        return;
    m_derived.follow(history);
    if (const ModuleHistory* values = m_derived.source(history, *derived).samples)
        m_derivedFed =
            values->visitSince(m_derivedFed, [&](const ScopeSample& value) { m_trigger.feedDerived(value); });
}

std::vector<ModuleIndex> TriggerControl::modules() const {
    if (m_trigger.state() == ScopeTrigger::State::Off)
        return {};
    std::vector<ModuleIndex> modules{m_trigger.settings().module};
    for (const CustomSignal& custom : m_trigger.settings().custom) {
        modules.push_back(custom.first.of.module);
        if (custom.second)
            modules.push_back(custom.second->of.module);
    }
    return modules;
}

std::optional<ScopeTrigger::Picture> TriggerControl::picture() const {
    return m_trigger.state() == ScopeTrigger::State::Complete ? m_trigger.picture() : std::nullopt;
}

std::optional<std::pair<SignalRef, double>> TriggerControl::level() const {
    const auto signal = m_bar->levelSignal();
    if (!signal)
        return std::nullopt;
    return std::pair(*signal, m_trigger.settings().level);
}

void TriggerControl::showState(const QDateTime& zero, TimePoint historyZero) {
    const auto when = [&] {
        const double seconds = toSeconds(m_trigger.firedAt().value_or(historyZero) - historyZero);
        return zero.addMSecs(qRound64(seconds * 1e3)).toString(u"HH:mm:ss.zzz"_s);
    };
    switch (m_trigger.state()) {
        case ScopeTrigger::State::Off:
            return m_bar->showState({});
        case ScopeTrigger::State::Armed:
            return m_bar->showState(tr("waiting"));
        case ScopeTrigger::State::Fired:
            return m_bar->showState(tr("triggered %1, more samples to come").arg(when()));
        case ScopeTrigger::State::Complete:
            return m_bar->showState(tr("triggered %1").arg(when()));
    }
}

}  // namespace nmc
