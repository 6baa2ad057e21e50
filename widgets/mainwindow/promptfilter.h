// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace nmc {

/// Watches the whole application for shortcuts and mnemonics of buttons, and makes them act at once. Qt would
/// first show the button pressed for 100 ms, and then click it whatever it does by then: a stop would be
/// delayed, and a move might be that of another module.
class PromptFilter : public QObject {
    Q_OBJECT

public:
    /// Create it before the RepeatFilter, which then receives events first.
    explicit PromptFilter(QObject* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace nmc
