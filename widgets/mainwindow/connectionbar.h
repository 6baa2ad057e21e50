// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QFrame>
#include <QList>

#include "link/ports/linktypes.h"
#include "model/module/linkstate.h"

class QAction;
class QPushButton;
class QToolButton;

namespace nmc {

class ElidedLabel;
class StopButton;

/// A combo box that says when its list is about to be opened. What is not in the list can be typed.
class PortBox : public QComboBox {
    Q_OBJECT

public:
    explicit PortBox(QWidget* parent);
    void showPopup() override {
        emit aboutToOpen();
        QComboBox::showPopup();
    }

signals:
    void aboutToOpen();
};

/// Top of the window: port, rate, Connect (with a menu of its other way) and Disconnect; at the far right,
/// alone, STOP ALL. Not a QToolBar, which hides what does not fit.
class ConnectionBar : public QFrame {
    Q_OBJECT

public:
    explicit ConnectionBar(QWidget* parent = nullptr);

    /// The simulator and the chosen port are always in the list, whatever is plugged in.
    void showPorts(const QList<PortEntry>& ports);
    [[nodiscard]] const QList<PortEntry>& ports() const { return m_ports; }
    void choosePort(const QString& port, quint32 baud);
    /// The port as chosen, where it is a serial one, or else the first that is listed; without a name: none.
    [[nodiscard]] PortEntry serialPort() const;
    /// How many are listed.
    [[nodiscard]] qsizetype serialPorts() const { return m_ports.size(); }
    /// The simulator with the chain that was chosen last.
    [[nodiscard]] QString simulator() const;
    /// Chooses it, and connects as Connect does.
    void connectTo(const QString& port);
    /// Opens the list of ports, as a click on it would.
    void openPorts();
    void showLink(const LinkState& state);
    /// Stands beside STOP ALL until the next change of the link.
    void showStopResult(const QString& text);
    [[nodiscard]] const QWidget& stopButton() const;
    /// "Connect read-only", for a menu as well.
    [[nodiscard]] QAction* readOnlyAction() const { return m_readOnly; }

    [[nodiscard]] QString port() const;
    [[nodiscard]] quint32 baud() const;

signals:
    void connectRequested(const QString& port, quint32 baud, bool readOnly);
    void disconnectRequested();
    void stopAllRequested();
    void portsRequested();
    /// Ports, port or rate.
    void choiceChanged();

private:
    void fillPorts();
    void requestConnect(bool readOnly);

    PortBox* m_port;
    QComboBox* m_baud;
    QPushButton* m_connect;
    QAction* m_readOnly;
    QToolButton* m_moreWays;  ///< to connect
    QPushButton* m_disconnect;
    ElidedLabel* m_stopResult;
    StopButton* m_stop;
    QList<PortEntry> m_ports;
    QString m_chosen;  ///< empty until the user or the command line chose
    QString m_linkSeen;
};

}  // namespace nmc
