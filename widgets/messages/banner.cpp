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
    return std::any_of(message.actions.begin(), message.actions.end(),
                       [](const Message::Action& action) { return action.id != MessageAction::ShowRecord; });
}
}  // namespace

Banner::Banner(QWidget* parent)
    : QFrame(parent),
      m_glyph(new GlyphLabel(this)),
      m_headline(new ElidedLabel(1, this)),
      m_body(new ElidedLabel(1, this)),
      m_actions(form::newLine(this, {})),
      m_all(new QPushButton(this)),
      m_dismiss(new QToolButton(this)) {
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
    connect(m_all, &QPushButton::clicked, this, [this] { emit allWanted(m_shown); });
    m_dismiss->setIcon(icons::tinted(u"x"_s));
    m_dismiss->setAutoRaise(true);
    m_dismiss->setToolTip(tr("Hides this message here. It stays in the message list."));
    look::name(m_dismiss, u"bannerDismiss"_s, tr("Hide this message"));
    connect(m_dismiss, &QToolButton::clicked, this, [this] { endMessage(m_shown); });

    const int unit = look::gridUnit(this);
    setLayout(form::newLine(this, {m_glyph, m_headline, {m_body, 1}, m_actions, m_all, m_dismiss}));
    layout()->setContentsMargins(unit * 2, unit / 2, unit, unit / 2);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    look::keepRoom(this);
    hide();
}

QSize Banner::sizeHint() const {
    return {0, m_all->sizeHint().height() + look::gridUnit(this)};
}

void Banner::showMessage(const Message& message) {
    endMessage(message.key);
    // What went well is not worth a banner; it is in the list.
    if (message.severity == Severity::Normal && !asksForSomething(message))
        return;
    m_active.append({message, ++m_count});
    if (!message.stands)
        forgetWhenOld(m_count);
    present();
}

void Banner::forgetWhenOld(unsigned number) {
    QTimer::singleShot(m_newsLife, this, [this, number] {
        const auto old = [number](const Shown& shown) {
            return shown.number == number && !asksForSomething(shown.message);
        };
        if (m_active.removeIf(old) > 0)
            present();
    });
}

void Banner::review(const LinkState& link) {
    for (Shown& shown : m_active)
        shown.message = withoutImpossible(shown.message, link);
    present();
}

void Banner::amendMessage(const Message& message) {
    for (Shown& shown : m_active)
        if (shown.message.key == message.key) {
            shown.message = message;
            return present();
        }
}

void Banner::endMessage(const QString& key) {
    const auto removed = m_active.removeIf([&key](const Shown& shown) { return shown.message.key == key; });
    if (removed > 0)
        present();
}

const Message* Banner::current() const {
    const Message* best = nullptr;
    for (const Shown& shown : m_active)
        if (best == nullptr || shown.message.severity >= best->severity)
            best = &shown.message;
    return best;
}

void Banner::present() {
    const Message* message = current();
    m_shown = message != nullptr ? message->key : QString();
    while (QLayoutItem* item = m_actions->takeAt(0)) {
        // It may be the button whose click is being handled.
        if (QWidget* button = item->widget()) {
            button->hide();
            button->deleteLater();
            button->setObjectName(QString());
        }
        delete item;
    }
    if (message == nullptr) {
        hide();
        setAccessibleName(tr("Important message"));
        return;
    }
    m_glyph->showSeverity(message->severity);
    m_headline->setText(message->headline);
    m_body->setText(message->body);
    const auto others = static_cast<int>(m_active.size()) - 1;
    m_all->setText(others > 0 ? tr("%1 more…").arg(others) : tr("Read all…"));
    m_all->setAccessibleName(m_all->text());
    setToolTip(message->details);
    setAccessibleDescription(message->body);
    for (const Message::Action& action : message->actions) {
        auto* button = new QPushButton(action.text, this);
        look::name(button, u"bannerAction_"_s + nmc::objectName(action.id), action.text);
        look::setPossible(button, action.reason, {});
        connect(button, &QPushButton::clicked, this,
                [this, about = *message, id = action.id] { emit actionTriggered(about, id); });
        m_actions->addWidget(button);
    }
    show();
    update();
    // Repeats and changed buttons are not announced.
    const QString words = message->severity == Severity::Normal
                              ? message->headline
                              : texts::severity(message->severity) + u": "_s + message->headline;
    if (accessibleName() != words)
        accessibility::announce(*this, words);
}

void Banner::paintEvent(QPaintEvent* /*event*/) {
    const Message* message = current();
    if (message == nullptr)
        return;
    QPainter painter(this);
    painter.fillRect(rect(), look::severityTint(message->severity, palette()));
    const int edge = qMax(3, look::gridUnit(this) / 2);
    painter.fillRect(QRect(0, 0, edge, height()), message->severity == Severity::Normal
                                                      ? look::faintLine(palette())
                                                      : look::severityFill(message->severity, palette()));
}

}  // namespace nmc
