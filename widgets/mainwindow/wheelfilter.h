// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace nmc {

/// Watches the whole application for the wheel over combo boxes, spin boxes, sliders and fields: without the
/// focus, which a wheel does not give them either, it goes on to what scrolls around them.
class WheelFilter : public QObject {
    Q_OBJECT

public:
    explicit WheelFilter(QObject* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace nmc
