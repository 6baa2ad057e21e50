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

/// Asks for the printer and hands it the page, by the system's own commands beside the panel: no dialog,
/// driver or print server can hold it up. GUI thread.
class Printing : public QObject {
    Q_OBJECT

public:
    /// `settings` keep the printer that was chosen.
    Printing(MainWindow& window, QSettings& settings, QObject* parent = nullptr);

private:
    void ask(const QByteArray& pdf);
    void lookFor(PrintDialog& dialog);
    /// What `option` of the command that names printers brings; it is given up when the dialog is gone.
    void lookUp(PrintDialog& dialog, const QString& option, const std::function<void(const QString&)>& then);
    void print(const QByteArray& pdf, const QString& printer, int copies);

    MainWindow& m_window;
    QSettings& m_settings;
    QPointer<PrintDialog> m_dialog;
};

}  // namespace nmc
