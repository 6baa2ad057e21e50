// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopestrips.h"

#include <QEvent>
#include <QPainter>
#include <QSplitter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/scope/statuslane.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kTurn = 6;           ///< ms between painting two strips
constexpr double kRateTime = 1.0;  ///< s over which samples are counted, and between two counts
const std::array<QString, ScopeSetup::kStrips> kPlotNames{u"scopePlot1"_s, u"scopePlot2"_s, u"scopePlot3"_s,
                                                          u"scopePlot4"_s};
}  // namespace

ScopeStrips::ScopeStrips(QWidget* parent)
    : QWidget(parent), m_splitter(new QSplitter(Qt::Vertical, this)), m_lane(new StatusLane(this)) {
    look::name(this, u"scopeStrips"_s, tr("Plots; arrow keys move, plus and minus zoom"));
    setFocusPolicy(Qt::StrongFocus);
    setLayout(form::newColumn(this, {{m_splitter, 1}, m_lane}, 0));
    layout()->setContentsMargins(2, 2, 2, 2);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(look::gridUnit(this) / 2);
    m_turns.setInterval(kTurn);
    connect(&m_turns, &QTimer::timeout, this, &ScopeStrips::paintNext);
}

/// A strip is built only when it is first needed, because each has a chart.
ScopePlot* ScopeStrips::newPlot(std::size_t strip) {
    auto* plot = new ScopePlot(this);
    const auto above = std::count_if(m_plots.begin(), m_plots.begin() + static_cast<std::ptrdiff_t>(strip),
                                     [](const ScopePlot* other) { return other != nullptr; });
    m_splitter->insertWidget(static_cast<int>(above), plot);
    for (int i = 0; i < m_splitter->count(); ++i) {
        m_splitter->handle(i)->installEventFilter(this);
        m_splitter->handle(i)->setToolTip(tr("Drag to resize the strips. Double-click to make them equal."));
    }
    look::name(plot, kPlotNames[strip], tr("Strip %1 of the scope").arg(strip + 1));
    connect(plot, &ScopePlot::paintWanted, this, [this, plot] { paintInTurn(plot); });
    connect(plot, &ScopePlot::timeZoomed, this, [this](double factor, double at) {
        m_time.zoom(factor, at);
        emit timeChanged();
    });
    connect(plot, &ScopePlot::timePanned, this, [this](double seconds) {
        m_time.pan(seconds);
        emit timeChanged();
    });
    connect(plot, &ScopePlot::timeChosen, this, [this](double left, double right) {
        m_time.show(left, right);
        emit timeChanged();
    });
    connect(plot, &ScopePlot::cursorMoved, this, &ScopeStrips::cursorMoved);
    connect(plot, &ScopePlot::everythingWanted, this, &ScopeStrips::everythingWanted);
    connect(plot, &ScopePlot::focusWanted, this, [this] { setFocus(Qt::MouseFocusReason); });
    plot->showCursors(m_cursors);
    plot->showMarker(m_marker);
    return plot;
}

void ScopeStrips::setSetup(const ScopeSetup& setup) {
    if (setup == m_setup)
        return;
    m_setup = setup;
    m_labelled.reset();
    arrange();
}

void ScopeStrips::setModules(const std::vector<ScopeModule>& modules, std::optional<ModuleIndex> selected) {
    if (modules == m_modules && selected == m_selected)
        return;
    // Strips that do not follow the selection keep their labels.
    if (modules != m_modules || followsSelection())
        m_labelled.reset();
    m_modules = modules;
    m_selected = selected;
    arrange();
}

bool ScopeStrips::followsSelection() const {
    return std::ranges::any_of(m_setup.strips, [](const auto& strip) {
        return std::ranges::any_of(strip, [](const SignalRef& signal) { return !signal.module.has_value(); });
    });
}

/// For the selected module, the chosen signals that it reports; for a module chosen by name, all chosen
/// signals that it can have.
std::vector<SignalRef> ScopeStrips::signalsOf(std::size_t strip) const {
    std::vector<SignalRef> signalsShown = m_setup.strips[strip];
    std::erase_if(signalsShown, [this](const SignalRef& signal) {
        const auto index = signal.module ? signal.module : m_selected;
        if (!index || index->value() >= m_modules.size())
            return !m_modules.empty();
        const ScopeModule& module = m_modules[index->value()];
        return signal.module ? !module.has(signal.signal) : !module.reports(signal.signal);
    });
    return signalsShown;
}

