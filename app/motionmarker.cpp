// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/motionmarker.h"

namespace nmc {

namespace {

const QString kMoving = QStringLiteral("session/moving");  // module numbers, as the user knows them
constexpr int kMostModules = 32;

}  // namespace

MotionMarker::MotionMarker(QSettings& settings) : m_settings(settings) {
    for (const QString& number : settings.value(kMoving).toStringList())
        if (const int n = number.toInt(); n >= 1 && n <= kMostModules)
            m_left.emplace_back(static_cast<std::uint8_t>(n - 1));
    m_written = m_left;
}

void MotionMarker::update(const LinkState& link) {
    // Without modules nothing new is known: a port that was unplugged stopped no motor.
    if (link.simulated || link.modules.empty())
        return;
    std::vector<ModuleIndex> moving;
    for (const ModuleState& module : link.modules)
        if (module.moving())
            moving.push_back(module.info.index);
    write(moving);
}

void MotionMarker::clear() {
    write({});
}

void MotionMarker::write(const std::vector<ModuleIndex>& moving) {
    if (moving == m_written)
        return;
    m_written = moving;
    QStringList numbers;
    for (const ModuleIndex module : moving)
        numbers << QString::number(module.value() + 1);
    if (numbers.isEmpty())
        m_settings.remove(kMoving);
    else
        m_settings.setValue(kMoving, numbers);
    m_settings.sync();  // a killed program writes nothing any more
}

}  // namespace nmc
