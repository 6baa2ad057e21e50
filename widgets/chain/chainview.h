// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListView>
#include <map>
#include <optional>

#include "model/module/linkstate.h"
#include "model/procedure/procedure.h"
#include "model/settings/machine.h"

namespace nmc {

class ChainModel;

/// The chain as a list; selecting a row selects the module that the panel and the scope show.
class ChainView : public QListView {
    Q_OBJECT

public:
    explicit ChainView(QWidget* parent = nullptr);

    /// Emits nothing, not even when the first chain appears and its first module becomes the selected one.
    void showLink(const LinkState& state, const Machine& machine,
                  const std::map<ModuleIndex, ProcedureReport>& procedures);
    [[nodiscard]] std::optional<ModuleIndex> selectedModule() const;
    /// Selects the module, like a click on its row.
    void choose(ModuleIndex module);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    void moduleSelected(nmc::ModuleIndex module);

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void paintEvent(QPaintEvent* event) override;

private:
    ChainModel* m_model;
    bool m_showing = false;
    int m_lastRow = 0;  ///< the last row selected; kept while there is no chain
};

}  // namespace nmc
