// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/statustable.h"

#include <QGridLayout>
#include <QLabel>

#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/homewords.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kFirstValue = 2;
}  // namespace

StatusTable::StatusTable(ModuleContext& context, QWidget* parent)
    : QWidget(parent), m_context(context), m_grid(new FoldingGrid(this)), m_line(kFirstValue) {
    const int unit = look::gridUnit(this);
    m_grid->setContentsMargins(unit, unit, unit, unit);
    m_grid->setHorizontalSpacing(unit * 3 / 2);
    m_grid->setVerticalSpacing(unit / 3);
    m_grid->setRowMinimumHeight(kFirstValue - 1, unit);
    m_grid->setColumnStretch(1, 1);
    auto* bytes = new FlowLayout(unit * 4);
    for (QGridLayout*& bits : m_bitGrids) {
        bits = new QGridLayout;
        bits->setHorizontalSpacing(unit * 2 / 3);
        bits->setVerticalSpacing(unit / 3);
        bytes->addLayout(bits);
    }
    m_grid->addLayout(bytes, 0, 0, 1, 2);
}

void StatusTable::addBits(Byte byte, const QString& title, const BitNames& names, Meaning meaning) {
    QGridLayout* grid = m_bitGrids[static_cast<std::size_t>(byte)];
    grid->addWidget(form::newHeading(title, this), 0, 0, 1, 3);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].empty())
            continue;
        const QString name = QString::fromLatin1(names[i].data(), static_cast<qsizetype>(names[i].size()));
        Bit& bit = m_bits[static_cast<std::size_t>(byte)][i];
        bit.glyph = new GlyphLabel(this);
        bit.glyph->showBit(std::nullopt);
        auto* label = new QLabel(name, this);
        bit.value =
            look::newMutedLabel(u"–"_s, this, m_context.named(u"bit_"_s) + QString(name).replace(u' ', u'_'));
        for (QWidget* widget : {static_cast<QWidget*>(bit.glyph), static_cast<QWidget*>(label),
                                static_cast<QWidget*>(bit.value)})
            widget->setToolTip(meaning(i));
        const int line = static_cast<int>(i) + 1;
        grid->addWidget(bit.glyph, line, 0, Qt::AlignCenter);
        grid->addWidget(label, line, 1);
        grid->addWidget(bit.value, line, 2);
    }
}

QLabel* StatusTable::addValue(const QString& label, const QString& objectName) {
    m_grid->addWidget(new QLabel(label, this), m_line, 0);
    auto* value = new QLabel(u"–"_s, this);
    value->setObjectName(m_context.named(objectName));
    value->setFont(look::tabular(font()));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_grid->addWidget(value, m_line++, 1);
    return value;
}

void StatusTable::addAnalog(const QString& label) {
    m_analog = addValue(label, u"analogLabel"_s);
}

void StatusTable::addEnd(const Command& first) {
    m_home = addValue(Common::tr("Home register"), u"homeLabel"_s);
    m_home->setToolTip(texts::homeRegisterMeaning());
    m_raw = addValue(Common::tr("Raw"), u"rawLabel"_s);
    m_saveHome = new Command({.name = m_context.named(u"saveHomeButton"_s),
                              .icon = u"home"_s,
                              .text = Common::tr("Save as home"),
                              .accessible = Common::tr("Save as home: the present position")},
                             this, [this] { m_context.ask(intent::SaveAsHome{}); });
    const int unit = look::gridUnit(this);
    m_grid->setRowMinimumHeight(m_line++, unit);
    m_grid->addLayout(new FlowLayout(unit, {first.button(), m_saveHome->button()}), m_line++, 0, 1, 2);
    m_grid->setRowStretch(m_line, 1);
}

void StatusTable::showStatus(const QString& aux) {
    const QString dash = u"–"_s;
    const std::optional<StatusReport>& latest = m_context.state().latest;
    const StatusReport report = latest.value_or(StatusReport{});
    showBits(Byte::First, latest ? std::optional(report.status) : std::nullopt);
    showBits(Byte::Second, report.aux);
    look::setText(m_analog, texts::analogReading(m_context.settings().analog, report.analog));
    look::setText(m_home, report.home ? texts::position(m_context.scale(), *report.home) : dash);
    QString raw = latest ? Common::tr("status %1").arg(report.status, 2, 16, QChar(u'0')) : dash;
    if (report.aux)
        raw += aux.arg(*report.aux, 2, 16, QChar(u'0'));
    look::setText(m_raw, raw);
    m_saveHome->setPossible(m_context.reasonNow(IntentKind::SaveAsHome),
                            Common::tr("Saves the present position as home. The motor does not move."));
}

void StatusTable::showBits(Byte byte, std::optional<std::uint8_t> value) {
    const auto& bits = m_bits[static_cast<std::size_t>(byte)];
    for (std::size_t i = 0; i < bits.size(); ++i) {
        if (bits[i].glyph == nullptr)
            continue;
        const auto set = value ? std::optional((unsigned{*value} >> i & 1U) != 0) : std::nullopt;
        bits[i].glyph->showBit(set);
        look::setText(bits[i].value, !set ? u"–"_s : *set ? Common::tr("on") : Common::tr("off"));
    }
}

}  // namespace nmc
