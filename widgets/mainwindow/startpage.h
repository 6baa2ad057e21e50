// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace nmc {

class ChoiceButton;
class ConnectionBar;

/// The centre of the window while nothing is connected: the serial port and the simulator as two large
/// choices, each with what it needs. They act as the connection bar does with its port, rate and Connect.
class StartPage : public QWidget {
    Q_OBJECT

public:
    /// `bar` must outlive it.
    StartPage(ConnectionBar& bar, QWidget* parent);

private:
    void refresh();
    void connectToSerialPort();

    ConnectionBar& m_bar;
    ChoiceButton* m_serial;
};

}  // namespace nmc
