// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>

/// What the panel speaks. The choice is a setting, which is read at the start.
namespace nmc::languages {

/// Where it is kept: "de"; empty: as the system says.
inline const QString kSetting = QStringLiteral("language");

/// English, in which the source is written, and what this program has a translation for.
[[nodiscard]] QStringList available();
/// In the language itself: "Deutsch".
[[nodiscard]] QString nameOf(const QString& language);
/// For words and numbers. Where the system speaks the language that was chosen, as it is spoken there.
[[nodiscard]] QLocale localeOf(const QString& chosen, const QLocale& system = QLocale::system());

}  // namespace nmc::languages
