// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QTranslator>

namespace nmc {

/// The program's own words, and Qt's in its standard dialogs; one that found nothing is empty.
struct Translations {
    QTranslator plurals;  ///< the English ones, below every other language
    QTranslator panel;
    QTranslator qt;
};

/// Loads the first language of the locale's list that there is a translation for and hands it to the
/// application object, which must exist. English is the language of the source, whose plurals are always
/// there, and ends the search. True when another language is in force.
bool installTranslations(Translations& translations, const QLocale& locale);

}  // namespace nmc
