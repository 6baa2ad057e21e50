// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/cursorpanel.h"

#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/scope/cursortable.h"

namespace nmc {

using namespace Qt::StringLiterals;

CursorPanel::CursorPanel(QWidget* parent)
    : QWidget(parent), m_fold(new QToolButton(this)), m_table(new CursorTable(this)) {
    look::name(m_fold, u"scopeCursorFoldButton"_s, Common::tr("Cursor readings"));
    m_fold->setToolTip(tr("Shows or hides the cursor readings."));
    m_fold->setCheckable(true);
    m_fold->setAutoRaise(true);
    m_fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(m_fold, &QToolButton::clicked, this, &CursorPanel::unfoldRequested);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_fold);
    layout->addWidget(m_table);
    setBeside(false);
    setUnfolded(true);
}

void CursorPanel::setUnfolded(bool unfolded) {
    m_fold->setChecked(unfolded);
    m_fold->setArrowType(unfolded ? Qt::DownArrow : Qt::RightArrow);
    m_table->setVisible(unfolded);
}

void CursorPanel::setBeside(bool beside) {
    const QSizePolicy::Policy high = beside ? QSizePolicy::Expanding : QSizePolicy::Fixed;
    setSizePolicy(QSizePolicy::Preferred, high);
    m_table->setSizePolicy(QSizePolicy::Preferred, high);
}

bool CursorPanel::showReadings(const ScopeStrips& strips, const History& history) {
    const QString text = strips.cursors()
                             ? tr("Between the cursors: %1").arg(CursorTable::between(*strips.cursors()))
                             : QString();
    if (m_fold->text() != text)
        m_fold->setText(text);
    return !m_fold->isChecked() || m_table->showReadings(strips, history);
}

}  // namespace nmc
