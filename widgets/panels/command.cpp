// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/command.h"

#include "widgets/common/icons.h"
#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

Command::Command(const Spec& spec, QWidget* box, std::function<void()> act)
    : QAction(spec.text, box),
      m_sentence(spec.accessible.isEmpty() ? spec.text : spec.accessible),
      m_button(new QPushButton(spec.text, box)) {
    look::name(m_button, spec.name, m_sentence);
    if (!spec.icon.isEmpty())
        setIcon(icons::tinted(spec.icon));
    m_button->setIcon(icon());
    setShortcut(spec.key);
    setAutoRepeat(false);
    box->addAction(this);
    connect(this, &QAction::triggered, box, std::move(act));
    connect(m_button, &QPushButton::clicked, this, &QAction::trigger);
    connect(this, &QAction::changed, m_button, [this] {
        if (m_button->text() != text()) {
            m_button->setText(text());
            m_button->setAccessibleName(text().remove(u'&'));
        }
        m_button->setVisible(isVisible());
    });
}

QWidget* Command::box() const {
    return qobject_cast<QWidget*>(parent());
}

void Command::setPossible(const QString& reason, const QString& meaning) {
    m_reason = reason;
    setEnabled(reason.isEmpty());
    const QString key =
        shortcut().isEmpty() ? QString() : u" (%1)"_s.arg(shortcut().toString(QKeySequence::NativeText));
    QString tip = reason.isEmpty() ? meaning : reason;
    if (!key.isEmpty() && reason.isEmpty())
        tip.endsWith(u'.') || tip.endsWith(u'。') ? tip.insert(tip.size() - 1, key) : tip.append(key);
    look::setPossible(m_button, reason, meaning);
    if (m_button->toolTip() != tip)
        m_button->setToolTip(tip);
    setToolTip(tip);
}

}  // namespace nmc
