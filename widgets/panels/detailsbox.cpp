// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/detailsbox.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/common/glyphs.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString statusMeaning(int bit) {
    const std::array<QString, 8> meanings{
        DetailsBox::tr("The move has ended; in velocity mode the goal velocity is reached."),
        DetailsBox::tr("The module could not read the last command; it was not carried out."),
        DetailsBox::tr("The current limit was reached. Stays until sticky bits are cleared."),
        DetailsBox::tr("Motor power is present."),
        DetailsBox::tr("The position error was beyond its limit, or the servo is off. Stays until sticky "
                       "bits are cleared."),
        DetailsBox::tr("Limit input 1."),
        DetailsBox::tr("Limit input 2."),
        DetailsBox::tr("Waiting for the home position.")};
    return meanings[static_cast<std::size_t>(bit)];
}

QString auxMeaning(int bit) {
    const std::array<QString, 8> meanings{
        DetailsBox::tr("The complement of the encoder's index."),
        DetailsBox::tr("The 32-bit position has wrapped. Stays until sticky bits are cleared."),
        DetailsBox::tr("The servo is on."),
        DetailsBox::tr("The first acceleration phase of the move has ended."),
        DetailsBox::tr("The constant phase of the move has ended."),
        DetailsBox::tr(
            "A servo tick took too long; typically not serious. Stays until sticky bits are cleared."),
        QString(),
        QString()};
    return meanings[static_cast<std::size_t>(bit)];
}

QString bitName(std::string_view name) {
    return QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}

}  // namespace

DetailsBox::DetailsBox(QWidget* parent)
    : QWidget(parent), m_clear(new QPushButton(icons::tinted(u"eraser"_s), tr("Clear stic&ky bits"), this)) {
    look::name(this, u"detailsBox"_s, tr("Details"));
    look::name(m_clear, u"clearStickyButton"_s, tr("Clear the sticky status bits"));
    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit / 3);
    addBits(grid, 0, tr("Status byte"), false);
    addBits(grid, 3, tr("Auxiliary byte"), true);
    int line = 9;
    grid->setRowMinimumHeight(line++, unit);
    m_analog = addValue(grid, line++, tr("A/D (motor current)"), u"analogLabel"_s);
    m_velocity = addValue(grid, line++, tr("Velocity, as the chip says"), u"chipVelocityLabel"_s);
    m_home = addValue(grid, line++, tr("Home position"), u"homeLabel"_s);
    m_raw = addValue(grid, line++, tr("Raw"), u"rawLabel"_s);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(unit);
    buttons->addWidget(m_clear);
    buttons->addStretch(1);
    grid->setRowMinimumHeight(line++, unit);
    grid->addLayout(buttons, line++, 0, 1, 6);
    grid->setRowStretch(line, 1);
    grid->setColumnStretch(2, 1);
    grid->setColumnStretch(5, 1);

    connect(m_clear, &QPushButton::clicked, this,
            [this] { emit intentRequested(intent::ClearStickyBits{}); });
}

void DetailsBox::addBits(QGridLayout* grid, int column, const QString& title, bool aux) {
    auto* heading = new QLabel(title, this);
    QFont bold = font();
    bold.setBold(true);
    heading->setFont(bold);
    grid->addWidget(heading, 0, column, 1, 3);
    const auto& names = aux ? servo::kAuxBitNames : servo::kStatusBitNames;
    for (int i = 0; i < 8; ++i) {
        const QString name = bitName(names[static_cast<std::size_t>(i)]);
        if (name.isEmpty())
            continue;
        Bit& bit = (aux ? m_aux : m_status)[static_cast<std::size_t>(i)];
        bit.glyph = new GlyphLabel(this);
        bit.glyph->showBit(std::nullopt);
        auto* label = new QLabel(name, this);
        bit.value = look::newMutedLabel(u"–"_s, this);
        bit.value->setObjectName(u"bit_"_s + name);
        const QString meaning = aux ? auxMeaning(i) : statusMeaning(i);
        for (QWidget* widget : {static_cast<QWidget*>(bit.glyph), static_cast<QWidget*>(label),
                                static_cast<QWidget*>(bit.value)})
            widget->setToolTip(meaning);
        grid->addWidget(bit.glyph, i + 1, column, Qt::AlignCenter);
        grid->addWidget(label, i + 1, column + 1);
        grid->addWidget(bit.value, i + 1, column + 2);
    }
}

QLabel* DetailsBox::addValue(QGridLayout* grid, int line, const QString& label, const QString& objectName) {
    grid->addWidget(new QLabel(label, this), line, 0, 1, 3);
    auto* value = new QLabel(u"–"_s, this);
    value->setObjectName(objectName);
    value->setFont(look::tabular(font()));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid->addWidget(value, line, 3, 1, 3);
    return value;
}

void DetailsBox::showBit(const Bit& bit, std::optional<bool> set) {
    if (bit.glyph == nullptr)
        return;
    bit.glyph->showBit(set);
    look::setText(bit.value, !set.has_value() ? u"–"_s : *set ? tr("on") : tr("off"));
}

void DetailsBox::showModule(const PanelView& view) {
    const ModuleState& module = view.module;
    const auto refusal = view.whyNot(Request::ClearStickyBits);
    m_clearReason = refusal ? texts::refusal(*refusal) : QString();
    const std::optional<StatusReport>& report = module.latest;
    const bool aux = report.has_value() && report->aux.has_value();
    for (unsigned i = 0; i < 8; ++i) {
        showBit(m_status[i],
                report.has_value() ? std::optional((unsigned{report->status} >> i & 1U) != 0) : std::nullopt);
        showBit(m_aux[i], aux ? std::optional((unsigned{*report->aux} >> i & 1U) != 0) : std::nullopt);
    }
    const QString dash = u"–"_s;
    const bool analog = report.has_value() && report->analog.has_value();
    look::setText(m_analog, analog ? tr("%1 (%2 of 255)")
                                         .arg(texts::analog(view.settings.analog, *report->analog))
                                         .arg(*report->analog)
                                   : dash);
    const bool velocity = report.has_value() && report->velocity.has_value();
    look::setText(m_velocity,
                  velocity ? texts::grouped(*report->velocity) + u' ' + texts::unitVelocity() : dash);
    const bool home = report.has_value() && report->home.has_value();
    look::setText(m_home, home ? texts::grouped(*report->home) + u' ' + texts::unitCounts() : dash);
    QString raw = dash;
    if (report.has_value()) {
        raw = tr("status %1").arg(report->status, 2, 16, QChar(u'0'));
        if (aux)
            raw += tr(", auxiliary %1").arg(*report->aux, 2, 16, QChar(u'0'));
    }
    look::setText(m_raw, raw);
    refresh();
}

void DetailsBox::setBusy(bool busy) {
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

void DetailsBox::refresh() {
    const QString waiting = m_busy ? tr("Waiting for the module's answer.") : QString();
    look::setPossible(m_clear, m_clearReason.isEmpty() ? waiting : m_clearReason,
                      tr("Clears overcurrent, pos_error, pos_wrap and servo_overrun. Starts nothing."));
}

}  // namespace nmc
