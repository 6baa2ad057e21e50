// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/cursorpanel.h"

#include <QToolButton>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/scope/cursortable.h"
#include "widgets/scope/spectrumdialog.h"

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
    auto* spectrum = new QToolButton(this);
    spectrum->setText(tr("Spectrum…"));
    spectrum->setToolTip(tr("Shows at which frequencies a signal oscillates between the cursors."));
    spectrum->setAutoRaise(true);
    look::name(spectrum, u"scopeSpectrumButton"_s, spectrum->text());
    connect(spectrum, &QToolButton::clicked, this, &CursorPanel::openSpectrum);
    form::fill(this, form::newColumn(this, {form::newLine(this, {m_fold, nullptr, spectrum}), m_table}, 0));
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
    const bool table = !m_fold->isChecked() || m_table->showReadings(strips, history);
    const bool spectrum =
        m_spectrum == nullptr || !m_spectrum->isVisible() || m_spectrum->showSpectrum(strips, history);
    return table && spectrum;
}

void CursorPanel::openSpectrum() {
    if (m_spectrum == nullptr) {
        m_spectrum = new SpectrumDialog(this);
        connect(m_spectrum, &SpectrumDialog::frameWanted, this, &CursorPanel::frameWanted);
    }
    m_spectrum->show();
    m_spectrum->raise();
    emit frameWanted();
}

void CursorPanel::hideEvent(QHideEvent* event) {
    if (m_spectrum != nullptr)
        m_spectrum->hide();
    QWidget::hideEvent(event);
}

}  // namespace nmc
