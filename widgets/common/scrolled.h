// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QScrollArea;
class QWidget;

namespace nmc {

/// What scrolls where there is less room than it needs, and covers nothing. Never takes the focus itself.
[[nodiscard]] QScrollArea* scrolled(QWidget* content, const QString& objectName,
                                    const QString& accessibleName);
/// Under the content's own name, with "Scroll" behind it.
[[nodiscard]] QScrollArea* scrolled(QWidget* content);

}  // namespace nmc
