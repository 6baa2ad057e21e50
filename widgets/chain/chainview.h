// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListView>
#include <map>

#include "model/module/linkstate.h"
#include "model/procedure/procedure.h"
#include "model/settings/machine.h"

namespace nmc {

class ChainModel;

/// The chain as a list. Selecting a row requests that the panel and the scope show its module.
class ChainView : public QListView {
    Q_OBJECT

public:
    explicit ChainView(QWidget* parent = nullptr);

    /// Emits nothing.
    void showLink(const LinkState& state, const Machine& machine,
                  const std::map<ModuleIndex, ProcedureReport>& procedures);
    void showSelected(ModuleIndex module);

    [[nodiscard]] QSize sizeHint() const override;

signals:
    void moduleSelected(nmc::ModuleIndex module);

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void dataChanged(const QModelIndex& topLeft, const QModelIndex& bottomRight,
                     const QList<int>& roles) override;
    void paintEvent(QPaintEvent* event) override;

private:
    ChainModel* m_model;
    bool m_showing = false;
};

}  // namespace nmc
