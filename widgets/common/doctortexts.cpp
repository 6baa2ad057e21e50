// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/doctortexts.h"

#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;
using Finding = ChainDiagnosis::Finding;
using Verdict = ChainPlace::Verdict;

namespace {
class Chain {
    Q_DECLARE_TR_FUNCTIONS(Chain)
};

/// What "at" is called; the finding has one.
QString placeOf(const ChainDiagnosis& chain) {
    return moduleName(chain.at.value_or(ModuleIndex(0)));
}
}  // namespace

QString chainFinding(const ChainDiagnosis& chain) {
    switch (chain.finding) {
        case Finding::NotConnected:
            return Chain::tr("Not connected, so nothing is known of the chain.");
        case Finding::Fine:
            return Chain::tr("All is well: %1.").arg(countOfModules(static_cast<int>(chain.found)));
        case Finding::NothingExpected:
            return Chain::tr("Nothing is known of this chain yet: it has %1.")
                .arg(countOfModules(static_cast<int>(chain.found)));
        case Finding::NobodyAnswers:
            return Chain::tr("No module answers.");
        case Finding::BreakBehind:
            return Chain::tr("%1 of %2 modules answered.").arg(chain.found).arg(chain.expected);
        case Finding::FarEndMissing:
            return Chain::tr("%1 of %2 modules answered, and the far end of the chain is not among them.")
                .arg(chain.found)
                .arg(chain.expected);
        case Finding::OtherHardware:
            return Chain::tr("%1 is another one than expected.").arg(placeOf(chain));
        case Finding::MoreThanBefore:
            return Chain::tr("There are more modules than expected: %1 instead of %2.")
                .arg(chain.found)
                .arg(chain.expected);
        case Finding::Silent:
            return Chain::tr("%1 does not answer any more. Its motor's state is unknown.")
                .arg(placeOf(chain));
        case Finding::Restarted:
            return Chain::tr("%1 restarted: its position and gains are lost.").arg(placeOf(chain));
    }
    return {};
}

QString chainAdvice(const ChainDiagnosis& chain) {
    switch (chain.finding) {
        case Finding::NotConnected:
            return Chain::tr("Choose a port and connect.");
        case Finding::Fine:
            return {};
        case Finding::NothingExpected:
            return Chain::tr(
                "Compare them with the labels on the modules, the one farthest from the PC first. If all are there, take them as expected: whatever is missing or another one is noticed from then on.");
        case Finding::NobodyAnswers:
            return Chain::tr(
                "Check, in this order: module power; every cable in the chain, one loose cable hides all modules; the ADDR_IN jumper of the module farthest from the PC.");
        case Finding::BreakBehind:
            return Chain::
                tr("Numbering starts at the far end, so look at the next module towards the PC after %1: its power first, then the plug between the two. Then scan again.")
                    .arg(placeOf(chain));
        case Finding::FarEndMissing:
            return Chain::tr(
                "What answers are the modules nearest the PC, with new numbers. Look at the cable to the module at the far end, and whether another ADDR_IN is grounded now. Their settings belong to other places until this is mended.");
        case Finding::OtherHardware:
            return Chain::tr(
                "Settings that belong to the expected one are not applied here. If it was exchanged on purpose, take what is there as expected.");
        case Finding::MoreThanBefore:
            return Chain::
                tr("From %1 on they are new. If they are meant to be there, take what is there as expected.")
                    .arg(placeOf(chain));
        case Finding::Silent:
            return Chain::tr(
                "Check its power and the cable towards it; use the hardware stop if its motor moves. It is asked again by itself, rarely.");
        case Finding::Restarted:
            return Chain::tr(
                "Modules from it towards the PC may be deaf until it has its address again. When all motors may stand still and lose their positions, restart the network.");
    }
    return {};
}

QString chainVerdict(Verdict verdict) {
    switch (verdict) {
        case Verdict::Fine:
            return Chain::tr("fine");
        case Verdict::New:
            return Chain::tr("new");
        case Verdict::Different:
            return Chain::tr("another one");
        case Verdict::Missing:
            return Chain::tr("missing");
        case Verdict::Silent:
            return Chain::tr("does not answer");
        case Verdict::Restarted:
            return Chain::tr("restarted");
    }
    return {};
}

Severity severityOf(Verdict verdict) {
    switch (verdict) {
        case Verdict::Fine:
        case Verdict::New:
            return Severity::Normal;
        case Verdict::Different:
        case Verdict::Missing:
            return Severity::Attention;
        case Verdict::Silent:
        case Verdict::Restarted:
            return Severity::Fault;
    }
    return Severity::Normal;
}

Severity severityOf(Finding finding) {
    switch (finding) {
        case Finding::NotConnected:
        case Finding::Fine:
        case Finding::NothingExpected:
        case Finding::MoreThanBefore:
            return Severity::Normal;
        case Finding::BreakBehind:
        case Finding::FarEndMissing:
        case Finding::OtherHardware:
            return Severity::Attention;
        case Finding::NobodyAnswers:
        case Finding::Silent:
        case Finding::Restarted:
            return Severity::Fault;
    }
    return Severity::Normal;
}

QString groupName(std::uint8_t group) {
    constexpr std::uint8_t kEverybody = 0xFF;
    if (group == kEverybody)
        return Chain::tr("no group");
    return Chain::tr("Group %1").arg(QString::number(group, 16).toUpper());
}

}  // namespace nmc::texts
