// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/lenddialog.h"

#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "model/intent/intent.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

LendDialog::LendDialog(Requests& requests, QWidget* window)
    : QDialog(window),
      m_path(form::newText({u"lendPathField"_s, tr("Path of the terminal"), 4'096}, this)),
      m_lend(form::newPush({u"lendButton"_s, tr("&Lend the line")}, this)) {
    look::name(this, u"lendDialog"_s, tr("Lend the line to a program"));
    setWindowTitle(tr("Lend the line to a program"));
    auto* text = form::newParagraph(u"lendText"_s, {}, this);
    text->setText(tr(
        "The program opens this path in place of the serial port, and has the modules for itself. The panel shows and records what they report, and sends nothing: your travel limits, stops at limits and other checks do not protect the motors. STOP ALL works, and holds the program off."));
    m_path->setText(QDir::home().filePath(u"nmc-line"_s));
    auto* cancel = form::newPush({u"lendCancelButton"_s, tr("&Cancel")}, this);
    cancel->setAutoDefault(false);
    form::fill(this,
               form::newColumn(this, {text, form::newLabel(tr("&Path of the terminal"), m_path), m_path,
                                      form::newLine(this, {nullptr, m_lend, cancel})}),
               2);
    m_lend->setDefault(true);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_path, &QLineEdit::textChanged, this, &LendDialog::showProblem);
    connect(m_lend, &QPushButton::clicked, this, [this, &requests] {
        emit requests.lend(m_path->text().trimmed());
        accept();
    });
}

void LendDialog::showLink(const LinkState& link) {
    auto refusal = whyNoChain(link);
    if (!refusal)
        refusal = whyInaccessible(link);
    m_problem = refusal                        ? texts::refusal(*refusal)
                : !movingModules(link).empty() ? tr("A motor is moving. Stop it first.")
                                               : QString();
    showProblem();
}

void LendDialog::showProblem() {
    const bool lacksPath = m_problem.isEmpty() && m_path->text().trimmed().isEmpty();
    look::setPossible(m_lend, lacksPath ? tr("Enter a path.") : m_problem,
                      tr("Creates the terminal. Nothing moves."));
}

}  // namespace nmc
