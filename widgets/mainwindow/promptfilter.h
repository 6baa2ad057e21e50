// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace nmc {

/// Watches the whole application for shortcuts and mnemonics of buttons, which act at once by it. Qt shows
/// the button pressed for 100 ms first, and clicks it then whatever has become of it: a stop would wait for
/// that, and a move might be another module's.
class PromptFilter : public QObject {
    Q_OBJECT

public:
    /// Before the filter that keeps repeats away, which is asked first then.
    explicit PromptFilter(QObject* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace nmc
