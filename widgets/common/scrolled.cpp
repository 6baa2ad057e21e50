// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/scrolled.h"

#include <QScrollArea>

#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

QScrollArea* scrolled(QWidget* content, const QString& objectName, const QString& accessibleName) {
    auto* scroll = new QScrollArea;
    look::name(scroll, objectName, accessibleName);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(content);
    return scroll;
}

QScrollArea* scrolled(QWidget* content) {
    return scrolled(content, content->objectName() + u"Scroll"_s, content->accessibleName());
}

}  // namespace nmc
