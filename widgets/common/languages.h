// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>

/// The language of the panel. The choice is a setting that is read at start-up.
namespace nmc::languages {

/// Key of the setting. Its value is a language, for example "de"; empty: that of the system.
inline const QString kSetting = QStringLiteral("language");

/// English, in which the source is written, and the languages that this program is translated into.
[[nodiscard]] QStringList available();
/// The name of a language in the language itself: "Deutsch".
[[nodiscard]] QString nameOf(const QString& language);
/// The locale for words and numbers: that of the system if nothing or the language of the system was chosen.
[[nodiscard]] QLocale localeOf(const QString& chosen, const QLocale& system = QLocale::system());

}  // namespace nmc::languages
