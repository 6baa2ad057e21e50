// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QObject>

namespace nmc {

class MainWindow;

/// Hands pages to the printer that the system uses unless told otherwise, by its own command for that: no
/// dialog, driver or print server can hold up the panel. GUI thread.
class Printing : public QObject {
    Q_OBJECT

public:
    explicit Printing(MainWindow& window, QObject* parent = nullptr);

private:
    void print(const QByteArray& pdf);

    MainWindow& m_window;
};

}  // namespace nmc
