// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <cstdint>
#include <vector>

#include "model/machinefile/machinecompare.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace nmc {

/// Shows what opening a machine file, or copying settings of an axis, would change: one row for each part,
/// with a check box if it can be applied, and its fields below it. Nothing is changed or sent before Apply.
/// Not modal; Esc drops the file or the copy, and stops the motors as everywhere.
class DifferencesDialog : public QDialog {
    Q_OBJECT

public:
    explicit DifferencesDialog(QWidget* parent);

    /// Replaces what was shown, including the check marks. Emits nothing.
    void showDifferences(const QString& file, std::vector<Difference> differences);
    /// The same for settings to be copied from that axis.
    void showCopy(ModuleIndex from, std::vector<Difference> differences);
    /// `motors`: how many motors are moving; until all have stopped, nothing can be sent.
    void showMoving(int motors);

signals:
    void applyRequested(const std::vector<nmc::PartId>& chosen);

private:
    enum Column : std::uint8_t { kWhat, kFile, kNow, kApplying, kColumns };

    void build();
    void showRows(const QString& title, const QString& source, std::vector<Difference> differences);
    void addRow(const Difference& difference);
    void tickAll(bool ticked);
    void summarise();
    [[nodiscard]] std::vector<PartId> chosen() const;
    [[nodiscard]] int sendings() const;
    [[nodiscard]] bool ticked(int row) const;

    QLabel* m_text;
    QTreeWidget* m_table;
    QLabel* m_summary;
    QPushButton* m_all;
    QPushButton* m_none;
    QPushButton* m_apply;
    QPushButton* m_cancel;
    std::vector<Difference> m_differences;  ///< one for each row
    int m_moving = 0;
};

}  // namespace nmc
