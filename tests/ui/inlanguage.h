// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <string>
#include <vector>

#include "app/translations.h"
#include "widgets/common/languages.h"

namespace nmc {

/// All that the program speaks: what has a translation is tested by that.
inline std::vector<std::string> allLanguages() {
    std::vector<std::string> all;
    for (const QString& language : languages::available())
        all.push_back(language.toStdString());
    return all;
}

/// Words and numbers, as the program sets them up at its start. Before the window, which is made in its
/// language.
struct InLanguage {
    explicit InLanguage(const std::string& language) {
        const QLocale locale = languages::localeOf(QString::fromStdString(language), QLocale::c());
        QLocale::setDefault(locale);
        installTranslations(translations, locale);
    }
    ~InLanguage() { QLocale::setDefault(QLocale::c()); }
    InLanguage(const InLanguage&) = delete;
    InLanguage& operator=(const InLanguage&) = delete;

    Translations translations;
};

}  // namespace nmc
