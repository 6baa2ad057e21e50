// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/translations.h"

#include <QCoreApplication>
#include <QLibraryInfo>

namespace nmc {

using namespace Qt::StringLiterals;

bool installTranslations(Translations& translations, const QLocale& locale) {
    if (translations.plurals.load(u":/i18n/nmcpanel_en.qm"_s))
        QCoreApplication::installTranslator(&translations.plurals);
    // QTranslator's own search is not used: it has no file for English, so "English, then German" would yield
    // German.
    const QStringList names = locale.uiLanguages();
    for (const QString& name : names) {
        const QLocale language(name);
        if (language.language() == QLocale::English || language.language() == QLocale::C)
            return false;
        if (!translations.panel.load(language, u"nmcpanel"_s, u"_"_s, u":/i18n"_s))
            continue;
        QCoreApplication::installTranslator(&translations.panel);
        if (translations.qt.load(language, u"qtbase"_s, u"_"_s,
                                 QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
            QCoreApplication::installTranslator(&translations.qt);
        return true;
    }
    return false;
}

}  // namespace nmc
