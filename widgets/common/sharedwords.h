// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace nmc {

/// The words that stand in several places of the window and mean the same in all of them: they are translated
/// once. A word that needs another translation in one of its places stays in the context of its class.
class Common {
    Q_DECLARE_TR_FUNCTIONS(Common)
};

}  // namespace nmc
