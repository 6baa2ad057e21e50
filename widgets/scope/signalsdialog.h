// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "widgets/scope/scopesetup.h"

class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace nmc {

/// Table for choosing which signals of which modules each strip shows. Changes take effect at once.
class SignalsDialog : public QDialog {
    Q_OBJECT

public:
    SignalsDialog(const ScopeSetup& setup, const std::vector<ScopeModule>& modules, QWidget* parent);

signals:
    void setupChosen(const nmc::ScopeSetup& setup);

private:
    /// Fills the table.
    void showModules();
    void defineTraces();
    void addRows(const QString& title, std::optional<ModuleIndex> module, const ScopeModule* of);
    void take(QTreeWidgetItem* item, int column);
    void showSetup();
    void filter(const QString& text);

    ScopeSetup m_setup;
    std::vector<ScopeModule> m_modules;  ///< without the user's own traces
    QLineEdit* m_filter;
    QTreeWidget* m_table;
};

}  // namespace nmc
