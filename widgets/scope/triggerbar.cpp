// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/triggerbar.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/scope/scopewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

using Condition = TriggerSettings::Condition;

constexpr double kFarthestLevel = 1e12;
constexpr int kUsualBefore = 20;  ///< percent

/// The condition in counts where the scale counts downwards.
Condition turned(Condition condition) {
    switch (condition) {
        case Condition::Rising:
            return Condition::Falling;
        case Condition::Falling:
            return Condition::Rising;
        case Condition::Above:
            return Condition::Below;
        case Condition::Below:
            return Condition::Above;
    }
    return condition;
}

}  // namespace

TriggerBar::TriggerBar(QWidget* parent)
    : QWidget(parent),
      m_layout(new FlowLayout(look::gridUnit(this))),
      m_source(form::newChoice(
          {u"triggerSourceBox"_s, tr("Trigger on"), {}, tr("The signal or status bit to wait for.")}, this)),
      m_condition(form::newChoice(
          {u"triggerConditionBox"_s, tr("Condition"), {}, tr("The event to wait for.")}, this)),
      m_level(form::newNumber({.name = u"triggerLevelField"_s,
                               .accessible = tr("Level"),
                               .min = -kFarthestLevel,
                               .max = kFarthestLevel,
                               .digits = 8,
                               .meaning = tr("The level for the event.")},
                              this)),
      m_unit(new QLabel(this)),
      m_mode(form::newChoice({u"triggerModeBox"_s, tr("Mode"), {}}, this)),
      m_before(form::newNumber({.name = u"triggerBeforeField"_s,
                                .accessible = tr("Before"),
                                .max = 100,
                                .digits = 3,
                                .meaning = tr("Share of the picture before the trigger, in percent.")},
                               this)),
      m_arm(form::newPush({u"triggerArmButton"_s, tr("Arm")}, this)),
      m_state(new QLabel(this)) {
    look::name(this, u"triggerBar"_s, Common::tr("Trigger"));
    look::name(m_state, u"triggerStateLabel"_s, tr("State of the trigger"));
    m_source->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_source->setMinimumContentsLength(12);
    m_mode->addItems({tr("Off"), tr("Single"), tr("Normal")});
    m_mode->setToolTip(tr("Single: holds the first picture. Normal: shows picture after picture."));
    m_before->showValue(kUsualBefore);
    m_level->showValue(0);
    connect(m_arm, &QPushButton::clicked, this, &TriggerBar::armRequested);

    layOut();
    connect(m_source, &QComboBox::activated, this, [this] {
        takeSource();
        emit edited();
    });
    const auto changed = [this] {
        showPossible();
        emit edited();
    };
    for (QComboBox* box : {m_condition, m_mode})
        connect(box, &QComboBox::activated, this, changed);
    for (NumberField* field : {m_level, m_before})
        connect(field, &NumberField::edited, this, changed);
    takeSource();
}

/// In as many rows as it needs, because one row would often be wider than the scope.
void TriggerBar::layOut() {
    using form::newLabel;
    m_layout->addLayout(form::newLine(
        this, {newLabel(tr("Trigger on"), m_source), m_source, m_condition, m_level, m_unit}, 0.5));
    m_layout->addLayout(form::newLine(this,
                                      {newLabel(tr("Mode"), m_mode), m_mode, newLabel(tr("Before"), m_before),
                                       m_before, newLabel(tr("%"), m_before), m_arm},
                                      0.5));
    m_layout->addWidget(m_state);
    setLayout(m_layout);
    layout()->setContentsMargins(0, look::gridUnit(this) / 2, 0, 0);
}

/// The state's width changes, so it is the last.
void TriggerBar::addControls(QWidget* controls) {
    m_layout->insertWidget(m_layout->count() - 1, controls);
}

// ---- the sources ----

void TriggerBar::showModules(const std::vector<ScopeModule>& modules, std::optional<ModuleIndex> selected) {
    if (modules == m_modules && selected == m_selected)
        return;
    m_modules = modules;
    m_selected = selected;
    m_listed = false;
    if (!isHidden())
        listSources();
}

void TriggerBar::setVisible(bool visible) {
    if (visible && !m_listed)
        listSources();
    QWidget::setVisible(visible);
}

/// There can be hundreds of sources, so they are not listed while the bar is hidden.
void TriggerBar::listSources() {
    m_listed = true;
    const int chosen = m_source->currentIndex();
    const std::vector<Source> before = std::move(m_sources);
    const QSignalBlocker quiet(m_source);
    m_source->clear();
    m_sources.clear();
    if (m_selected && m_selected->value() < m_modules.size())
        addSources(std::nullopt, m_modules[m_selected->value()]);
    for (std::size_t i = 0; i < m_modules.size(); ++i)
        addSources(ModuleIndex(static_cast<std::uint8_t>(i)), m_modules[i]);
    const auto rowOf = [this](const Source& source) {
        const auto found = std::ranges::find(m_sources, source);
        return found != m_sources.end() ? static_cast<int>(found - m_sources.begin()) : -1;
    };
    int again = -1;
    if (chosen >= 0) {
        const Source& source = before[static_cast<std::size_t>(chosen)];
        again = rowOf(source);
        if (again < 0)  // the module that is selected now has no such signal
            again = rowOf({m_sourceModule, source.what});
        // What the user waits for is gone; nobody has asked to wait for anything else.
        if (again < 0)
            m_mode->setCurrentIndex(static_cast<int>(Mode::Off));
    }
    m_source->setCurrentIndex(m_sources.empty() ? -1 : std::max(again, 0));
    takeSourceAgain();
}

