// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/cursorpanel.h"

#include <QToolButton>

#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/scope/cursortable.h"
#include "widgets/scope/spectrumdialog.h"
#include "widgets/scope/xydialog.h"

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
    auto* spectrum =
        newOpener<SpectrumDialog>(u"scopeSpectrumButton"_s, tr("Spectrum…"),
                                  tr("Shows at which frequencies a signal oscillates between the cursors."));
    auto* xy = newOpener<XyDialog>(u"scopeXyButton"_s, tr("XY view…"),
                                   tr("Shows one signal over another between the cursors."));
    auto* line = new FlowLayout(0);
    for (QToolButton* button : {m_fold, xy, spectrum})
        line->addWidget(button);
    form::fill(this, form::newColumn(this, {line, m_table}, 0));
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
    if (m_fold->text() != text) {
        m_fold->setText(text);
        m_fold->setAccessibleName(text.isEmpty() ? Common::tr("Cursor readings") : text);
    }
    bool upToDate = !m_fold->isChecked() || m_table->showReadings(strips, history);
    for (StretchDialog* dialog : m_dialogs)
        upToDate = (!dialog->isVisible() || dialog->showStretch(strips, history)) && upToDate;
    return upToDate;
}

template <typename Dialog>
QToolButton* CursorPanel::newOpener(const QString& objectName, const QString& text, const QString& meaning) {
    auto* button = new QToolButton(this);
    button->setText(text);
    button->setToolTip(meaning);
    button->setAutoRaise(true);
    look::name(button, objectName, text);
    connect(button, &QToolButton::clicked, this, [this] {
        auto* dialog = findChild<Dialog*>();
        if (dialog == nullptr) {
            m_dialogs.push_back(dialog = new Dialog(this));
            connect(dialog, &StretchDialog::frameWanted, this, &CursorPanel::frameWanted);
        }
        dialog->show();
        dialog->raise();
        emit frameWanted();
    });
    return button;
}

void CursorPanel::hideEvent(QHideEvent* event) {
    for (StretchDialog* dialog : m_dialogs)
        dialog->hide();
    QWidget::hideEvent(event);
}

}  // namespace nmc
