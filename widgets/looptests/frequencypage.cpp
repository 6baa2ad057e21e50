// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/looptests/frequencypage.h"

#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "model/intent/gainsplan.h"
#include "model/intent/looptestplan.h"
#include "model/response/frequencyfile.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/looptests/looptestwords.h"
#include "widgets/looptests/testform.h"
#include "widgets/scope/scoperecord.h"

namespace nmc {

using namespace Qt::StringLiterals;

FrequencyPage::FrequencyPage(Requests& requests, QWidget* parent) : QWidget(parent), m_requests(requests) {
    look::name(this, u"frequencyPage"_s, Common::tr("Frequency response"));
    m_form = new TestForm(
        ProcedureKind::FrequencyResponse,
        {u"frequency"_s, tr("Measure"),
         tr("The motor swings around its position, slowly at first, then faster. Make sure that everything it drives can move freely.")},
        requests, this);
    auto* amplitude = m_form->addQuantity(QuantityField::Kind::Distance, u"frequencyAmplitudeField"_s,
                                          tr("Amplitude"), tr("The amplitude"));
    amplitude->setNativeRange(1, kWidestSine);
    amplitude->setMeaning(tr(
        "How far the command swings to either side. The motor is stopped if it swings four times as far."));
    amplitude->showNative(kFirstSine);
    auto* from =
        m_form->addNumber(u"frequencyFromField"_s, tr("From"), tr("The lowest frequency"), tr("Hz"), 2);
    from->setRange(kSlowestSine, kFastestSine);
    from->showValue(1.0);
    auto* to = m_form->addNumber(u"frequencyToField"_s, tr("To"), tr("The highest frequency"), tr("Hz"), 2);
    to->setRange(kSlowestSine, kFastestSine);
    to->setMeaning(tr(
        "The test ends earlier if the baud rate is too low: at about 40 Hz at 115 200 Bd, and at about 8 Hz at 19 200 Bd."));
    to->showValue(kFastestSine);
    auto* speed = m_form->addQuantity(QuantityField::Kind::Velocity, u"frequencySpeedField"_s,
                                      tr("Speed while measuring"), tr("The speed while measuring"));
    speed->setNativeRange(-kFastestRamp, kFastestRamp);
    speed->setMeaning(tr(
        "0: at rest. Otherwise the sines ride on a motion to and fro, forward first, or backwards first if it is negative; the motor never reverses within a sine, so dry friction does not show. It moves away by up to this speed times five periods of the lowest frequency."));
    speed->showNative(0.0);
    m_form->setWanted([=]() -> Intent {
        return intent::FrequencyResponse{static_cast<std::int32_t>(*amplitude->native()), *from->value(),
                                         *to->value(), *speed->native()};
    });
    m_figures = form::newParagraph(u"frequencyFigures"_s, tr("Results of the frequency response"), this, 6);
    m_save = form::newPush(
        {u"frequencyExportButton"_s, Common::tr("Export CSV…"), tr("Export CSV of the frequency response")},
        this);
    m_plot = new BodePlot(this);
    auto* left = form::newColumn(this, {m_form, m_figures, form::newLine(this, {m_save, nullptr}), nullptr});
    m_would = form::newParagraph(u"frequencyWouldDo"_s, tr("What the gains in the fields would do"), this, 3);
    auto* right = form::newColumn(this, {{m_plot, 1}, m_would});
    form::fill(this, form::newLine(this, {left, {right, 1}}), 0.5);
    connect(m_save, &QPushButton::clicked, this, &FrequencyPage::chooseFile);
    refresh();
}

void FrequencyPage::showModule(const PanelView& view) {
    m_form->showModule(view);
    m_shown = view.module.info.index;
    m_staged.reset();
    if (view.settings.gains)
        m_staged = gainsFor(view.module, *view.settings.gains);
    refresh();
}

void FrequencyPage::showNothing() {
    m_form->showNothing();
    m_shown.reset();
    refresh();
}

void FrequencyPage::forgetModules() {
    m_found.clear();
    refresh();
}

void FrequencyPage::showReport(const ProcedureReport& report, const QString& port, bool simulated) {
    if (report.frequencies.empty())
        return;
    const auto sameKind = [&report](const Found& found) {
        return (found.report.speed != 0.0) == (report.speed != 0.0);
    };
    const auto sameLoop = [&report](const Found& found) {
        return found.report.gains && report.gains &&
               changeOf(*found.report.gains, *report.gains) == LoopChange::None;
    };
    Responses& kept = m_found[report.module];
    if (kept.shown.empty() || kept.shown.back().report.over())
        kept.before = kept.shown;
    kept.shown = kept.before;
    std::erase_if(kept.shown, [&](const Found& found) { return sameKind(found) || !sameLoop(found); });
    kept.shown.push_back({report, QDateTime::currentDateTime(), port, simulated});
    const bool early = report.over() && report.stage != ProcedureStage::Done;
    kept.discarded = early && std::ranges::any_of(kept.before, [&](const Found& found) {
                         return sameKind(found) && sameLoop(found) &&
                                found.report.frequencies.size() >= report.frequencies.size();
                     });
    if (kept.discarded)
        kept.shown = kept.before;
    refresh();
}

const FrequencyPage::Found* FrequencyPage::last() const {
    const auto found = m_shown ? m_found.find(*m_shown) : m_found.end();
    return found != m_found.end() ? &found->second.shown.back() : nullptr;
}

std::vector<BodePlot::Curve> FrequencyPage::curves() {
    constexpr int kAtRest = 0, kMoving = 3, kPredicted = 1;
    std::vector<BodePlot::Curve> curves;
    QString would;
    if (last() != nullptr) {
        for (const Found& found : m_found.at(*m_shown).shown) {
            const bool moves = found.report.speed != 0.0;
            curves.push_back({moves ? tr("in motion") : tr("at rest"), found.report.frequencies,
                              moves ? kMoving : kAtRest});
        }
        const ProcedureReport& report = last()->report;
        if (!m_staged || !report.gains) {
            would = tr("Fill in all gains to see what this loop would do with them.");
        } else {
            const LoopChange change = changeOf(*report.gains, *m_staged);
            std::vector<FrequencyPoint> other;
            if (change == LoopChange::Filter)
                other = withOtherGains(report.frequencies, *report.gains, *m_staged);
            would = texts::wouldDo(report.frequencies, other, change);
            if (!other.empty())
                curves.push_back({tr("with the gains in the fields"), other, kPredicted, false,
                                  !isUnstable(figuresOf(other))});
        }
    }
    look::setText(m_would, would);
    return curves;
}

void FrequencyPage::refresh() {
    const auto points = last() != nullptr ? last()->report.frequencies : std::vector<FrequencyPoint>();
    const bool early = last() != nullptr && last()->report.stage == ProcedureStage::Done &&
                       last()->report.round < last()->report.rounds;
    m_plot->showCurves(curves(), early ? points.back().hertz : 0.0);
    QStringList lines = texts::frequencyFigures(points);
    if (early)
        lines << tr("The baud rate is too low for higher frequencies.");
    if (last() != nullptr && m_found.at(*m_shown).discarded)
        lines << tr("The last measurement ended early. The one before it is still shown.");
    look::setText(m_figures, lines.join(u'\n'));
    look::setPossible(m_save, points.empty() ? tr("No measurement yet.") : QString(),
                      tr("Saves frequency, magnitude and phase of the open and the closed loop."));
}

/// The file gets what was shown when it was asked for: another module may be selected before it is chosen.
void FrequencyPage::chooseFile() {
    const Found& found = *last();
    const auto content = [origin = recordingHeader({}, found.port, found.simulated, {}, found.measured),
                          name = texts::moduleName(found.report.module).toStdString(),
                          report = found.report] {
        const GainsChange gains{report.module, {}, report.gains};
        return frequencyCsv(origin, name, report.frequencies, gains, report.speed);
    };
    askWhereToSave(this,
                   {.objectName = u"frequencyFileDialog"_s,
                    .title = tr("Export the frequency response"),
                    .filters = {Common::tr("CSV (*.csv)")},
                    .proposed = u"frequency-response"_s},
                   [this, content](const QString& path) { emit m_requests.save(path, content); });
}

}  // namespace nmc
