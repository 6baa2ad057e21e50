// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QObject>
#include <QPointer>
#include <functional>

class QSettings;

namespace nmc {

class MainWindow;
class PrintDialog;

/// Asks for a printer and passes the page to it, using the system's own commands in separate processes, so
/// that no dialog, driver or print server can block the panel. GUI thread.
class Printing : public QObject {
    Q_OBJECT

public:
    /// `settings` stores the chosen printer.
    Printing(MainWindow& window, QSettings& settings);

private:
    void ask(const QByteArray& pdf);
    void lookFor(PrintDialog& dialog);
    /// Runs the command that lists printers with `option` and passes its output to `then`; abandoned when the
    /// dialog is gone.
    void lookUp(PrintDialog& dialog, const QString& option, const std::function<void(const QString&)>& then);
    void print(const QByteArray& pdf, const QString& printer, int copies);

    MainWindow& m_window;
    QSettings& m_settings;
    QPointer<PrintDialog> m_dialog;
};

}  // namespace nmc
