// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/layouts.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QSettings>

#include "widgets/mainwindow/settingskeys.h"

namespace nmc {

using namespace Qt::StringLiterals;
using namespace settingskeys;

namespace {
/// The first layout has the key that existed before the others were added.
QString settingsKeyOf(Layouts::Kind kind) {
    switch (kind) {
        case Layouts::Kind::Operate:
            break;
        case Layouts::Kind::Tune:
            return kState + u"/tune"_s;
        case Layouts::Kind::Chain:
            return kState + u"/chain"_s;
    }
    return kState;
}
}  // namespace

Layouts::Layouts(QMainWindow& window, QSettings& settings, std::function<void(Kind)> arrange)
    : QObject(&window), m_window(window), m_settings(settings), m_arrange(std::move(arrange)) {
    auto* group = new QActionGroup(this);
    add(u"operateLayoutAction"_s, tr("&Operate"), tr("Motion in the middle, everything else around it."),
        Qt::CTRL | Qt::Key_1);
    add(u"tuneLayoutAction"_s, tr("&Tune"), tr("Large plots, with gains and step response beside them."),
        Qt::CTRL | Qt::Key_2);
    add(u"chainLayoutAction"_s, tr("&Chain"), tr("Modules, packets and messages."), Qt::CTRL | Qt::Key_3);
    for (QAction* action : m_actions)
        group->addAction(action);
}

void Layouts::add(const QString& objectName, const QString& text, const QString& meaning,
                  const QKeySequence& key) {
    const Kind kind = static_cast<Kind>(m_actions.size());
    auto* action = new QAction(text, this);
    action->setObjectName(objectName);
    action->setToolTip(meaning);
    action->setCheckable(true);
    action->setShortcut(key);
    connect(action, &QAction::triggered, this, [this, kind] { choose(kind); });
    m_actions.append(action);
}

void Layouts::restore() {
    const int kept = m_settings.value(kLayout).toInt();
    m_kind = static_cast<Kind>(qBound(0, kept, static_cast<int>(m_actions.size()) - 1));
    show();
}

void Layouts::show() {
    m_actions[static_cast<int>(m_kind)]->setChecked(true);
    if (!m_window.restoreState(m_settings.value(settingsKeyOf(m_kind)).toByteArray()))
        m_arrange(m_kind);
    emit chosen(m_kind);
}

void Layouts::save() {
    m_settings.setValue(settingsKeyOf(m_kind), m_window.saveState());
    m_settings.setValue(kLayout, static_cast<int>(m_kind));
}

void Layouts::choose(Kind kind) {
    if (kind == m_kind)
        return;
    save();
    m_kind = kind;
    show();
}

void Layouts::reset() {
    m_arrange(m_kind);
    emit chosen(m_kind);
}

}  // namespace nmc
