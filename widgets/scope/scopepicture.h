// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>
#include <QStringList>

namespace nmc {

class ScopeStrips;

/// What the strips show, below lines that say what it is: in the colours and at the size of the screen.
[[nodiscard]] QImage scopeImage(ScopeStrips& strips, const QStringList& caption);
/// The same on a page, for a printer or a file.
[[nodiscard]] QByteArray scopePdf(ScopeStrips& strips, const QStringList& caption);
/// The same in vectors.
[[nodiscard]] QByteArray scopeSvg(ScopeStrips& strips, const QStringList& caption);

}  // namespace nmc
