// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/operatordialog.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>
#include <vector>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr qsizetype kShortestPin = 4;
}

OperatorDialog::OperatorDialog(QWidget* window) : QDialog(window) {
    look::name(this, u"operatorDialog"_s, Common::tr("Operator mode"));
    setWindowTitle(Common::tr("Operator mode"));
    setAttribute(Qt::WA_DeleteOnClose);
    const int unit = look::gridUnit(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit * 2, unit * 2, unit * 2, unit);
    layout->setSpacing(unit);
    m_problem = form::newParagraph(u"operatorProblem"_s, {}, this);
}

OperatorDialog::OperatorDialog(const OperatorRights& rights, QWidget* window) : OperatorDialog(window) {
    auto* text = new QLabel(
        tr("Select what the operator may do. STOP ALL, Esc, each motor's stops and Disconnect always work. Operator mode prevents mistakes; it is not a security feature: anyone with access to this computer's files can bypass it."),
        this);
    text->setWordWrap(true);
    layout()->addWidget(text);
    const struct {
        const char* name;
        QString text;
        bool OperatorRights::*right;
    } all[] = {
        {"operatorEnableBox", tr("&Enable motors, clear faults"), &OperatorRights::enable},
        {"operatorJogBox", tr("&Jog"), &OperatorRights::jog},
        {"operatorPointsBox", tr("&Points and sequences"), &OperatorRights::points},
        {"operatorMovesBox", tr("&Moves: go to, run, step"), &OperatorRights::moves},
        {"operatorHomingBox", tr("&Homing"), &OperatorRights::homing},
        {"operatorOutputsBox", tr("&Outputs"), &OperatorRights::outputs},
    };
    std::vector<std::pair<QCheckBox*, bool OperatorRights::*>> boxes;
    for (const auto& one : all) {
        auto* box = form::newCheck({QString::fromLatin1(one.name), one.text}, this);
        box->setChecked(rights.*one.right);
        layout()->addWidget(box);
        boxes.emplace_back(box, one.right);
    }
    m_pin = newPinField(u"operatorPinField"_s, tr("P&IN to leave operator mode, at least 4 characters"));
    const auto* again = newPinField(u"operatorPinAgainField"_s, tr("PIN &again"));
    addEnd(tr("E&nter operator mode"), u"operatorBeginButton"_s, [this, again, boxes] {
        const QString pin = m_pin->text();
        if (pin.size() < kShortestPin)
            return m_problem->setText(tr("The PIN is too short: use at least 4 characters."));
        if (pin != again->text())
            return m_problem->setText(tr("The two PINs differ. Type the same PIN twice."));
        OperatorRights chosen;
        for (const auto& [box, right] : boxes)
            chosen.*right = box->isChecked();
        emit locked(chosen, pin);
        accept();
    });
}

OperatorDialog::OperatorDialog(std::function<bool(const QString&)> isPin, const QString& forgotten,
                               QWidget* window)
    : OperatorDialog(window) {
    m_pin = newPinField(u"operatorPinField"_s, tr("P&IN"));
    addEnd(tr("&Leave operator mode"), u"operatorLeaveButton"_s, [this, isPin = std::move(isPin), forgotten] {
        if (!isPin(m_pin->text())) {
            m_problem->setText(tr("Wrong PIN. %1").arg(forgotten));
            return m_pin->selectAll();
        }
        emit unlocked();
        accept();
    });
}

QLineEdit* OperatorDialog::newPinField(const QString& name, const QString& label) {
    auto* field = form::newText({name, QString(label).remove(u'&'), 32}, this);
    field->setEchoMode(QLineEdit::Password);
    layout()->addWidget(form::newLabel(label, field));
    layout()->addWidget(field);
    return field;
}

void OperatorDialog::addEnd(const QString& goOn, const QString& goOnName, const std::function<void()>& act) {
    auto* go = form::newPush({goOnName, goOn}, this);
    go->setDefault(true);
    connect(go, &QPushButton::clicked, this, act);
    auto* cancel = form::newPush(
        {u"operatorCancelButton"_s, tr("&Cancel"), tr("Cancel: keep the mode unchanged")}, this);
    cancel->setAutoDefault(false);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    layout()->addWidget(m_problem);
    static_cast<QVBoxLayout*>(layout())->addLayout(form::newLine(this, {nullptr, go, cancel}));
    m_pin->setFocus();
}

}  // namespace nmc
