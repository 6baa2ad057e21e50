// SPDX-License-Identifier: GPL-3.0-or-later
// The command line's part of the table of texts.
#include "protocol/baud.h"
#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

QString unknownPort(const QString& name, const QStringList& known) {
    return known.isEmpty()
               ? Texts::tr("Port \"%1\" not found. Only the simulator is available: --simulator.").arg(name)
               : Texts::tr("Port \"%1\" not found. Available ports: %2.").arg(name, known.join(u", "_s));
}

QString badBaud(const QString& text) {
    QStringList rates;
    for (const BaudRow& row : kBaudRows)
        rates << QString::number(row.nominal);
    return Texts::tr("These modules do not support the baud rate \"%1\". Use %2.")
        .arg(text, rates.join(u", "_s));
}

QString badChain(const QString& chain, const QString& reason) {
    return Texts::tr(
               "The simulator does not understand the chain \"%1\": %2 An example: --simulator=servo,servo@1")
        .arg(chain, reason);
}

QString unknownOption(const QString& option) {
    return Texts::tr("Unknown option \"%1\". Use --help for a list.").arg(option);
}

QString badServe() {
    return Texts::tr("Use --serve alone or as --serve=control.");
}

QString readOnlyWithoutPort() {
    return Texts::tr("--read-only requires --port or --simulator.");
}

QString noDisplay() {
    return Texts::tr("No display found: neither DISPLAY nor WAYLAND_DISPLAY is set.");
}

}  // namespace nmc::texts
