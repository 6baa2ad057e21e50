// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

#include "link/ports/linktypes.h"
#include "model/module/linkstate.h"

class QSettings;

namespace nmc {

/// What a problem report is made from.
struct ProblemFacts {
    const QSettings& settings;
    const LinkState& link;
    LinkFigures figures;
    QList<PortEntry> ports;  ///< as the panel lists them
    QString packets;         ///< the last packets, one per line; empty: none were recorded
    QString messages;        ///< the messages of this session, one per line
};

/// One text for the developers. It is in English, whatever the language of the panel, except for the
/// messages, which are as they were shown. It contains neither the PIN nor the names of home folders.
[[nodiscard]] QString problemReport(const ProblemFacts& facts);

/// Replaces home folders, the user's own and others, by "~".
[[nodiscard]] QString withoutHomes(QString text);

}  // namespace nmc
