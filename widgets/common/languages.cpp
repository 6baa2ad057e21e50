// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/languages.h"

#include <QDir>

namespace nmc::languages {

using namespace Qt::StringLiterals;

namespace {
const QString kEnglish = u"en"_s;
const QString kPrefix = u"nmcpanel_"_s;
const QString kSuffix = u".qm"_s;
}  // namespace

QStringList available() {
    QStringList found{kEnglish};
    for (const QString& file :
         QDir(u":/i18n"_s).entryList({kPrefix + u'*' + kSuffix}, QDir::Files, QDir::Name))
        if (const QString language = file.chopped(kSuffix.size()).mid(kPrefix.size()); language != kEnglish)
            found << language;
    return found;
}

/// Capitalised as at the beginning of a sentence, and without the country.
QString nameOf(const QString& language) {
    if (language == kEnglish)
        return u"English"_s;
    const QLocale locale(language);
    const QString name = locale.language() == QLocale::Spanish ? u"español"_s : locale.nativeLanguageName();
    return name.isEmpty() ? language : locale.toUpper(name.left(1)) + name.mid(1);
}

QLocale localeOf(const QString& chosen, const QLocale& system) {
    if (chosen.isEmpty() || QLocale(chosen).language() == system.language())
        return system;
    // Not the locale of the United States, whose paper size and date format are used nowhere else.
    return chosen == kEnglish ? QLocale(QLocale::English, QLocale::World) : QLocale(chosen);
}

}  // namespace nmc::languages
