// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace nmc {

/// Watches the whole application for the wheel over combo boxes, spin boxes, sliders and fields: without the
/// focus, which the wheel does not give them either, they ignore it, and what surrounds them scrolls.
class WheelFilter : public QObject {
    Q_OBJECT

public:
    explicit WheelFilter(QObject* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace nmc
