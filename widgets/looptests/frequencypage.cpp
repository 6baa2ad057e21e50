// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/looptests/frequencypage.h"

#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>

#include "model/intent/looptestplan.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/looptests/bodeplot.h"
#include "widgets/looptests/looptestwords.h"
#include "widgets/looptests/testform.h"

namespace nmc {

using namespace Qt::StringLiterals;

FrequencyPage::FrequencyPage(Requests& requests, QWidget* parent) : QWidget(parent), m_requests(requests) {
    look::name(this, u"frequencyPage"_s, Common::tr("Frequency response"));
    m_form = new TestForm(
        ProcedureKind::FrequencyResponse,
        {u"frequency"_s, tr("Measure"),
         tr("The motor swings around its position, slowly at first, then faster. Make sure that everything it drives can move freely.")},
        requests, this);
    m_amplitude = m_form->addDistance(u"frequencyAmplitudeField"_s, tr("Amplitude"), tr("The amplitude"));
    m_amplitude->setNativeRange(1, kWidestSine);
    m_amplitude->setMeaning(tr(
        "How far the command swings to either side. The motor is stopped if it swings four times as far."));
    m_amplitude->showNative(kFirstSine);
    m_from = m_form->addNumber(u"frequencyFromField"_s, tr("From"), tr("The lowest frequency"), tr("Hz"), 2);
    m_from->setRange(kSlowestSine, kFastestSine);
    m_from->showValue(1.0);
    m_to = m_form->addNumber(u"frequencyToField"_s, tr("To"), tr("The highest frequency"), tr("Hz"), 2);
    m_to->setRange(kSlowestSine, kFastestSine);
    m_to->setMeaning(tr(
        "The test ends earlier if the baud rate is too low: at about 40 Hz at 115 200 Bd, and at about 8 Hz at 19 200 Bd."));
    m_to->showValue(kFastestSine);
    m_form->setWanted([this]() -> Intent {
        return intent::FrequencyResponse{static_cast<std::int32_t>(*m_amplitude->native()), *m_from->value(),
                                         *m_to->value()};
    });
    m_figures = form::newParagraph(u"frequencyFigures"_s, tr("Results of the frequency response"), this, 6);
    m_save = form::newPush(
        {u"frequencyExportButton"_s, Common::tr("Export CSV…"), tr("Export CSV of the frequency response")},
        this);
    m_plot = new BodePlot(this);
    auto* left = form::newColumn(this, {m_form, m_figures, form::newLine(this, {m_save, nullptr}), nullptr});
    form::fill(this, form::newLine(this, {left, {m_plot, 1}}), 0.5);
    connect(m_save, &QPushButton::clicked, this, &FrequencyPage::chooseFile);
    refresh();
}

void FrequencyPage::showModule(const PanelView& view) {
    m_form->showModule(view);
    m_shown = view.module.info.index;
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

void FrequencyPage::showReport(const ProcedureReport& report) {
    if (report.frequencies.empty())
        return;
    m_found[report.module] = {report.frequencies,
                              report.stage == ProcedureStage::Done && report.round < report.rounds,
                              QDateTime::currentDateTime()};
    refresh();
}

const std::vector<FrequencyPoint>& FrequencyPage::points() const {
    static const std::vector<FrequencyPoint> kNone;
    const auto found = m_shown ? m_found.find(*m_shown) : m_found.end();
    return found != m_found.end() ? found->second.points : kNone;
}

void FrequencyPage::refresh() {
    const auto found = m_shown ? m_found.find(*m_shown) : m_found.end();
    const bool early = found != m_found.end() && found->second.endedEarly;
    m_plot->showPoints(points(), early ? points().back().hertz : 0.0);
    QStringList lines = texts::frequencyFigures(points());
    if (early)
        lines << tr("The baud rate is too low for higher frequencies.");
    look::setText(m_figures, lines.join(u'\n'));
    look::setPossible(m_save, points().empty() ? tr("No measurement yet.") : QString(),
                      tr("Saves frequency, magnitude and phase of the open and the closed loop."));
}

void FrequencyPage::chooseFile() {
    QFileDialog* dialog = newFileDialog(this, u"frequencyFileDialog"_s, tr("Export the frequency response"),
                                        {Common::tr("CSV (*.csv)")}, QDir::homePath());
    if (dialog == nullptr)
        return;
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(u"csv"_s);
    dialog->selectFile(u"frequency-response"_s);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        if (const auto found = m_shown ? m_found.find(*m_shown) : m_found.end(); found != m_found.end())
            emit m_requests.saveFrequencies(path, found->second.measured);
    });
    dialog->show();
}

}  // namespace nmc
