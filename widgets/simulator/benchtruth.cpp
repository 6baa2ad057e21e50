// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/simulator/benchtruth.h"

#include <QGridLayout>
#include <QJsonArray>
#include <QLabel>
#include <cmath>

#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// Maximum number of violations in the tool tip, the latest last.
constexpr qsizetype kListedViolations = 8;
}  // namespace

BenchTruth::BenchTruth(QWidget* parent)
    : QWidget(parent), m_violationsSign(new GlyphLabel(this)), m_violations(new QLabel(u"–"_s, this)) {
    look::name(this, u"simTruth"_s, tr("Simulator values of the module"));
    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit, 0, unit, 0);
    grid->setHorizontalSpacing(unit / 2);
    grid->setVerticalSpacing(unit / 4);
    grid->setColumnStretch(0, 1);
    const QString counts = texts::unitCounts();
    addRow(*grid, u"shaft"_s, tr("Shaft"), counts, 7,
           tr("The true position of the shaft since the simulation started."));
    addRow(*grid, u"position"_s, tr("Position counter"), counts, 0,
           tr("The position as the module counts it."));
    addRow(*grid, u"position_error"_s, Common::tr("Position error"), counts, 4, tr("True, not calculated."));
    addRow(*grid, u"velocity"_s, Common::tr("Speed"), texts::unitVelocity(), 3, tr("Of the shaft."));
    addRow(*grid, u"step_rate"_s, tr("Step rate"), Common::tr("steps/s"), 4, tr("Negative in reverse."));
    addRow(*grid, u"pwm"_s, Common::tr("PWM"), Common::tr("of 255"), 0, tr("The sign is the direction."));
    addRow(*grid, u"current"_s, Common::tr("Motor current"), Common::tr("A"), 3, {});
    addRow(*grid, u"current_limit"_s, Common::tr("Motor current"), Common::tr("of 255"), 0,
           tr("255 is full current."));
    addRow(*grid, u"analog"_s, tr("A/D reads"), Common::tr("of 255"), 0, {});

    const int line = grid->rowCount();
    auto* label = new QLabel(tr("Violations"), this);
    label->setToolTip(tr("Protocol violations that would upset a real module."));
    m_violations->setObjectName(u"simViolations"_s);
    m_violations->setAlignment(Qt::AlignRight);
    m_violations->setFont(look::tabular(font()));
    grid->addWidget(label, line, 0);
    grid->addWidget(m_violations, line, 1);
    grid->addWidget(m_violationsSign, line, 2, Qt::AlignLeft | Qt::AlignVCenter);
}

void BenchTruth::addRow(QGridLayout& grid, const QString& key, const QString& label, const QString& unit,
                        int significant, const QString& meaning) {
    const int line = grid.rowCount();
    const Row row{new QLabel(label, this), new QLabel(u"–"_s, this), look::newMutedLabel(unit, this),
                  significant};
    row.label->setToolTip(meaning);
    row.value->setObjectName(u"simTruth_"_s + key);
    row.value->setAlignment(Qt::AlignRight);
    row.value->setFont(look::tabular(font()));
    grid.addWidget(row.label, line, 0);
    grid.addWidget(row.value, line, 1);
    grid.addWidget(row.unit, line, 2);
    m_rows.insert(key, row);
}

void BenchTruth::showState(const QJsonObject& state) {
    const bool step = state["type"_L1].toString() == "step"_L1;
    for (const QString& key : {u"shaft"_s, u"position"_s})
        look::setText(m_rows[key].unit, step ? texts::unitSteps() : texts::unitCounts());
    for (auto row = m_rows.cbegin(); row != m_rows.cend(); ++row) {
        const bool known = state[row.key()].isDouble();  // a PIC-I/O has several of some: see its bench
        for (QWidget* part : {row->label, row->value, row->unit})
            part->setVisible(known);
        const double value = state[row.key()].toDouble();
        look::setText(row->value, row->significant == 0 ? texts::grouped(std::llround(value))
                                                        : texts::readout(value, row->significant));
    }
}

void BenchTruth::showStatistics(const QJsonObject& statistics) {
    const qint64 count = statistics["violation_count"_L1].toInteger();
    look::setText(m_violations, texts::grouped(count));
    m_violationsSign->showSeverity(count > 0 ? Severity::Attention : Severity::Normal);
    m_violationsSign->setVisible(count > 0);
    const QJsonArray entries = statistics["violations"_L1].toArray();
    QStringList lines{tr("Protocol violations that would upset a real module.")};
    for (qsizetype i = std::max<qsizetype>(0, entries.size() - kListedViolations); i < entries.size(); ++i) {
        const QJsonObject entry = entries[i].toObject();
        lines << tr("%1 s, module %2: %3, %4")
                     .arg(texts::readout(entry["time"_L1].toDouble(), 6))
                     .arg(entry["module"_L1].toInt())
                     .arg(entry["kind"_L1].toString(), entry["bytes"_L1].toString());
    }
    m_violations->setToolTip(lines.join(u'\n'));
    m_violations->setAccessibleDescription(m_violations->toolTip());
}

void BenchTruth::forget() {
    for (const Row& row : std::as_const(m_rows))
        look::setText(row.value, u"–"_s);
    look::setText(m_violations, u"–"_s);
    m_violationsSign->hide();
}

}  // namespace nmc
