// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/askdialog.h"

namespace nmc {

/// "The changes to "mill" are not saved." Save first, go on without, or stay. Esc stays, and stops the
/// motors.
class UnsavedDialog : public AskDialog {
    Q_OBJECT

public:
    enum class Before : std::uint8_t {
        Closing,    ///< the work is kept, and offered at the next start
        Replacing,  ///< by another machine: the work is lost
    };
    UnsavedDialog(Before before, const QString& machine, QWidget* parent);

signals:
    void saveChosen();
    void goOnChosen();
};

}  // namespace nmc
