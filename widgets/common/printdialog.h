// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDialog>
#include <QStringList>

#include "widgets/common/filedialog.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace nmc {

class NumberField;
class Requests;

/// Asks for a printer and the number of copies, in a window of its own that blocks no other: the panel,
/// including STOP ALL, stays usable. It is open while printers are still being searched for.
class PrintDialog : public QDialog {
    Q_OBJECT

public:
    /// `last`: the printer that was used last, which is proposed if it exists.
    PrintDialog(const QString& last, Requests& requests, QWidget* window);

    void setPage(const QByteArray& pdf) { m_pdf = pdf; }
    /// Shows the printers known so far. `standard`: the system's default printer. `all`: the search has
    /// ended.
    void showPrinters(const QStringList& printers, const QString& standard, bool all);

signals:
    void printRequested(const QByteArray& pdf, const QString& printer, int copies);

private:
    void layOut();
    void showPossible();
    void print();
    void savePdf();

    Requests& m_requests;
    QByteArray m_pdf;
    QString m_chosen;  ///< the user's choice, now or last time
    QComboBox* m_printer;
    NumberField* m_copies;
    QLabel* m_state;
    QPushButton* m_print;
    QPushButton* m_save;
};

}  // namespace nmc
