// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/looptests/looptestsdock.h"

#include <QAction>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>

#include "widgets/common/focuskeeper.h"
#include "widgets/common/look.h"
#include "widgets/common/scrolled.h"
#include "widgets/common/sharedwords.h"
#include "widgets/looptests/frequencypage.h"
#include "widgets/looptests/squarewavepage.h"

namespace nmc {

using namespace Qt::StringLiterals;

LoopTestsDock::LoopTestsDock(Requests& requests, QWidget* parent)
    : LazyDock(u"loopTestsDock"_s, tr("Loop tests"), Qt::CTRL | Qt::Key_F9, parent), m_requests(requests) {
    toggleViewAction()->setToolTip(
        tr("Square wave, frequency response (Bode plot), and a report of the tuning"));
}

void LoopTestsDock::build() {
    if (m_tabs != nullptr)
        return;
    m_tabs = new QTabWidget(this);
    look::name(m_tabs, u"loopTestsTabs"_s, tr("Loop tests"));
    m_square = new SquareWavePage(m_requests, m_tabs);
    m_frequency = new FrequencyPage(m_requests, m_tabs);
    m_tabs->addTab(m_square, Common::tr("Square wave"));
    m_tabs->addTab(m_frequency, Common::tr("Frequency response"));
    keepFocusOnTabs(*m_tabs);
    m_report = new QPushButton(tr("Report…"), m_tabs);
    look::name(m_report, u"tuningReportButton"_s, tr("Report: save the tuning"));
    m_tabs->setCornerWidget(m_report);
    connect(m_report, &QPushButton::clicked, this, &LoopTestsDock::reportWanted);
    showReportPossible(false);
    setWidget(scrolled(m_tabs));
}

SquareWavePage& LoopTestsDock::squareWave() {
    build();
    return *m_square;
}

FrequencyPage& LoopTestsDock::frequency() {
    build();
    return *m_frequency;
}

void LoopTestsDock::showModule(const PanelView& view) {
    if (!seen())
        return;
    squareWave().showModule(view);
    frequency().showModule(view);
    showReportPossible(view.module.isServo());
}

void LoopTestsDock::forgetModules() {
    if (m_tabs == nullptr)
        return;
    m_square->forgetModules();
    m_frequency->forgetModules();
}

void LoopTestsDock::showNothing() {
    if (!seen())
        return;
    squareWave().showNothing();
    frequency().showNothing();
    showReportPossible(false);
}

void LoopTestsDock::showReportPossible(bool servo) {
    look::setPossible(
        m_report, servo ? QString() : tr("Select a PIC-SERVO first."),
        tr("Saves one page as PDF or HTML: gains, last step response, motor model and frequency response."));
}

}  // namespace nmc
