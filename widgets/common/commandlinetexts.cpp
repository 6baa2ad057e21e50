// SPDX-License-Identifier: GPL-3.0-or-later
// The command line's part of the table of texts.
#include "protocol/baud.h"
#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

QString unknownPort(const QString& name, const QStringList& known) {
    return known.isEmpty()
               ? Texts::tr("There is no port \"%1\". Only the simulator is here: --simulator.").arg(name)
               : Texts::tr("There is no port \"%1\". These are here: %2.").arg(name, known.join(u", "_s));
}

QString badBaud(const QString& text) {
    QStringList rates;
    for (const BaudRow& row : kBaudRows)
        rates << QString::number(row.nominal);
    return Texts::tr("\"%1\" is not a rate of these modules. They take %2.").arg(text, rates.join(u", "_s));
}

QString badChain(const QString& chain, const QString& reason) {
    return Texts::tr(
               "The simulator does not understand the chain \"%1\": %2 An example: --simulator=servo,servo@1")
        .arg(chain, reason);
}

QString unknownOption(const QString& option) {
    return Texts::tr("There is no option \"%1\". --help lists them.").arg(option);
}

QString readOnlyWithoutPort() {
    return Texts::tr("--read-only needs something to look at: --port or --simulator.");
}

QString noDisplay() {
    return Texts::tr("There is no display to open a window on: neither DISPLAY nor WAYLAND_DISPLAY is set.");
}

}  // namespace nmc::texts
