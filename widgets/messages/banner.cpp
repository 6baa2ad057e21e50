// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/banner.h"

#include <QPainter>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

#include "widgets/common/accessibility.h"
#include "widgets/common/elidedlabel.h"
#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
bool asksForSomething(const Message& message) {
    return std::ranges::any_of(message.actions, [](const Message::Action& action) {
        return action.id != MessageAction::ShowRecord;
    });
}
}  // namespace

Banner::Banner(const MessageModel& model, QWidget* parent)
    : QFrame(parent),
      m_model(model),
      m_glyph(new GlyphLabel(this)),
      m_headline(new ElidedLabel(1, this)),
      m_body(new ElidedLabel(1, this)),
      m_actions(form::newLine(this, {})),
      m_all(new QPushButton(this)) {
    auto* dismiss = new QToolButton(this);
    look::name(this, u"banner"_s, tr("Important message"));
    m_headline->setObjectName(u"bannerHeadline"_s);
    m_body->setObjectName(u"bannerBody"_s);
    QFont bold = font();
    bold.setBold(true);
    m_headline->setFont(bold);
    m_glyph->setFont(look::scaled(font(), 1.4));
    m_all->setFlat(true);
    m_all->setText(tr("Read all…"));  // determines the height in this language from the start
    m_all->setToolTip(tr("Shows the full text and all other messages in the message list."));
    look::name(m_all, u"bannerAll"_s, m_all->text());
    connect(m_all, &QPushButton::clicked, this, [this] { emit allWanted(m_shown->key); });
    dismiss->setIcon(icons::tinted(u"x"_s));
    dismiss->setAutoRaise(true);
    dismiss->setToolTip(tr("Hides this message here. It stays in the message list."));
    look::name(dismiss, u"bannerDismiss"_s, tr("Hide this message"));
    connect(dismiss, &QToolButton::clicked, this, &Banner::hideShown);
    connect(&m_model, &MessageModel::reported, this, &Banner::showReported);
    connect(&m_model, &MessageModel::amended, this, &Banner::present);
    connect(&m_model, &MessageModel::ended, this, &Banner::present);
    connect(&m_model, &MessageModel::reviewed, this, &Banner::present);

    const int unit = look::gridUnit(this);
    setLayout(form::newLine(this, {m_glyph, m_headline, {m_body, 1}, m_actions, m_all, dismiss}));
    layout()->setContentsMargins(unit * 2, unit / 2, unit, unit / 2);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    look::keepRoom(this);
    hide();
}

QSize Banner::sizeHint() const {
    return {0, m_all->sizeHint().height() + look::gridUnit(this)};
}

void Banner::setNotice(const std::optional<Message>& notice) {
    m_notice = notice;
    present();
}

void Banner::showReported(const MessageEntry& entry) {
    m_hidden.erase(entry.number);
    if (!entry.message.stands)
        QTimer::singleShot(m_newsLife, this, [this, number = entry.number, time = entry.time] {
            const auto& entries = m_model.entries();
            const auto old = std::ranges::find(entries, number, &MessageEntry::number);
            if (old == entries.end() || old->time != time || asksForSomething(old->message))
                return;
            m_hidden.insert(number);
            present();
        });
    present();
}

void Banner::hideShown() {
    const QString key = m_shown->key;
    if (m_notice && m_notice->key == key)
        m_notice.reset();
    for (const MessageEntry& entry : m_model.entries())
        if (entry.message.key == key)
            m_hidden.insert(entry.number);
    present();
}

std::vector<const Message*> Banner::candidates() const {
    std::vector<const Message*> all;
    if (m_notice)
        all.push_back(&*m_notice);
    for (const MessageEntry& entry : m_model.entries()) {
        // What went well is not worth a banner; it is in the list.
        const bool worthIt = entry.message.severity != Severity::Normal || asksForSomething(entry.message);
        if (worthIt && !entry.ended() && !m_hidden.contains(entry.number))
            all.push_back(&entry.message);
    }
    return all;
}

void Banner::present() {
    const std::vector<const Message*> all = candidates();
    const auto best = std::ranges::max_element(all, {}, [](const Message* one) { return one->severity; });
    const auto shown = best == all.end() ? std::nullopt : std::optional(**best);
    const int others = qMax(0, static_cast<int>(all.size()) - 1);
    // A button that is being pressed must not be replaced by its like.
    if (shown == m_shown && others == m_others)
        return;
    m_shown = shown;
    m_others = others;
    form::clear(*m_actions);
    if (!shown) {
        hide();
        setAccessibleName(tr("Important message"));
        return;
    }
    m_glyph->showSeverity(shown->severity);
    m_headline->setText(shown->headline);
    m_body->setText(shown->body);
    m_all->setText(others > 0 ? tr("%1 more…").arg(others) : tr("Read all…"));
    m_all->setAccessibleName(m_all->text());
    setToolTip(shown->details);
    setAccessibleDescription(shown->body);
    for (const Message::Action& action : shown->actions) {
        auto* button = new QPushButton(action.text, this);
        look::name(button, u"bannerAction_"_s + nmc::objectName(action.id), action.text);
        look::setPossible(button, action.reason, {});
        connect(button, &QPushButton::clicked, this,
                [this, about = *shown, id = action.id] { emit actionTriggered(about, id); });
        m_actions->addWidget(button);
    }
    show();
    update();
    // Repeats and changed buttons are not announced.
    const QString words = shown->severity == Severity::Normal
                              ? shown->headline
                              : texts::severity(shown->severity) + u": "_s + shown->headline;
    if (accessibleName() != words)
        accessibility::announce(*this, words);
}

void Banner::paintEvent(QPaintEvent* /*event*/) {
    if (!m_shown)
        return;
    QPainter painter(this);
    painter.fillRect(rect(), look::severityTint(m_shown->severity, palette()));
    const int edge = qMax(3, look::gridUnit(this) / 2);
    painter.fillRect(QRect(0, 0, edge, height()), m_shown->severity == Severity::Normal
                                                      ? look::faintLine(palette())
                                                      : look::severityFill(m_shown->severity, palette()));
}

}  // namespace nmc