void TriggerBar::addSources(const std::optional<ModuleIndex>& module, const ScopeModule& of) {
    const auto add = [&](const Source& source, const QString& name) {
        m_sources.push_back(source);
        m_source->addItem(module ? Common::tr("%1: %2").arg(of.name, name) : name);
    };
    for (const SignalInfo& info : kSignals) {
        // A derived signal needs the signals from which it is derived.
        const ScopeSignal signal = info.signal;
        if (isDerived(signal) ? of.reports(signal) : of.has(signal))
            add({module, signal}, texts::signalName(signal, of));
    }
    for (const ScopeBit& bit : laneBits(of.identity))
        add({module, bit}, texts::bitName(bit, of));
}

const TriggerBar::Source* TriggerBar::source() const {
    const int row = m_source->currentIndex();
    return row >= 0 ? &m_sources[static_cast<std::size_t>(row)] : nullptr;
}

std::optional<ModuleIndex> TriggerBar::sourceModule() const {
    if (source() == nullptr)
        return std::nullopt;
    return source()->module ? source()->module : m_selected;
}

const ScopeSignal* TriggerBar::signal() const {
    return source() != nullptr ? std::get_if<ScopeSignal>(&source()->what) : nullptr;
}

LinearScale TriggerBar::scale() const {
    return signal() != nullptr ? m_modules[sourceModule()->value()].scaleOf(*signal()) : LinearScale{};
}

/// The level may now be of another quantity, or have another unit.
void TriggerBar::takeSource() {
    m_sourceModule = sourceModule();
    showConditions();
    if (signal() != nullptr) {
        const ScopeModule& module = m_modules[sourceModule()->value()];
        m_unit->setText(texts::signalUnit(*signal(), module));
        m_level->setWords(tr("Level"), m_unit->text());
        m_level->setDecimals(texts::decimalsAt(texts::signalStep(*signal(), module)));
        m_levelOf = LevelOf{*source(), *sourceModule(), scale()};
    }
    m_level->setVisible(signal() != nullptr);
    m_unit->setVisible(signal() != nullptr);
    showPossible();
}

/// The user has not chosen another source, so the level remains the same in another unit. Of another module's
/// signal, nothing is known in that unit.
void TriggerBar::takeSourceAgain() {
    const std::optional<LevelOf> before = m_levelOf;
    const std::optional<double> level = m_level->value();
    const QString unit = m_unit->text();
    takeSource();
    if (!before || signal() == nullptr || m_unit->text() == unit)
        return;
    if (level && before->source == m_levelOf->source && before->module == m_levelOf->module)
        m_level->showValue(scale()((*level - before->scale.offset) / before->scale.factor));
    else if (level != 0.0)
        m_level->showNothing();
    showPossible();
}

void TriggerBar::showConditions() {
    const QStringList words =
        signal() != nullptr ? QStringList{tr("rises to"), tr("falls to"), tr("is above"), tr("is below")}
                            : QStringList{tr("becomes 1"), tr("becomes 0"), tr("is 1"), tr("is 0")};
    if (m_condition->itemText(0) == words.front())
        return;
    const int before = std::max(0, m_condition->currentIndex());
    m_condition->clear();
    m_condition->addItems(words);
    m_condition->setCurrentIndex(before);
}

void TriggerBar::showPossible() {
    const QString reason = m_sources.empty()                                   ? tr("No module connected.")
                           : mode() == Mode::Off                               ? tr("Choose a mode first.")
                           : m_before->problem() != NumberField::Problem::None ? m_before->problemText()
                           : !settings()                                       ? m_level->problemText()
                                                                               : QString();
    look::setPossible(m_arm, reason, tr("Waits for the next trigger."));
}

// ---- the chosen settings ----

void TriggerBar::showState(const QString& state) {
    look::setText(m_state, state);
}

void TriggerBar::setMode(Mode mode) {
    m_mode->setCurrentIndex(static_cast<int>(mode));
    showPossible();
}

TriggerBar::Mode TriggerBar::mode() const {
    return static_cast<Mode>(m_mode->currentIndex());
}

std::optional<TriggerSettings> TriggerBar::settings() const {
    const auto before = m_before->value();
    if (mode() == Mode::Off || source() == nullptr || !before || (signal() != nullptr && !m_level->value()))
        return std::nullopt;
    TriggerSettings settings;
    settings.module = *sourceModule();
    settings.source = source()->what;
    settings.condition = static_cast<Condition>(m_condition->currentIndex());
    settings.mode = mode() == Mode::Normal ? TriggerSettings::Mode::Normal : TriggerSettings::Mode::Single;
    settings.preTrigger = *before / 100;
    if (signal() != nullptr) {
        settings.level = (*m_level->value() - scale().offset) / scale().factor;
        if (scale().factor < 0)
            settings.condition = turned(settings.condition);
        if (const CustomTrace* trace = m_modules[settings.module.value()].customOf(*signal()))
            settings.custom = {trace->signal};
    }
    return settings;
}

std::optional<SignalRef> TriggerBar::levelSignal() const {
    if (signal() == nullptr || !settings())
        return std::nullopt;
    return SignalRef{sourceModule(), *signal()};
}

}  // namespace nmc
