// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/tracesdialog.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/scope/scopewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr int kNameWidth = 12;    // in grid units
constexpr int kSignalWidth = 24;  // in characters

/// The signals of which a trace can be made; the value of each option is the signal as text.
QList<form::Option> optionsOf(const QString& module, std::optional<ModuleIndex> index,
                              const ScopeModule* of) {
    QList<form::Option> options;
    for (const SignalInfo& info : kSignals)
        if (!customIndex(info.signal) && (of == nullptr || of->reports(info.signal)))
            options.append(
                {Common::tr("%1: %2").arg(module, of != nullptr ? texts::signalName(info.signal, *of)
                                                                : texts::signalName(info.signal)),
                 SignalRef{index, info.signal}.toText()});
    return options;
}

}  // namespace

TracesDialog::TracesDialog(const TraceDefinitions& traces, const std::vector<ScopeModule>& modules,
                           QWidget* parent)
    : QDialog(parent) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Custom traces"));
    look::name(this, u"customTracesDialog"_s, windowTitle());
    QLabel* about = form::newParagraph(u"customTracesAbout"_s, {}, this, 1);
    look::setText(
        about,
        tr("Each trace is the sum of one or two signals, each times a factor. Values are taken in the units in which the signals are shown; a negative factor subtracts."));
    auto* table = new QWidget(this);
    auto* grid = new FormGrid(table, 7, {.sides = 0});
    grid->addLine({form::newHeading(Common::tr("Name"), this), form::newHeading(Common::tr("Signal"), this),
                   form::newHeading(tr("Factor"), this), form::newHeading(tr("Second signal"), this),
                   form::newHeading(tr("Factor"), this), form::newHeading(tr("Low-pass, Hz"), this),
                   form::newHeading(Common::tr("Unit"), this)});
    QList<form::Option> options = optionsOf(tr("Selected module"), std::nullopt, nullptr);
    for (std::size_t i = 0; i < modules.size(); ++i)
        options += optionsOf(modules[i].name, ModuleIndex(static_cast<std::uint8_t>(i)), &modules[i]);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i] = newRow(i, options);
        const Row& row = m_rows[i];
        grid->addLine({row.name, row.first.signal, row.first.factor, row.second.signal, row.second.factor,
                       row.cutoff, row.unit});
    }
    m_problem = form::newParagraph(u"customTracesProblem"_s, {}, this, 1);
    auto* cancel = form::newPush({u"customTracesCancelButton"_s, Common::tr("Cancel")}, this);
    m_apply = form::newPush({u"customTracesApplyButton"_s, tr("&Apply"), tr("Apply")}, this);
    cancel->setAutoDefault(false);
    m_apply->setDefault(true);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_apply, &QPushButton::clicked, this, &QDialog::accept);
    connect(this, &QDialog::accepted, this, [this] {
        TraceDefinitions chosen;
        for (std::size_t i = 0; i < m_rows.size(); ++i)
            chosen[i] = traceOf(m_rows[i]);
        emit tracesChosen(chosen);
    });
    form::fill(
        this,
        form::newColumn(this, {about, table, m_problem, form::newLine(this, {nullptr, cancel, m_apply})}), 1);
    // Only now: what changes in a row is judged together with all other rows.
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        fill(m_rows[i], traces[i].value_or(TraceDefinition{}));
    refresh();
    m_rows.front().name->setFocus();
}

TracesDialog::Row TracesDialog::newRow(std::size_t index, const QList<form::Option>& options) {
    const auto objectName = [&](const QString& field) {
        return u"customTrace%1%2"_s.arg(QString::number(index + 1), field);
    };
    const auto of = [&](const QString& what) { return tr("%1, trace %2").arg(what).arg(index + 1); };
    Row row{};
    row.name = form::newText({objectName(u"Name"_s), of(Common::tr("Name")), TraceDefinition::kLongestName,
                              tr("The name in the legend. Without one, there is no such trace.")},
                             this);
    row.name->setMinimumWidth(look::gridUnit(this) * kNameWidth);
    row.first = newPart(objectName(u"First"_s), of(Common::tr("Signal")), options);
    row.second = newPart(objectName(u"Second"_s), of(tr("Second signal")),
                         QList<form::Option>{{tr("none"), QString()}} + options);
    row.cutoff = form::newNumber(
        {.name = objectName(u"Cutoff"_s),
         .accessible = of(tr("Low-pass, Hz")),
         .unit = u"Hz"_s,
         .min = 0,
         .max = TraceDefinition::kMostCutoff,
         .decimals = 3,
         .digits = 7,
         .meaning = tr(
             "Smooths the trace: what is faster than this frequency is attenuated, and the trace lags behind. Empty: no filter."),
         .unknown = tr("off")},
        this);
    row.unit = form::newText({objectName(u"Unit"_s), of(Common::tr("Unit")), TraceDefinition::kLongestUnit,
                              tr("Shown beside the name.")},
                             this);
    for (QLineEdit* field :
         std::initializer_list<QLineEdit*>{row.name, row.first.factor, row.second.factor, row.cutoff})
        connect(field, &QLineEdit::textChanged, this, &TracesDialog::refresh);
    connect(row.second.signal, &QComboBox::currentIndexChanged, this, &TracesDialog::refresh);
    return row;
}

