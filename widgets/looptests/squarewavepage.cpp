// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/looptests/squarewavepage.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "model/intent/looptestplan.h"
#include "model/response/edgefold.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/looptests/squareplot.h"
#include "widgets/looptests/testform.h"
#include "widgets/response/responsewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr double kFirstPeriod = 0.6;  ///< s
constexpr unsigned kFirstWaves = 20;
constexpr std::int32_t kFirstExcursion = 200;

[[nodiscard]] SquarePlot::Fold drawn(std::span<const ResponseRecord> edges,
                                     const std::optional<EdgeFold>& forward) {
    if (edges.empty())
        return {};
    const ResponseTaken& last = edges.back().taken;
    SquarePlot::Fold fold;
    fold.counts = static_cast<double>(std::abs(std::int64_t{last.goal} - last.from));
    fold.half = last.record;
    if (forward)
        fold.forward = forward->points;
    if (auto back = foldEdges(edges, false))
        fold.back = std::move(back->points);
    // The samples before the backward edge are the end of the forward one.
    std::erase_if(fold.back, [](const FoldedPoint& point) { return point.seconds < 0; });
    return fold;
}
}  // namespace

SquareWavePage::SquareWavePage(Requests& requests, QWidget* parent) : QWidget(parent), m_requests(requests) {
    look::name(this, u"squareWavePage"_s, Common::tr("Square wave"));
    m_form = new TestForm(
        ProcedureKind::SquareWave,
        {u"squareWave"_s, tr("Start test"),
         tr("The motor jumps back and forth around its position. Make sure that everything it drives can move freely.")},
        requests, this);
    auto* counts = m_form->addQuantity(QuantityField::Kind::Distance, u"squareWaveDistanceField"_s,
                                       tr("Distance"), tr("The distance"));
    counts->setNativeRange(1, kLongestStep);
    counts->setMeaning(tr("From side to side: half to either side of the present position."));
    counts->showNative(kFirstStep);
    auto* period =
        m_form->addNumber(u"squareWavePeriodField"_s, tr("Period"), tr("The period"), Common::tr("s"), 2);
    period->setRange(kShortestPeriod, kLongestPeriod);
    period->showValue(kFirstPeriod);
    auto* rounds = m_form->addNumber(u"squareWaveRoundsField"_s, tr("Periods"), tr("Periods to run"), {}, 0);
    rounds->setRange(1, kMaxPeriods);
    rounds->showValue(kFirstWaves);
    auto* excursion = m_form->addQuantity(QuantityField::Kind::Distance, u"squareWaveExcursionField"_s,
                                          tr("Excursion"), tr("Excursion"));
    excursion->setNativeRange(1, kLongestStep);
    excursion->setMeaning(
        tr("How far the motor may move past either side. Beyond that, the test stops and the motor holds."));
    excursion->showNative(kFirstExcursion);
    auto* method =
        form::newChoice({u"squareWaveMethodBox"_s, Common::tr("Method: how the command jumps"), {}}, this);
    for (const ResponseMethod one : {ResponseMethod::StopHere, ResponseMethod::Profile})
        method->addItem(texts::responseMethod(one), static_cast<int>(one));
    method->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    method->setMinimumContentsLength(12);
    m_form->addRow(Common::tr("Method"), method, nullptr);
    m_form->setWanted([=]() -> Intent {
        return intent::SquareWave{static_cast<std::int32_t>(*counts->native()), *period->value(),
                                  static_cast<unsigned>(*rounds->value()),
                                  static_cast<std::int32_t>(*excursion->native()),
                                  form::chosen<ResponseMethod>(method)};
    });
    m_results = form::newParagraph(u"squareWaveResults"_s, tr("Results of the edges"), this, 5);
    m_keep = form::newPush(
        {u"squareWaveKeepButton"_s, tr("Keep as a run"), tr("Keep as a run: the median edge")}, this);
    m_plot = new SquarePlot(this);
    auto* left = form::newColumn(this, {m_form, m_results, form::newLine(this, {m_keep, nullptr}), nullptr});
    form::fill(this, form::newLine(this, {left, {m_plot, 1}}), 0.5);
    connect(m_keep, &QPushButton::clicked, this, &SquareWavePage::keep);
    refresh();
}

void SquareWavePage::showModule(const PanelView& view) {
    m_form->showModule(view);
    const ModuleIndex module = view.module.info.index;
    if (std::exchange(m_shown, module) != module)
        refresh();
}

void SquareWavePage::showNothing() {
    m_form->showNothing();
}

void SquareWavePage::forgetModules() {
    m_waves.clear();
    refresh();
}

void SquareWavePage::clear(ModuleIndex module) {
    m_waves.erase(module);
    refresh();
}

void SquareWavePage::showEdge(KeptResponse edge) {
    Wave& wave = m_waves[edge.run.module];
    wave.edges.push_back(edge.run);
    wave.labels = std::move(edge);
    refresh();
}

const SquareWavePage::Wave* SquareWavePage::shown() const {
    const auto found = m_shown ? m_waves.find(*m_shown) : m_waves.end();
    return found != m_waves.end() ? &found->second : nullptr;
}

void SquareWavePage::refresh() {
    const Wave none{};
    const Wave& wave = shown() != nullptr ? *shown() : none;
    const std::vector<ResponseRecord>& edges = wave.edges;
    // The edges before the last change of the gains.
    const auto changed = std::find_if(edges.rbegin(), edges.rend(), [&](const ResponseRecord& edge) {
        return edge.taken.gains != edges.back().taken.gains;
    });
    const std::span<const ResponseRecord> before(edges.begin(), changed.base());
    const std::span<const ResponseRecord> now(changed.base(), edges.end());
    const auto forward = foldEdges(now, true);
    m_plot->showFold(drawn(now, forward), drawn(before, foldEdges(before, true)), wave.labels.scale);
    m_folded = forward ? std::optional(forward->run) : std::nullopt;
    QStringList lines;
    if (m_folded) {
        const ResponseMetrics& metrics = m_folded->metrics;
        lines << tr("Edges with these gains: %1").arg(now.size())
              << Common::tr("Rise %1").arg(texts::responseTime(metrics.rise))
              << Common::tr("Overshoot %1").arg(texts::responseOvershoot(metrics.overshoot))
              << tr("Settling %1").arg(texts::responseTime(metrics.settling))
              << Common::tr("Steady-state error %1")
                     .arg(texts::responseError(metrics.steadyError, wave.labels.scale));
    }
    look::setText(m_results, lines.join(u'\n'));
    look::setPossible(m_keep, m_folded ? QString() : tr("No edge recorded yet."),
                      tr("Adds the median of the rising edges to the list of step responses."));
}

void SquareWavePage::keep() {
    if (!m_folded)
        return;
    KeptResponse kept = shown()->labels;
    kept.run = *m_folded;
    emit m_requests.showRun(kept);
}

}  // namespace nmc
