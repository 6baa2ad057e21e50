// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/bell.h"

#include <QAction>
#include <QApplication>
#include <QSettings>

#include "widgets/common/look.h"
#include "widgets/mainwindow/settingskeys.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr qint64 kPauseMs = 1'000;
}

Bell::Bell(QSettings& settings, QObject* parent)
    : QObject(parent),
      m_action(look::newAction(
          this, u"soundsAction"_s, tr("So&unds"),
          tr("Plays a sound on each fault, and when a search for home, a test, a series of steps or a sequence ends."))) {
    m_action->setCheckable(true);
    m_action->setChecked(settings.value(settingskeys::kSounds, true).toBool());
    connect(m_action, &QAction::toggled, this,
            [&settings](bool on) { settings.setValue(settingskeys::kSounds, on); });
}

void Bell::ring() {
    if (!m_action->isChecked() || (m_since.isValid() && m_since.elapsed() < kPauseMs))
        return;
    m_since.start();
    QApplication::beep();
    emit rang();
}

}  // namespace nmc