TracesDialog::Part TracesDialog::newPart(const QString& objectName, const QString& accessible,
                                         const QList<form::Option>& options) {
    Part part{};
    part.signal = form::newChoice({objectName + u"Signal"_s, accessible, options}, this);
    part.signal->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    part.signal->setMinimumContentsLength(kSignalWidth);
    part.factor = form::newNumber({.name = objectName + u"Factor"_s,
                                   .accessible = tr("Factor of: %1").arg(accessible),
                                   .min = -TraceDefinition::kMostFactor,
                                   .max = TraceDefinition::kMostFactor,
                                   .decimals = 9,
                                   .digits = 9,
                                   .meaning = tr("The signal is multiplied by it.")},
                                  this);
    return part;
}

void TracesDialog::fill(const Row& row, const TraceDefinition& trace) {
    row.name->setText(trace.name);
    row.unit->setText(trace.unit);
    if (trace.cutoff > 0)
        row.cutoff->showValue(trace.cutoff);
    const auto show = [](const Part& part, const std::optional<TraceDefinition::Part>& of) {
        const QString signal = of ? of->signal.toText() : QString();
        // Its module may not be there now; another signal in its place would be taken when the user applies.
        if (of && of->signal.module && part.signal->findData(signal) < 0)
            part.signal->addItem(Common::tr("%1: %2").arg(texts::moduleName(*of->signal.module),
                                                          texts::signalName(of->signal.signal)),
                                 signal);
        part.signal->setCurrentIndex(std::max(0, part.signal->findData(signal)));
        part.factor->showValue(of ? of->factor : 1);
    };
    show(row.first, trace.first);
    show(row.second, trace.second);
}

QString TracesDialog::problemOf(const Row& row) {
    if (row.name->text().trimmed().isEmpty())
        return {};
    const auto ofFactor = [](const Part& part) {
        const auto value = part.factor->value();
        return !value                                             ? part.factor->problemText()
               : std::abs(*value) < TraceDefinition::kLeastFactor ? tr("A factor must not be 0.")
                                                                  : QString();
    };
    if (const QString problem = ofFactor(row.first); !problem.isEmpty())
        return problem;
    if (row.second.signal->currentIndex() > 0)
        if (const QString problem = ofFactor(row.second); !problem.isEmpty())
            return problem;
    return row.cutoff->value() || row.cutoff->problem() == NumberField::Problem::Empty
               ? QString()
               : row.cutoff->problemText();
}

std::optional<TraceDefinition> TracesDialog::traceOf(const Row& row) {
    const auto partOf = [](const Part& part) -> std::optional<TraceDefinition::Part> {
        const auto signal = SignalRef::fromText(part.signal->currentData().toString());
        return signal ? std::optional(TraceDefinition::Part{*signal, part.factor->value().value_or(1)})
                      : std::nullopt;
    };
    const auto first = partOf(row.first);
    const QString name = row.name->text().simplified();
    if (name.isEmpty() || !first)
        return std::nullopt;
    return TraceDefinition{name, row.unit->text().simplified(), *first, partOf(row.second),
                           row.cutoff->value().value_or(0)};
}

/// A row is filled in from its name on.
void TracesDialog::refresh() {
    QString problem;
    for (const Row& row : m_rows) {
        const bool named = !row.name->text().trimmed().isEmpty();
        for (QWidget* field : std::initializer_list<QWidget*>{row.first.signal, row.first.factor,
                                                              row.second.signal, row.cutoff, row.unit})
            field->setEnabled(named);
        row.second.factor->setEnabled(named && row.second.signal->currentIndex() > 0);
        if (problem.isEmpty())
            problem = problemOf(row);
    }
    look::setText(m_problem, problem);
    m_apply->setEnabled(problem.isEmpty());
}

}  // namespace nmc
