// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the table of texts about states, whose messages last as long as they do.
#include <algorithm>

#include "widgets/common/doctortexts.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

/// PIC-STEP: the E-stop input is active; the motor stays on.
Message estopActive(ModuleIndex module) {
    return about(u"estopActive"_s, module,
                 {Texts::tr("The E-stop input of module %1 is active: its motor is on but cannot move.")
                      .arg(moduleNumber(module)),
                  Texts::tr("Release the input. This does not start a motion.")});
}

/// An armed limit stop has stopped the motor, or switched it off.
Message limitStopTripped(ModuleIndex module, const HomeWatch& watch) {
    return about(
        u"limitStop"_s, module,
        {(watch.switchesOff() ? Texts::tr("The limit stop of module %1 switched its motor off.")
                              : Texts::tr("The limit stop of module %1 stopped its motor."))
             .arg(moduleNumber(module)),
         Texts::tr(
             "A limit stop acts once. Move the motor off the switch, then arm or disarm the limit stop on the Homing page.")});
}

/// The servo should hold its motor, but the motor oscillates.
Message swings(const ModuleState& module) {
    const ModuleIndex index = module.info.index;
    QList<Message::Action> actions{{MessageAction::SwitchOff, Common::tr("Motor off")}};
    if (module.gainsBefore)
        actions.append({MessageAction::GainsBefore, Texts::tr("Restore previous gains")});
    return about(
        u"swings"_s, index,
        {Texts::tr("Module %1 oscillates while it holds its position.").arg(moduleNumber(index)),
         Texts::tr(
             "Its servo is not stable with these gains. Lower Kp and Ki, or raise Kd, and apply them.")},
        actions);
}

/// Tests a sticky bit, which is at the same place in the auxiliary byte of every version.
bool hasWrapped(const ModuleState& module) {
    const auto aux = module.isServo() && module.latest ? module.latest->aux : std::nullopt;
    return aux && servo::AuxByte{*aux}.positionWrap();
}

Message wrapped(const ModuleState& module) {
    const ModuleIndex index = module.info.index;
    return about(
        u"wrapped"_s, index,
        {Texts::tr("The position counter of module %1 has wrapped.").arg(moduleNumber(index)),
         Texts::tr(
             "The 32-bit counter has overflowed and continues at the other end of its range. Earlier positions and travel limits no longer match: find home, then clear the sticky bits on the Details page.")});
}

/// For a servo, the cause is known from a status bit; for a stepper, from its present state.
Message wentOff(const ModuleState& module) {
    const ModuleIndex index = module.info.index;
    if (module.isStepper())
        return amplifierWentOff(index, module.stepper.ended().value_or(Activity::WentOff));
    if (module.powerLostWhileOn)
        return powerLost(index);
    return tripped(index, module.gains ? std::optional<int>(module.gains->el) : std::nullopt,
                   module.tripCause);
}

/// True for a stepper whose motor is on but cannot move, because its E-stop input is active.
bool estopHolds(const ModuleState& module) {
    return module.isStepper() && module.stepper.amplifierOn() && module.stepper.estopActs();
}

/// One text for one cause: if the limit switched the motor off, the message about that reports it.
bool reportsLimit(const ModuleState& module, int limit) {
    const bool switchedOff =
        module.isStepper() && module.switchedItselfOff && module.stepper.ended() == Activity::StoppedByLimit;
    const bool reported = module.switchedItselfOff && (module.tripCause == TripCause::OffAtLimit1 ||
                                                       module.tripCause == TripCause::OffAtLimit2);
    return module.limits.ranInto(static_cast<std::size_t>(limit - 1)) && !switchedOff && !reported;
}

/// The message about a module that does not answer; it comes before those about its last reported state.
std::optional<Message> unheard(const LinkState& link, const ModuleState& module, TimePoint now) {
    const auto answers = [](const ModuleState& other) { return !other.silent; };
    const auto answering = std::count_if(link.modules.begin(), link.modules.end(), answers);
    const ModuleIndex index = module.info.index;
    const ModuleType type = module.info.identity.type;
    if (module.hasRestarted)
        return withRecord(restarted({index, link.phase == LinkPhase::Lost && link.quiet},
                                    static_cast<int>(link.modules.size()), type));
    if (isMissing(module))
        return moduleMissing(index, static_cast<int>(answering), type);
    // One text for one cause: if the whole link is lost, that is reported instead.
    if (module.silent && (link.phase == LinkPhase::Connected || answering > 0))
        return withRecord(
            moduleUnresponsive(index, toSeconds(now - module.latestTime), module.stillMoves(), type));
    return std::nullopt;
}

}  // namespace

Message limitClosed(const ModuleState& module, int limit) {
    const ModuleIndex index = module.info.index;
    const QString what = u"limit%1"_s.arg(limit);
    const QString number = moduleNumber(index);
    const bool stopped = module.isStepper() ? module.stepper.ended() == Activity::StoppedByLimit
                                            : module.limitEnds(limit == 1 ? 1 : -1);
    if (module.isStepper() || stopped)
        return about(
            what, index,
            {(stopped ? Texts::tr("Limit switch %1 of module %2 stopped its motor.")
                      : Texts::tr("Limit switch %1 of module %2 closed while its motor was moving."))
                 .arg(limit)
                 .arg(number),
             Texts::tr(
                 "While the switch is closed, the module blocks this direction. Move the motor the other way.")});
    return about(
        what, index,
        {Texts::tr("Limit switch %1 of module %2 closed while its motor was moving, but does not stop it.")
             .arg(limit)
             .arg(number),
         Texts::tr(
             "A PIC-SERVO stops at a limit switch only while a limit stop is armed. Stop the motor, then move it the other way. Arm a limit stop on the Homing page.")},
        {{MessageAction::StopAll, Common::tr("STOP ALL")}});
}

std::vector<Message> standing(const LinkState& link, TimePoint now,
                              const std::function<bool(ModuleIndex)>& runs) {
    std::vector<Message> all;
    for (const ModuleState& module : link.modules) {
        const ModuleIndex index = module.info.index;
        if (auto message = unheard(link, module, now))
            all.push_back(*message);
        else if (module.replaced())
            all.push_back(about(u"replaced"_s, index,
                                {notExpected(index), notExpectedAdvice(module.otherType())}, {scanAgain()}));
        if (module.hasRestarted)
            continue;  // its earlier states have ended
        if (module.switchedItselfOff)
            all.push_back(withRecord(wentOff(module)));
        if (module.currentWasLimited())
            all.push_back(withRecord(currentLimited(index)));
        if (module.swing.swing() && !module.swing.swing()->hunts && !module.silent)
            all.push_back(withRecord(swings(module)));
        if (hasWrapped(module))
            all.push_back(withRecord(wrapped(module)));
        for (const int limit : {1, 2})
            if (reportsLimit(module, limit))
                all.push_back(withRecord(limitClosed(module, limit)));
        if (estopHolds(module))
            all.push_back(withRecord(estopActive(index)));
        if (module.stoppedByLimitStop() && !(runs && runs(index)))
            all.push_back(withRecord(limitStopTripped(index, module.homing)));
    }
    for (Message& message : all)
        message.stands = true;
    return all;
}

}  // namespace nmc::texts
