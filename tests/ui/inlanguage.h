// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <string>
#include <vector>

#include "app/translations.h"
#include "widgets/common/languages.h"

namespace nmc {

/// All languages of the program: each translation is tested.
inline std::vector<std::string> allLanguages() {
    std::vector<std::string> all;
    for (const QString& language : languages::available())
        all.push_back(language.toStdString());
    return all;
}

/// Sets up words and numbers as the program does at its start. It must precede the window, which is created
/// in its language.
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
