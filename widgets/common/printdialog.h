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

/// Asks on which printer a page is to be printed, and how often, in a window of its own that blocks no other:
/// the panel stays usable, and STOP ALL with it. It stands while the printers are looked for.
class PrintDialog : public QDialog {
    Q_OBJECT

public:
    /// `last`: the printer of the last time, which is proposed while there is one of that name.
    PrintDialog(const QString& last, QWidget* window);

    void setPage(const QByteArray& pdf) { m_pdf = pdf; }
    /// Those that are known by now, and the one that the system uses unless told otherwise. `all`: no more
    /// will come.
    void showPrinters(const QStringList& printers, const QString& standard, bool all);

signals:
    void printRequested(const QByteArray& pdf, const QString& printer, int copies);
    void saveRequested(const QString& path, const nmc::FileContent& content);

private:
    void layOut();
    void showPossible();
    void print();
    void savePdf();

    QByteArray m_pdf;
    QString m_chosen;  ///< by the user, now or the last time
    QComboBox* m_printer;
    NumberField* m_copies;
    QLabel* m_state;
    QPushButton* m_print;
    QPushButton* m_save;
};

}  // namespace nmc
