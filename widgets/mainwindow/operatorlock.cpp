// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/operatorlock.h"

#include <QAction>
#include <QCryptographicHash>
#include <QRandomGenerator>
#include <QSettings>
#include <QStringList>
#include <iterator>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/mainwindow/operatordialog.h"
#include "widgets/mainwindow/settingskeys.h"

namespace nmc {

using namespace Qt::StringLiterals;
using namespace settingskeys;

namespace {

QByteArray hashOf(const QByteArray& salt, const QString& pin) {
    return QCryptographicHash::hash(salt + pin.toUtf8(), QCryptographicHash::Sha256).toHex();
}

const struct {
    QString word;
    bool OperatorRights::*right;
} kRights[] = {{u"enable"_s, &OperatorRights::enable}, {u"jog"_s, &OperatorRights::jog},
               {u"points"_s, &OperatorRights::points}, {u"moves"_s, &OperatorRights::moves},
               {u"homing"_s, &OperatorRights::homing}, {u"outputs"_s, &OperatorRights::outputs}};
static_assert(std::size(kRights) == sizeof(OperatorRights), "each right is stored");

void store(QSettings& settings, const OperatorRights& rights) {
    QStringList words;
    for (const auto& [word, right] : kRights)
        if (rights.*right)
            words << word;
    settings.setValue(kOperatorRights, words);
}

OperatorRights rightsIn(const QSettings& settings) {
    OperatorRights rights;
    if (!settings.contains(kOperatorRights))
        return rights;
    const QStringList words = settings.value(kOperatorRights).toStringList();
    for (const auto& [word, right] : kRights)
        rights.*right = words.contains(word);
    return rights;
}

QByteArray newSalt() {
    QByteArray salt(16, Qt::Uninitialized);
    QRandomGenerator::system()->generate(salt.begin(), salt.end());
    return salt.toHex();
}

}  // namespace

OperatorLock::OperatorLock(QSettings& settings, QWidget* window)
    : QObject(window),
      m_settings(settings),
      m_window(window),
      m_action(new QAction(window)),
      m_locked(settings.value(kOperatorMode, false).toBool() && settings.contains(kOperatorPin)) {
    if (m_locked)
        m_rights = rightsIn(settings);
    m_action->setObjectName(u"operatorAction"_s);
    connect(m_action, &QAction::triggered, this, &OperatorLock::open);
    present();
}

std::optional<OperatorRights> OperatorLock::rights() const {
    if (!m_locked)
        return std::nullopt;
    return m_rights;
}

void OperatorLock::showRights(const std::optional<OperatorRights>& ofMachine) {
    const OperatorRights rights = ofMachine.value_or(m_locked ? rightsIn(m_settings) : OperatorRights{});
    if (m_rights == rights)
        return;
    m_rights = rights;
    emit changed();
}

void OperatorLock::open() {
    if (!m_dialog) {
        m_dialog =
            m_locked
                ? new OperatorDialog(
                      [this](const QString& pin) { return isPin(pin); },
                      tr("If you forgot it, close the panel and remove the \"operator\" section from %1.")
                          .arg(m_settings.fileName()),
                      m_window)
                : new OperatorDialog(m_rights, m_window);
        connect(m_dialog, &OperatorDialog::locked, this, &OperatorLock::begin);
        connect(m_dialog, &OperatorDialog::unlocked, this, &OperatorLock::leave);
        connect(m_dialog, &QDialog::finished, this, [this] { m_dialog.clear(); });
    }
    look::showInFront(m_dialog);
}

void OperatorLock::begin(const OperatorRights& rights, const QString& pin) {
    const QByteArray salt = newSalt();
    m_settings.setValue(kOperatorSalt, salt);
    m_settings.setValue(kOperatorPin, hashOf(salt, pin));
    m_settings.setValue(kOperatorMode, true);
    store(m_settings, rights);
    m_locked = true;
    m_rights = rights;
    emit rightsEdited(rights);  // before editing is locked
    present();
    emit changed();
}

void OperatorLock::leave() {
    m_settings.setValue(kOperatorMode, false);
    m_locked = false;
    present();
    emit changed();
}

bool OperatorLock::isPin(const QString& pin) const {
    return hashOf(m_settings.value(kOperatorSalt).toByteArray(), pin) ==
           m_settings.value(kOperatorPin).toByteArray();
}

void OperatorLock::present() {
    m_action->setText(m_locked ? tr("Leave o&perator mode…") : tr("O&perator mode…"));
    m_action->setToolTip(
        m_locked ? Common::tr("Asks for the PIN.")
                 : tr("Limits the panel to the actions that you select, until someone enters the PIN."));
}

}  // namespace nmc
