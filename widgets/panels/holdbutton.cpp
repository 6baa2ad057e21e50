// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/holdbutton.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>

#include "model/intent/jog.h"
#include "widgets/common/icons.h"
#include "widgets/common/sharedwords.h"
#include "widgets/panels/modulecontext.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kEvidenceInterval = 100;  // ms; the bus thread waits up to 250
}  // namespace

HoldButton::HoldButton(QWidget* parent) : QPushButton(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAutoDefault(false);
    m_timer.setInterval(kEvidenceInterval);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &HoldButton::held);
    connect(qGuiApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (state != Qt::ApplicationActive)
            endHold();
    });
}

void HoldButton::begin(double share) {
    if (isHeld() || !isEnabled())
        return;
    m_share = share;
    m_press = nextPress();
    m_timer.start();
    emit held();
}

void HoldButton::beginHold(double share) {
    if (!isVisible())
        return;
    setDown(isEnabled());
    begin(share);
}

void HoldButton::setShare(double share) {
    if (isHeld() && std::exchange(m_share, share) != share)
        emit held();
}

void HoldButton::endHold() {
    if (!isHeld())
        return;
    m_timer.stop();
    setDown(false);
    emit holdEnded();
}

bool HoldButton::event(QEvent* event) {
    const QEvent::Type type = event->type();
    const bool ends = type == QEvent::FocusOut || type == QEvent::Hide || type == QEvent::WindowDeactivate ||
                      type == QEvent::WindowBlocked || type == QEvent::TouchCancel ||
                      type == QEvent::ContextMenu || type == QEvent::Wheel ||
                      (type == QEvent::EnabledChange && !isEnabled());
    if (ends)
        endHold();
    return QPushButton::event(event);
}

void HoldButton::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || isHeld()) {
        endHold();
        event->accept();
        return;
    }
    setFocus(Qt::MouseFocusReason);
    QPushButton::mousePressEvent(event);
    begin();
}

void HoldButton::mouseMoveEvent(QMouseEvent* event) {
    if (isHeld() && !hitButton(event->position().toPoint()))
        endHold();
    // Not passed to the base class, which would press the button again when the pointer comes back.
    event->accept();
}

void HoldButton::mouseReleaseEvent(QMouseEvent* event) {
    endHold();
    QPushButton::mouseReleaseEvent(event);
}

void HoldButton::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Space) {
        endHold();
        return QPushButton::keyPressEvent(event);
    }
    event->accept();
    if (event->isAutoRepeat())
        return;
    if (isHeld())
        return endHold();
    setDown(true);
    begin();
}

void HoldButton::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Space) {
        endHold();
        return QPushButton::keyReleaseEvent(event);
    }
    event->accept();
    if (event->isAutoRepeat())
        return;
    setDown(false);
    endHold();
}

HoldButton* newJogButton(ModuleContext& context, bool reverse, const WantedHold& wanted, QWidget* parent) {
    auto* button = new HoldButton(parent);
    button->setIcon(icons::tinted(u"hand-stop"_s));
    button->setText(reverse ? Common::tr("◂ Hold") : Common::tr("Hold ▸"));
    QObject::connect(button, &HoldButton::held, &context, [&context, button, wanted] {
        auto hold = wanted(button->share());
        if (!hold)
            return;
        hold->press = button->press();
        context.hold(*hold);
    });
    QObject::connect(button, &HoldButton::holdEnded, &context, &ModuleContext::release);
    return button;
}

}  // namespace nmc
