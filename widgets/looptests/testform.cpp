// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/looptests/testform.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/common/form.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/response/holdfirstbutton.h"

namespace nmc {

using namespace Qt::StringLiterals;

TestForm::TestForm(ProcedureKind kind, const Words& words, Requests& requests, QWidget* parent)
    : QWidget(parent), m_requests(requests), m_kind(kind), m_meaning(words.meaning) {
    look::name(this, words.objectName + u"Form"_s, words.start);
    m_start = new QPushButton(icons::tinted(u"player-play"_s), words.start, this);
    look::name(m_start, words.objectName + u"StartButton"_s, words.start);
    m_end = form::newPush({words.objectName + u"EndButton"_s, tr("End test")}, this);
    m_state = form::newRemark({}, this);
    look::nameText(m_state, words.objectName + u"State"_s, tr("Progress of the test"));
    m_state->setMinimumHeight(3 * fontMetrics().height());
    m_state->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_hold = new HoldFirstButton(words.objectName + u"HoldButton"_s, m_requests, this);
    m_grid = new QGridLayout;
    m_grid->setHorizontalSpacing(look::gridUnit(this));
    m_grid->setVerticalSpacing(look::gridUnit(this) / 3);
    m_grid->setColumnStretch(3, 1);
    auto* buttons = form::newLine(this, {m_start, m_end, m_hold, nullptr});
    form::fill(this, form::newColumn(this, {m_grid, buttons, m_state}, 0.5));
    connect(m_start, &QPushButton::clicked, this, &TestForm::start);
    connect(m_end, &QPushButton::clicked, this, [this] {
        if (m_module)
            emit m_requests.intent(m_module->info.index, intent::CancelProcedure{});
    });
}

void TestForm::addRow(const QString& label, QWidget* field, QWidget* unit) {
    const int row = m_grid->rowCount();
    m_grid->addWidget(form::newLabel(label, field), row, 0);
    m_grid->addWidget(field, row, 1, 1, unit != nullptr ? 1 : 3);
    if (unit != nullptr)
        m_grid->addWidget(unit, row, 2);
}

NumberField* TestForm::addNumber(const QString& objectName, const QString& label, const QString& name,
                                 const QString& unit, int decimals) {
    auto* field = form::newNumber(
        {.name = objectName, .accessible = name, .unit = unit, .decimals = decimals, .digits = 6}, this);
    addRow(label, field, unit.isEmpty() ? nullptr : new QLabel(unit, this));
    m_fields.push_back(field);
    connect(field, &NumberField::edited, this, &TestForm::refresh);
    return field;
}

QuantityField* TestForm::addQuantity(QuantityField::Kind kind, const QString& objectName,
                                     const QString& label, const QString& name) {
    auto* field =
        form::newQuantity({.kind = kind, .name = objectName, .accessible = name, .digits = 6}, this);
    field->otherView()->hide();
    addRow(label, field, field->unitLabel());
    m_fields.push_back(field);
    connect(field, &QuantityField::nativeEdited, this, &TestForm::refresh);
    return field;
}

void TestForm::showModule(const PanelView& view) {
    m_module = view.module;
    m_connected = view.connected;
    m_report.reset();
    if (view.procedure != nullptr && view.procedure->kind == m_kind)
        m_report = *view.procedure;
    for (NumberField* field : m_fields)
        if (auto* distance = qobject_cast<QuantityField*>(field))
            distance->setScale(view.scale());
    refresh();
}

void TestForm::showNothing() {
    m_module.reset();
    m_report.reset();
    m_connected = false;
    refresh();
}

QString TestForm::whyNotNow() const {
    if (!m_connected || !m_module)
        return texts::refusal(Refusal::NotConnected);
    if (running())
        return tr("The test is already running.");
    for (const NumberField* field : m_fields)
        if (const QString problem = field->problemText(); !problem.isEmpty())
            return problem;
    const auto refusal = this->refusal();
    return refusal ? texts::refusal(*refusal) : QString();
}

std::optional<Refusal> TestForm::refusal() const {
    for (const NumberField* field : m_fields)
        if (field->problem() != NumberField::Problem::None)
            return std::nullopt;
    if (!m_module || running())
        return std::nullopt;
    const auto steps = plan(m_wanted(), *m_module);
    if (steps)
        return std::nullopt;
    return steps.error();
}

void TestForm::refresh() {
    const QString reason = whyNotNow();
    look::setPossible(m_start, reason, m_meaning);
    look::setPossible(m_end, running() ? QString() : tr("The test is not running."),
                      Common::tr("The motor holds its position."));
    m_hold->showFor(m_module, m_connected ? refusal() : std::nullopt);
    const bool failed = reason.isEmpty() && m_report && m_report->failure;
    look::setText(m_state, running() ? texts::procedureStage(*m_report)
                           : failed  ? texts::loopTestFailure(*m_report->failure)
                                     : reason);
}

void TestForm::start() {
    if (whyNotNow().isEmpty())
        emit m_requests.intent(m_module->info.index, m_wanted());
}

}  // namespace nmc
