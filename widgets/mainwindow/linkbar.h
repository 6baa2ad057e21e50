// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStatusBar>

#include "model/module/linkstate.h"

class QLabel;

namespace nmc {

/// The status bar: the link in words and, updated once a second, in figures.
class LinkBar : public QStatusBar {
    Q_OBJECT

public:
    explicit LinkBar(QWidget* parent = nullptr);

    void showLink(const LinkState& state);
    void showFigures(const LinkFigures& figures);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Shows the figures for which there is room beside the words.
    void makeRoom();

    QLabel* m_link;
    QLabel* m_rate;
    QLabel* m_errors;
    QLabel* m_roundTrip;
    bool m_connected = false;
};

}  // namespace nmc
