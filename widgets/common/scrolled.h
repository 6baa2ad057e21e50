// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QScrollArea;
class QWidget;

namespace nmc {

/// Makes a scroll area for content that may need more room than there is. It never takes the focus itself.
[[nodiscard]] QScrollArea* scrolled(QWidget* content, const QString& objectName,
                                    const QString& accessibleName);
/// Named after the content, with "Scroll" appended to the object name.
[[nodiscard]] QScrollArea* scrolled(QWidget* content);

}  // namespace nmc
