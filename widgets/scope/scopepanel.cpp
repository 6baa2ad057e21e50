// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopepanel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/words.h"
#include "widgets/scope/scopeplot.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kDivisions = 10;
constexpr double kRateWindow = 1.0;  ///< s over which samples are counted

double samplesPerSecond(const Series& series, TimePoint now) {
    // Columns far finer than any sample rate here, so that no sample is left out of the count.
    std::size_t count = 0;
    const TimePoint from = now - fromSeconds(kRateWindow);
    for (const Series::Segment& segment : series.window(from, now, 4000))
        for (const SeriesPoint& point : segment)
            if (point.time > from && point.time <= now)
                ++count;
    return static_cast<double>(count) / kRateWindow;
}
}  // namespace

ScopePanel::ScopePanel(QWidget* parent)
    : QWidget(parent),
      m_layout(new QVBoxLayout(this)),
      m_window(new QComboBox(this)),
      m_pause(new QToolButton(this)),
      m_which(look::newMutedLabel({}, this)) {
    look::name(this, u"scopePanel"_s, tr("Scope"));
    const int unit = look::gridUnit(this);
    m_layout->setContentsMargins(unit, unit / 2, unit, 0);
    m_layout->setSpacing(0);

    for (int seconds : {2, 10, 60})
        m_window->addItem(tr("%1 s").arg(seconds), seconds);
    m_window->setCurrentIndex(1);
    look::name(m_window, u"scopeWindowBox"_s, tr("Time shown by the scope"));
    m_window->setToolTip(tr("How much time the scope shows."));
    m_pause->setCheckable(true);
    m_pause->setText(tr("Pause"));
    m_pause->setIcon(icons::tinted(u"player-pause"_s));
    m_pause->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_pause->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_P));
    m_pause->setToolTip(tr("Holds the picture still (Ctrl+P). Samples are still recorded."));
    look::name(m_pause, u"scopePauseButton"_s, tr("Pause the scope"));

    auto* bar = new QHBoxLayout;
    bar->setSpacing(unit);
    auto* label = new QLabel(tr("Sho&w"), this);
    label->setBuddy(m_window);
    bar->addWidget(label);
    bar->addWidget(m_window);
    bar->addWidget(m_pause);
    bar->addWidget(m_which);
    bar->addStretch(1);
    m_layout->addLayout(bar);
    m_layout->addStretch(0);
}

void ScopePanel::build() {
    if (m_position != nullptr)
        return;
    m_position = new ScopePlot({{tr("position, counts"), look::TraceColour::Position, false},
                                {tr("command position, calculated"), look::TraceColour::Command, true}},
                               false, this);
    look::name(m_position, u"positionPlot"_s, tr("Position and calculated command position over time"));
    m_error = new ScopePlot({{tr("position error, calculated, counts"), look::TraceColour::Error, true}},
                            true, this);
    look::name(m_error, u"errorPlot"_s, tr("Calculated position error over time"));
    m_layout->addWidget(m_position, 3);
    m_layout->addWidget(m_error, 2);
    align();
}

/// The strips share one time axis, so their plot areas begin at the same place.
void ScopePanel::align() {
    const int width = std::max(m_position->labelWidth(), m_error->labelWidth());
    m_position->leaveLeft(width);
    m_error->leaveLeft(width);
}

void ScopePanel::showEvent(QShowEvent* event) {
    build();
    QWidget::showEvent(event);
}

bool ScopePanel::paused() const {
    return m_pause->isChecked();
}

double ScopePanel::windowSeconds() const {
    return m_window->currentData().toDouble();
}

void ScopePanel::forget() {
    m_origin.reset();
    m_ratesAt.reset();
    m_module.reset();
    look::setText(m_which, {});
    if (m_position != nullptr) {
        m_position->forget();
        m_error->forget();
    }
}

void ScopePanel::showHistory(ModuleIndex module, const ModuleHistory& history, TimePoint now) {
    if (!m_origin.has_value())
        m_origin = now;
    if (m_module != module) {
        m_module = module;
        look::setText(m_which, texts::moduleName(module));
        m_pause->setChecked(false);
        m_ratesAt.reset();
        if (m_position != nullptr) {
            m_position->forget();
            m_error->forget();
        }
    }
    if (m_position == nullptr || !isVisible() || paused())
        return;
    const double window = windowSeconds();
    const double division = window / kDivisions;
    // A division at a time: moving an axis costs Qt Charts as much as all the rest of a frame.
    const double right = std::ceil(toSeconds(now - *m_origin) / division) * division;
    const double labelled = window < 10 ? 0.5 : window < 60 ? 2 : 10;
    const ScopePlot::View view{*m_origin, right - window, right, labelled};
    m_position->showTraces(view, {&history.position, &history.command}, now);
    m_error->showTraces(view, {&history.error}, now);
    align();
    measureRates(history, now);
}

void ScopePanel::measureRates(const ModuleHistory& history, TimePoint now) {
    if (m_ratesAt.has_value() && toSeconds(now - *m_ratesAt) < kRateWindow)
        return;
    m_ratesAt = now;
    m_position->showRate(0, samplesPerSecond(history.position, now));
    m_position->showRate(1, samplesPerSecond(history.command, now));
    m_error->showRate(0, samplesPerSecond(history.error, now));
}

}  // namespace nmc