void ScopeStrips::arrange() {
    for (std::size_t i = 0; i < m_plots.size(); ++i) {
        m_signals[i] = signalsOf(i);
        const bool shown = !m_signals[i].empty();
        if (shown && m_plots[i] == nullptr)
            m_plots[i] = newPlot(i);
        if (m_plots[i] != nullptr)
            m_plots[i]->setVisible(shown);
    }
    const std::vector<ScopePlot*> plots = shownPlots();
    for (ScopePlot* plot : plots)
        plot->setTimeLabels(plot == plots.back());
    shareHeight();
    m_lane->setVisible(m_setup.lane);
    const ScopeModule module =
        m_selected && m_selected->value() < m_modules.size() ? m_modules[m_selected->value()] : ScopeModule{};
    // Those of a type of module are chosen together, but not every version has all of them.
    std::vector<ScopeBit> bits = m_setup.bitsOf(module.identity.type);
    std::erase_if(bits, [&module](const ScopeBit& bit) { return texts::bitName(bit, module).isEmpty(); });
    m_lane->setBits(module, bits);
}

void ScopeStrips::shareHeight() {
    QList<int> sizes;
    for (std::size_t i = 0; i < m_plots.size(); ++i)
        if (m_plots[i] != nullptr)
            sizes << qRound(1'000 * m_setup.heights[i]);
    m_splitter->setSizes(sizes);  // distributes the height that there is
}

/// The present heights; a hidden strip keeps its last one.
std::array<double, ScopeSetup::kStrips> ScopeStrips::heights() const {
    std::array<double, ScopeSetup::kStrips> chosen = m_setup.heights;
    const std::vector<ScopePlot*> shown = shownPlots();
    double sum = 0;
    for (const ScopePlot* plot : shown)
        sum += plot->height();
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (!m_signals[i].empty() && sum > 0)
            chosen[i] = std::clamp(
                std::round(100 * m_plots[i]->height() * static_cast<double>(shown.size()) / sum) / 100,
                ScopeSetup::kLowest, ScopeSetup::kHighest);
    return chosen;
}

bool ScopeStrips::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonDblClick) {
        std::array<double, ScopeSetup::kStrips> equal{};
        equal.fill(1);
        emit heightsChosen(equal);
        return true;
    }
    if (event->type() == QEvent::MouseButtonRelease)
        emit heightsChosen(heights());
    return QWidget::eventFilter(watched, event);
}

QString ScopeStrips::labelOf(const SignalRef& signal, const ScopeModule& module) const {
    const QString name = texts::signalName(signal.signal, module);
    const QString unit = texts::signalUnit(signal.signal, module);
    const QString words = unit.isEmpty() ? name : Common::tr("%1, %2").arg(name, unit);
    return signal.module ? Common::tr("%1: %2").arg(module.name, words) : words;
}

/// Updates names, units and the achieved rates.
void ScopeStrips::label(const History& history, double now) {
    if (m_labelled && std::abs(now - *m_labelled) < kRateTime)
        return;
    m_labelled = now;
    const double to = m_time.rolls() ? now : m_time.right();
    const double from = m_time.rolls() ? now - kRateTime : m_time.left();
    for (std::size_t i = 0; i < m_plots.size(); ++i)
        if (m_plots[i] != nullptr)
            m_plots[i]->setTraces(tracesOf(m_signals[i], history, from, to));
}

std::vector<ScopePlot::Trace> ScopeStrips::tracesOf(const std::vector<SignalRef>& strip,
                                                    const History& history, double from, double to) const {
    const TimePoint zero = history.zero().value_or(TimePoint{});
    const bool mixed = std::ranges::any_of(
        strip, [&](const SignalRef& signal) { return signal.module != strip.front().module; });
    std::vector<ScopePlot::Trace> traces;
    for (const SignalRef& signal : strip) {
        const std::optional<ModuleIndex> index = signal.module ? signal.module : m_selected;
        if (!index || index->value() >= m_modules.size())
            continue;
        const ScopeModule& module = m_modules[index->value()];
        ScopePlot::Trace trace{*index, signal.signal, module.scaleOf(signal.signal), labelOf(signal, module),
                               mixed ? QString::number(index->value() + 1) : QString()};
        trace.limits = module.limitsOf(signal.signal);
        const auto source = m_derived.source(history, {*index, signal.signal});
        if (source.samples != nullptr)
            trace.samplesPerSecond = static_cast<double>(source.samples->countBetween(
                                         zero + fromSeconds(from), zero + fromSeconds(to), source.signal)) /
                                     (to - from);
        traces.push_back(trace);
    }
    return traces;
}

std::vector<ModuleSignal> ScopeStrips::shownSignals() const {
    std::vector<ModuleSignal> shown;
    for (const auto& strip : m_signals)
        for (const SignalRef& signal : strip)
            if (const auto module = signal.module ? signal.module : m_selected)
                shown.push_back({*module, signal.signal});
    return shown;
}

std::vector<CustomSignal> ScopeStrips::customSignals() const {
    std::vector<CustomSignal> custom;
    for (const ModuleSignal& shown : shownSignals())
        if (shown.module.value() < m_modules.size())
            if (const CustomTrace* trace = m_modules[shown.module.value()].customOf(shown.signal))
                custom.push_back(trace->signal);
    return custom;
}

