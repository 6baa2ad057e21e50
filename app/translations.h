// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QTranslator>

namespace nmc {

/// The program's translations, and those of Qt's standard dialogs; empty if not found.
struct Translations {
    QTranslator plurals;  ///< the English plurals, below every other language
    QTranslator panel;
    QTranslator qt;
};

/// Loads the first language of the locale's list that has a translation, and installs it in the application
/// object, which must exist. English is the language of the source, whose plurals are always installed, and
/// ends the search. Returns true if another language is in use.
bool installTranslations(Translations& translations, const QLocale& locale);

}  // namespace nmc
