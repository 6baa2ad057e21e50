// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/servopanel.h"

#include <QHBoxLayout>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/common/look.h"
#include "widgets/panels/detailsbox.h"
#include "widgets/panels/gainsbox.h"
#include "widgets/panels/motionbox.h"
#include "widgets/panels/panelhead.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// Stops are never held back; everything else waits for the answer to the click before.
bool isStop(const Intent& intent) {
    return std::holds_alternative<intent::StopSmoothly>(intent) ||
           std::holds_alternative<intent::StopAbruptly>(intent) ||
           std::holds_alternative<intent::MotorOff>(intent);
}
}  // namespace

ServoPanel::ServoPanel(QWidget* parent)
    : QWidget(parent),
      m_head(new PanelHead(PanelHead::Drive::Servo, this)),
      m_motion(new MotionBox(this)),
      m_pages(new QTabWidget(this)),
      m_gains(new GainsBox(this)),
      m_details(new DetailsBox(this)) {
    look::name(this, u"servoPanel"_s, tr("Servo module"));
    look::name(m_pages, u"servoPages"_s, tr("Gains and details"));
    m_pages->setDocumentMode(true);
    m_pages->addTab(m_gains, tr("Gains"));
    m_pages->addTab(m_details, tr("Details"));
    m_pages->tabBar()->setAccessibleName(tr("Pages of the module"));
    m_pages->tabBar()->setObjectName(u"servoPagesBar"_s);

    const int unit = look::gridUnit(this);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(unit * 3 / 2);
    columns->addWidget(m_motion, 5);
    columns->addWidget(m_pages, 4);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit, unit / 2, unit, unit);
    layout->setSpacing(unit / 2);
    layout->addWidget(m_head);
    layout->addLayout(columns, 1);

    connect(m_head, &PanelHead::intentRequested, this, &ServoPanel::pass);
    connect(m_motion, &MotionBox::intentRequested, this, &ServoPanel::pass);
    connect(m_details, &DetailsBox::intentRequested, this, &ServoPanel::pass);
    connect(m_gains, &GainsBox::applyRequested, this,
            [this](const servo::SetGain& gains) { pass(intent::ApplyGains{gains}); });
    connect(m_motion, &MotionBox::holdRequested, this, &ServoPanel::holdRequested);
    connect(m_motion, &MotionBox::holdReleased, this, &ServoPanel::holdReleased);
}

void ServoPanel::pass(const Intent& intent) {
    if (!isStop(intent)) {
        if (m_askedAt.has_value())
            return;
        m_askedAt = m_latestTime;
        setBusy(true);
    }
    emit intentRequested(m_module, intent);
}

void ServoPanel::setBusy(bool busy) {
    m_head->setBusy(busy);
    m_motion->setBusy(busy);
    m_gains->setBusy(busy);
    m_details->setBusy(busy);
}

void ServoPanel::showModule(const PanelView& view) {
    const ModuleState& module = view.module;
    if (m_askedAt.has_value() &&
        (module.info.index != m_module || module.latestTime != *m_askedAt || !view.connected)) {
        m_askedAt.reset();
        setBusy(false);
    }
    m_module = module.info.index;
    m_latestTime = module.latestTime;
    const auto why = [module, connected = view.connected](Request request) {
        return connected ? whyNot(request, module) : std::optional(Refusal::NotConnected);
    };
    m_head->showModule(module, why, view.age);
    m_motion->showModule(module, why);
    m_gains->showModule(module, why(Request::ApplyGains));
    m_details->showModule(module, why);
}

void ServoPanel::resetSpeeds() {
    m_motion->resetSpeeds();
}

void ServoPanel::endHold() {
    m_motion->endHold();
}

void ServoPanel::setHoldInterval(int milliseconds) {
    m_motion->setHoldInterval(milliseconds);
}

}  // namespace nmc
