// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopemoves.h"

#include "widgets/common/plots.h"
#include "widgets/scope/scopestrips.h"
#include "widgets/scope/scopewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr double kKeyPan = 0.1;  ///< share of the visible range

using Move = std::function<void(ScopeStrips&)>;

Move zoom(double factor) {
    return [factor](ScopeStrips& strips) {
        strips.time().zoom(factor, (strips.time().left() + strips.time().right()) / 2);
    };
}

Move pan(double share) {
    return [share](ScopeStrips& strips) { strips.time().pan(share * strips.time().width()); };
}

Move panValues(double share) {
    return [share](ScopeStrips& strips) { strips.panValues(share); };
}

Move zoomValues(double factor) {
    return [factor](ScopeStrips& strips) { strips.zoomValues(factor); };
}

}  // namespace

QList<QAction*> newScopeMoves(QObject* parent, const std::function<void(const Move&)>& carryOut) {
    QList<QAction*> actions;
    const auto add = [&](const QString& objectName, const QString& text, const QList<QKeySequence>& keys,
                         const Move& move) {
        auto* action = new QAction(text, parent);
        action->setObjectName(objectName);
        action->setToolTip(text);
        action->setShortcuts(keys);
        // Plain letters and arrow keys act on the plots only while these have the focus.
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        QObject::connect(action, &QAction::triggered, parent, [carryOut, move] { carryOut(move); });
        actions << action;
    };
    add(u"scopeZoomInAction"_s, ScopeTexts::tr("Zoom in"),
        {QKeySequence(Qt::Key_Plus), QKeySequence(Qt::Key_Equal)}, zoom(1 / kKeyZoom));
    add(u"scopeZoomOutAction"_s, ScopeTexts::tr("Zoom out"), {QKeySequence(Qt::Key_Minus)}, zoom(kKeyZoom));
    add(u"scopeBackAction"_s, ScopeTexts::tr("Earlier"), {QKeySequence(Qt::Key_Left)}, pan(-kKeyPan));
    add(u"scopeForwardAction"_s, ScopeTexts::tr("Later"), {QKeySequence(Qt::Key_Right)}, pan(kKeyPan));
    add(u"scopePresentAction"_s, ScopeTexts::tr("Go to live"), {QKeySequence(Qt::Key_End)},
        [](ScopeStrips& strips) { strips.time().roll(); });
    add(u"scopeUpAction"_s, ScopeTexts::tr("Values up"), {QKeySequence(Qt::Key_Up)}, panValues(kKeyPan));
    add(u"scopeDownAction"_s, ScopeTexts::tr("Values down"), {QKeySequence(Qt::Key_Down)},
        panValues(-kKeyPan));
    add(u"scopeValuesInAction"_s, ScopeTexts::tr("Zoom values in"), {QKeySequence(Qt::CTRL | Qt::Key_Plus)},
        zoomValues(1 / kKeyZoom));
    add(u"scopeValuesOutAction"_s, ScopeTexts::tr("Zoom values out"),
        {QKeySequence(Qt::CTRL | Qt::Key_Minus)}, zoomValues(kKeyZoom));
    add(u"scopeFitAction"_s, ScopeTexts::tr("Fit the values"), {QKeySequence(Qt::Key_A)},
        [](ScopeStrips& strips) { strips.fitValues(); });
    add(u"scopeEverythingAction"_s, ScopeTexts::tr("Show everything"), {QKeySequence(Qt::Key_Home)},
        [](ScopeStrips& strips) { emit strips.everythingWanted(); });
    return actions;
}

}  // namespace nmc
