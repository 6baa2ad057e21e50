// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/accessibility.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QWidget>

namespace nmc::accessibility {

namespace {

constexpr const char* kBusy = "accessibleBusy";

class Panel : public QAccessibleWidget {
public:
    explicit Panel(QWidget* widget) : QAccessibleWidget(widget, QAccessible::Grouping) {}

    [[nodiscard]] QAccessible::State state() const override {
        QAccessible::State state = QAccessibleWidget::state();
        state.busy = object()->property(kBusy).toBool();
        return state;
    }
};

QAccessibleInterface* interfaceOf(const QString& className, QObject* object) {
    if (className == QLatin1String("nmc::Banner"))
        return new QAccessibleWidget(static_cast<QWidget*>(object), QAccessible::AlertMessage);
    if (className == QLatin1String("nmc::ModulePanel") || className == QLatin1String("nmc::FirstSteps"))
        return new Panel(static_cast<QWidget*>(object));
    // Replaces Qt 6.4's own interface, which reads beyond its list and crashes the program when it is asked
    // for a child that has just gone, such as a scroll bar. This one has no such children.
    if (className == QLatin1String("QScrollArea"))
        return new QAccessibleWidget(static_cast<QWidget*>(object));
    return nullptr;
}

}  // namespace

void setUp() {
    QAccessible::installFactory(interfaceOf);
}

void announce(QWidget& region, const QString& words) {
    if (region.accessibleName() != words)
        region.setAccessibleName(words);
    QAccessibleEvent alert(&region, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void setBusy(QWidget& panel, bool busy) {
    if (panel.property(kBusy).toBool() == busy)
        return;
    panel.setProperty(kBusy, busy);
    QAccessible::State changed;
    changed.busy = true;
    QAccessibleStateChangeEvent event(&panel, changed);
    QAccessible::updateAccessibility(&event);
}

}  // namespace nmc::accessibility
