// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

#include "link/ports/linktypes.h"
#include "model/module/linkstate.h"

class QSettings;

namespace nmc {

/// What a report of a problem is made of.
struct ProblemFacts {
    const QSettings& settings;
    const LinkState& link;
    LinkFigures figures;
    QList<PortEntry> ports;  ///< as they are listed
    QString packets;         ///< the last ones, a line each; empty: none were recorded
    QString messages;        ///< of this session, a line each
};

/// One text for the developers: in English, whatever the panel speaks, but for the messages, which are as
/// they were shown. Neither PIN nor the names of home folders are in it.
[[nodiscard]] QString problemReport(const ProblemFacts& facts);

/// Home folders, of the user and of others, as "~".
[[nodiscard]] QString withoutHomes(QString text);

}  // namespace nmc
