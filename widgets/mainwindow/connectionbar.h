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

/// A combo box that reports when its list is about to be opened. Ports that are not in the list can be typed.
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

/// Top of the window: port, rate, Connect (with a menu of other ways to connect) and Disconnect; at the far
/// right, by itself, STOP ALL. Not a QToolBar, which hides what does not fit.
class ConnectionBar : public QFrame {
    Q_OBJECT

public:
    explicit ConnectionBar(QWidget* parent = nullptr);

    /// The simulator and the chosen port are always in the list, whatever is plugged in.
    void showPorts(const QList<PortEntry>& ports);
    [[nodiscard]] const QList<PortEntry>& ports() const { return m_ports; }
    /// Puts a port (listed or not) and a rate into the bar; 0 keeps the rate. Does not connect.
    void choosePort(const QString& port, quint32 baud);
    /// The chosen port if it is a serial port, otherwise the first one in the list; without a name if there
    /// is none.
    [[nodiscard]] PortEntry serialPort() const;
    /// Number of serial ports in the list.
    [[nodiscard]] qsizetype serialPorts() const { return m_ports.size(); }
    /// The simulator, with the chosen chain if the chosen port is a simulator.
    [[nodiscard]] QString simulator() const;
    /// Chooses this port, and connects as the Connect button does.
    void connectTo(const QString& port);
    /// Opens the list of ports, as a click on it would.
    void openPorts();
    void showLink(const LinkState& state);
    /// Shows the result beside STOP ALL until a motor moves or the port is closed.
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
    /// The list of ports is about to be opened.
    void portsRequested();
    /// The list of ports, the chosen port or the rate has changed.
    void choiceChanged();

private:
    void fillPorts();
    void requestConnect(bool readOnly);

    PortBox* m_port;
    QComboBox* m_baud;
    QPushButton* m_connect;
    QAction* m_readOnly;
    QToolButton* m_moreWays;  ///< other ways to connect
    QPushButton* m_disconnect;
    ElidedLabel* m_stopResult;
    StopButton* m_stop;
    QList<PortEntry> m_ports;
    QString m_chosen;  ///< empty until the user or the command line chooses a port
    QString m_linkSeen;
};

}  // namespace nmc