void ScopeStrips::showFrame(const History& history, double now, std::optional<double> sharpness) {
    if (sharpness) {
        layout()->activate();
        shareHeight();  // again, because a splitter that was resized rounds its previous sizes
    }
    m_time.follow(now);
    if (std::exchange(m_replaced, false) && m_cursors)
        placeCursors();
    m_derived.want(shownSignals(), customSignals());
    m_behind = !m_derived.follow(history);
    label(history, now);
    const ScopePlot::View view{history.zero().value_or(TimePoint{}), m_time.left(), m_time.right(),
                               m_time.division(), sharpness.value_or(devicePixelRatioF())};
    for (ScopePlot* plot : shownPlots()) {
        plot->showFrame(view, history, now, m_derived, m_under);
        std::optional<double> level;
        if (m_level)
            for (const ScopePlot::Trace& trace : plot->traces())
                if (trace.signal == m_level->first.signal && m_level->first.module == trace.module)
                    level = trace.scale(m_level->second);
        plot->showLevel(level);
    }
    align();
    if (m_setup.lane)
        m_lane->showFrame(view, m_selected ? history.module(*m_selected) : nullptr);
}

void ScopeStrips::paintInTurn(ScopePlot* plot) {
    if (std::find(m_waiting.begin(), m_waiting.end(), plot) == m_waiting.end())
        m_waiting.push_back(plot);
    if (!m_turns.isActive()) {
        m_turns.start();
        paintNext();
    }
}

void ScopeStrips::paintNext() {
    if (m_waiting.empty())
        return m_turns.stop();
    m_waiting.front()->update();
    m_waiting.erase(m_waiting.begin());
}

/// The strips share one time axis, so their plot areas begin at the same place.
void ScopeStrips::align() {
    const std::vector<ScopePlot*> plots = shownPlots();
    int width = m_setup.lane ? m_lane->labelWidth() : 0;
    for (const ScopePlot* plot : plots)
        width = std::max(width, plot->labelWidth());
    for (ScopePlot* plot : plots)
        plot->leaveLeft(width);
    const QRectF area = plots.empty() ? QRectF(QPointF(width, 0), m_lane->size()) : plots.front()->plotArea();
    m_lane->setArea(area.left(), std::min<double>(area.right(), m_lane->width()));
}

void ScopeStrips::forget() {
    for (ScopePlot* plot : findChildren<ScopePlot*>())
        plot->forget();
    m_derived.forget();
    m_labelled.reset();
    m_time.roll();
    m_replaced = true;
    showMarker({});
}

void ScopeStrips::showCursors(const std::optional<CursorTimes>& cursors) {
    m_cursors = cursors;
    for (ScopePlot* plot : findChildren<ScopePlot*>())
        plot->showCursors(cursors);
    m_lane->showCursors(cursors);
}

void ScopeStrips::placeCursors() {
    showCursors(CursorTimes{m_time.left() + m_time.width() / 3, m_time.left() + m_time.width() * 2 / 3});
}

void ScopeStrips::showMarker(const std::optional<double>& seconds) {
    m_marker = seconds;
    for (ScopePlot* plot : findChildren<ScopePlot*>())
        plot->showMarker(seconds);
}

void ScopeStrips::showLevel(std::optional<std::pair<SignalRef, double>> level) {
    m_level = level;
}

void ScopeStrips::fitValues() {
    for (ScopePlot* plot : findChildren<ScopePlot*>())
        plot->fit();
}

void ScopeStrips::zoomValues(double factor) {
    for (ScopePlot* plot : shownPlots())
        plot->zoomValues(factor, (plot->valueRange().min + plot->valueRange().max) / 2);
}

void ScopeStrips::panValues(double share) {
    for (ScopePlot* plot : shownPlots())
        plot->panValues(share);
}

void ScopeStrips::showEverything(const History& history) {
    fitValues();
    if (const auto begin = history.begin())
        m_time.show(toSeconds(*begin - *history.zero()), toSeconds(*history.end() - *history.zero()));
}

std::vector<ScopePlot*> ScopeStrips::shownPlots() const {
    std::vector<ScopePlot*> shown;
    for (std::size_t i = 0; i < m_plots.size(); ++i)
        if (!m_signals[i].empty())
            shown.push_back(m_plots[i]);
    return shown;
}

void ScopeStrips::renderTo(QPainter& painter) {
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const auto render = [&](auto* part) {
        painter.save();
        painter.translate(part->mapTo(this, QPoint()));
        part->renderTo(painter);
        painter.restore();
    };
    for (ScopePlot* plot : shownPlots())
        render(plot);
    if (m_setup.lane)
        render(m_lane);
}

void ScopeStrips::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    emit resized();
}

void ScopeStrips::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void ScopeStrips::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

void ScopeStrips::paintEvent(QPaintEvent* /*event*/) {
    if (!hasFocus())
        return;
    QPainter painter(this);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

}  // namespace nmc
