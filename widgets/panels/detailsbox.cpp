// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/detailsbox.h"

#include <QLabel>
#include <QPushButton>

#include "widgets/common/homewords.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString statusMeaning(std::size_t bit) {
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
    return meanings[bit];
}

QString auxMeaning(std::size_t bit) {
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
    return meanings[bit];
}

}  // namespace

DetailsBox::DetailsBox(QWidget* parent)
    : StatusTable(parent),
      m_clear(new QPushButton(icons::tinted(u"eraser"_s), tr("Clear stic&ky bits"), this)),
      m_saveHome(new QPushButton(icons::tinted(u"home"_s), tr("Save as home"), this)) {
    look::name(this, u"detailsBox"_s, tr("Details"));
    look::name(m_clear, u"clearStickyButton"_s, tr("Clear the sticky status bits"));
    look::name(m_saveHome, u"saveHomeButton"_s, tr("Save the present position as home"));
    addBits(Byte::First, tr("Status byte"), servo::kStatusBitNames, statusMeaning, u"bit_"_s);
    addBits(Byte::Second, tr("Auxiliary byte"), servo::kAuxBitNames, auxMeaning, u"bit_"_s);
    m_analog = addValue(tr("A/D (motor current)"), u"analogLabel"_s);
    m_velocity = addValue(tr("Velocity, as the chip says"), u"chipVelocityLabel"_s);
    m_home = addValue(tr("Home register"), u"homeLabel"_s);
    m_home->setToolTip(texts::homeRegisterMeaning());
    m_raw = addValue(tr("Raw"), u"rawLabel"_s);
    addButtons({m_clear, m_saveHome});
    connect(m_clear, &QPushButton::clicked, this,
            [this] { emit intentRequested(intent::ClearStickyBits{}); });
    connect(m_saveHome, &QPushButton::clicked, this, [this] { emit intentRequested(intent::SaveAsHome{}); });
    refresh();
}

void DetailsBox::showModule(const PanelView& view) {
    const std::optional<StatusReport>& report = view.module.latest;
    showBits(Byte::First, report ? std::optional(report->status) : std::nullopt);
    showBits(Byte::Second, report ? report->aux : std::nullopt);
    showValues(view);
    m_whyNotClear = view.whyNot(Request::ClearStickyBits);
    m_whyNotHome = view.whyNot(Request::SaveAsHome);
    refresh();
}

void DetailsBox::showValues(const PanelView& view) {
    const QString dash = u"–"_s;
    const StatusReport report = view.module.latest.value_or(StatusReport{});
    look::setText(m_analog,
                  report.analog ? texts::analogReading(view.settings.analog, *report.analog) : dash);
    look::setText(m_velocity,
                  report.velocity ? texts::grouped(*report.velocity) + u' ' + texts::unitVelocity() : dash);
    look::setText(m_home, report.home ? texts::position(view.scale(), *report.home) : dash);
    QString raw = dash;
    if (view.module.latest) {
        raw = tr("status %1").arg(report.status, 2, 16, QChar(u'0'));
        if (report.aux)
            raw += tr(", auxiliary %1").arg(*report.aux, 2, 16, QChar(u'0'));
    }
    look::setText(m_raw, raw);
}

void DetailsBox::setBusy(bool busy) {
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

void DetailsBox::refresh() {
    const auto reason = [this](const std::optional<Refusal>& refusal) {
        return refusal  ? texts::refusal(*refusal)
               : m_busy ? tr("Waiting for the module's answer.")
                        : QString();
    };
    look::setPossible(m_clear, reason(m_whyNotClear),
                      tr("Clears overcurrent, pos_error, pos_wrap and servo_overrun. Starts nothing."));
    look::setPossible(m_saveHome, reason(m_whyNotHome),
                      tr("Keeps the present position as home. The motor does not move."));
}

}  // namespace nmc
