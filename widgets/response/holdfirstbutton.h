// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <optional>

#include "model/intent/intent.h"

namespace nmc {

class Requests;

/// A button beside that of a test that begins where the servo is held: it makes that position known. Shown
/// only while nothing else is missing.
class HoldFirstButton : public QPushButton {
    Q_OBJECT

public:
    HoldFirstButton(const QString& objectName, Requests& requests, QWidget* parent);

    /// `refusal`: why the test of this module is refused, if it is. Emits nothing.
    void showFor(const std::optional<ModuleState>& module, std::optional<Refusal> refusal);

private:
    std::optional<ModuleIndex> m_module;
};

}  // namespace nmc
