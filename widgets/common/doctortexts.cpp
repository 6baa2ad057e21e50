// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/doctortexts.h"

#include <algorithm>

#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;
using Finding = ChainDiagnosis::Finding;
using State = ChainPlace::State;

namespace {
/// The name of the module `at`, which the finding must have.
QString concernedModule(const ChainDiagnosis& chain) {
    return moduleName(chain.at.value_or(ModuleIndex(0)));
}

/// Its type, as found.
ModuleType concernedType(const ChainDiagnosis& chain) {
    const auto place =
        std::ranges::find(chain.places, chain.at.value_or(ModuleIndex(0)), &ChainPlace::module);
    return place != chain.places.end() && place->found ? place->found->type : ModuleType::Servo;
}
}  // namespace

QString chainFinding(const ChainDiagnosis& chain) {
    switch (chain.finding) {
        case Finding::NotConnected:
            return Texts::tr("Not connected: the state of the chain is unknown.");
        case Finding::Looking:
            return Texts::tr("Looking for modules…");
        case Finding::Fine:
            return Texts::tr("Chain OK: %1.").arg(countOfModules(static_cast<int>(chain.found)));
        case Finding::NothingExpected:
            return Texts::tr("This chain is new: it has %1.")
                .arg(countOfModules(static_cast<int>(chain.found)));
        case Finding::NobodyAnswers:
            return Texts::tr("No module answered.");
        case Finding::BreakBehind:
            return Common::tr("%1 of %2 modules answered.").arg(chain.found).arg(chain.expected);
        case Finding::FarEndMissing:
            return Texts::tr("%1 of %2 modules answered; the far end of the chain is missing.")
                .arg(chain.found)
                .arg(chain.expected);
        case Finding::OtherHardware:
            return notExpected(chain.at.value_or(ModuleIndex(0)));
        case Finding::MoreThanBefore:
            return Texts::tr("More modules than expected: %1 instead of %2.")
                .arg(chain.found)
                .arg(chain.expected);
        case Finding::Unresponsive:
            return (concernedType(chain) == ModuleType::Io
                        ? Texts::tr("%1 does not answer.")
                        : Texts::tr("%1 stopped answering. Motor state unknown."))
                .arg(concernedModule(chain));
        case Finding::Restarted:
            return lostByRestart(chain.at.value_or(ModuleIndex(0)), concernedType(chain));
    }
    return {};
}

QString chainAdvice(const ChainDiagnosis& chain) {
    switch (chain.finding) {
        case Finding::NotConnected:
            return Texts::tr("Choose a port and connect.");
        case Finding::Looking:
        case Finding::Fine:
            return {};
        case Finding::NothingExpected:
            return Texts::tr(
                "Compare the list with the labels on the modules, starting with the module farthest from the PC. If it is right, accept the chain as found: from then on, missing and replaced modules are reported.");
        case Finding::NobodyAnswers:
            return Texts::tr(
                "Check, in this order: module power; every cable in the chain (one loose cable hides all modules); the ADDR_IN jumper of the module farthest from the PC.");
        case Finding::BreakBehind:
            return Texts::
                tr("Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two. Then scan again.")
                    .arg(concernedModule(chain));
        case Finding::FarEndMissing:
            return Texts::tr(
                "Only the modules nearest the PC answered, and their numbers have changed. Check the cable to the module at the far end, and check that no other ADDR_IN is grounded. Until this is fixed, settings do not match the modules.");
        case Finding::OtherHardware:
            return notExpectedAdvice(std::ranges::any_of(chain.places, &ChainPlace::otherType));
        case Finding::MoreThanBefore:
            return Texts::tr("Modules from %1 on are new. If they belong there, accept the chain as found.")
                .arg(concernedModule(chain));
        case Finding::Unresponsive:
            return Texts::tr(
                "Check its power and cable; use the hardware stop if its motor moves. The panel retries from time to time.");
        case Finding::Restarted:
            return Texts::tr(
                "Modules between it and the PC may not answer until it has its address again. Restart the network when it is safe to stop all motors and lose their positions.");
    }
    return {};
}

QString notExpected(ModuleIndex module) {
    return Texts::tr("%1 is not the expected module.").arg(moduleName(module));
}

QString notExpectedAdvice(bool otherType) {
    return otherType
               ? Texts::tr(
                     "The settings of this place are for another type of module, so they are not used, and only stop commands work. Check the cables, then scan again. If you replaced the module on purpose, accept the chain as found (Chain doctor): all but its name is then to be set again, and its positions leave the points.")
               : Texts::tr(
                     "Name, unit, limits, speeds and points of the expected module are used for it; gains and parameters from a machine file are not sent to it. If you replaced the module on purpose, check these settings, then accept the chain as found.");
}

QString chainVerdict(State state) {
    switch (state) {
        case State::Fine:
            return Texts::tr("OK");
        case State::New:
            return Texts::tr("new");
        case State::Different:
            return Texts::tr("different module");
        case State::Missing:
            return Texts::tr("missing");
        case State::Unresponsive:
            return Texts::tr("does not answer");
        case State::NotAsked:
            return Texts::tr("not asked");
        case State::Restarted:
            return Texts::tr("restarted");
    }
    return {};
}

Severity severityOf(State state) {
    switch (state) {
        case State::Fine:
        case State::New:
            return Severity::Normal;
        case State::Different:
        case State::Missing:
        case State::NotAsked:
            return Severity::Attention;
        case State::Unresponsive:
        case State::Restarted:
            return Severity::Fault;
    }
    return Severity::Normal;
}

Severity severityOf(Finding finding) {
    switch (finding) {
        case Finding::NotConnected:
        case Finding::Looking:
        case Finding::Fine:
        case Finding::NothingExpected:
        case Finding::MoreThanBefore:
            return Severity::Normal;
        case Finding::BreakBehind:
        case Finding::FarEndMissing:
        case Finding::OtherHardware:
            return Severity::Attention;
        case Finding::NobodyAnswers:
        case Finding::Unresponsive:
        case Finding::Restarted:
            return Severity::Fault;
    }
    return Severity::Normal;
}

QString groupName(std::uint8_t group) {
    constexpr std::uint8_t kEverybody = 0xFF;
    if (group == kEverybody)
        return Texts::tr("no group");
    return Common::tr("Group %1").arg(QString::number(group, 16).toUpper());
}

}  // namespace nmc::texts
