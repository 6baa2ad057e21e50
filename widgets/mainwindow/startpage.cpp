// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/startpage.h"

#include <QScrollArea>

#include "link/ports/linktypes.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/scrolled.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/mainwindow/choicebutton.h"
#include "widgets/mainwindow/connectionbar.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kWidestChoices = 44;  ///< in lines of text
}

StartPage::StartPage(ConnectionBar& bar, QWidget* parent)
    : QWidget(parent),
      m_bar(bar),
      m_serial(new ChoiceButton(u"startSerialButton"_s, u"plug-connected"_s, this)) {
    auto* simulator = new ChoiceButton(u"startSimulatorButton"_s, u"player-play"_s, this);
    look::name(this, u"startPage"_s, tr("Start"));
    simulator->showChoice(
        tr("Start the simulator"),
        tr("Needs no hardware. Three simulated modules to try everything on; no real motor moves."));
    m_serial->setToolTip(Common::tr("Opens the port and looks for modules. Nothing moves."));
    simulator->setToolTip(tr("Connects to the built-in simulator."));
    auto* choices = new QWidget;
    choices->setObjectName(u"startChoices"_s);
    choices->setMaximumWidth(fontMetrics().height() * kWidestChoices);
    form::fill(choices, form::newColumn(this, {nullptr, m_serial, simulator, nullptr}, 2), 2);
    auto* middle = new QWidget;
    middle->setObjectName(u"startMiddle"_s);
    form::fill(middle, form::newLine(this, {nullptr, {choices, 1000}, nullptr}, form::kUsual));
    form::fill(this, form::newColumn(this, {scrolled(middle, u"startScroll"_s, accessibleName())}));
    connect(m_serial, &QPushButton::clicked, this, &StartPage::connectToSerialPort);
    connect(simulator, &QPushButton::clicked, &m_bar, [this] { m_bar.connectTo(m_bar.simulator()); });
    connect(&m_bar, &ConnectionBar::choiceChanged, this, &StartPage::refresh);
    refresh();
}

void StartPage::connectToSerialPort() {
    if (const PortEntry port = m_bar.serialPort(); !port.name.isEmpty())
        m_bar.connectTo(port.name);
    else
        m_bar.openPorts();
}

void StartPage::refresh() {
    const PortEntry port = m_bar.serialPort();
    if (port.name.isEmpty()) {
        m_serial->showChoice(tr("Choose a serial port…"),
                             tr("No serial port found. Plug in the modules' adapter; it then appears here."));
        return;
    }
    const QString what = port.description.isEmpty()
                             ? tr("%1 Bd.").arg(texts::rate(m_bar.baud()))
                             : tr("%1, %2 Bd.").arg(port.description, texts::rate(m_bar.baud()));
    m_serial->showChoice(
        tr("Connect to %1").arg(port.name),
        what + u' ' + tr("The modules must be powered and their cable plugged in.") +
            (m_bar.serialPorts() > 1 ? u' ' + tr("Other ports are in the list above.") : QString()));
}

}  // namespace nmc
