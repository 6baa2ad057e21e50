// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include "app/translations.h"
#include "widgets/common/languages.h"
#include "widgets/common/texts.h"

namespace nmc {
namespace {

using namespace Qt::StringLiterals;

QStringList placeholders(const QString& text) {
    static const QRegularExpression placeholder(u"%[\\dn]"_s);
    QStringList found;
    for (auto match = placeholder.globalMatch(text); match.hasNext();)
        found << match.next().captured();
    found.sort();
    return found;
}

TEST(Translation, TheTableOfTextsIsGermanForAGermanLocale) {
    {
        Translations translations;
        ASSERT_TRUE(installTranslations(translations, QLocale(QLocale::German, QLocale::Germany)));
        EXPECT_EQ(texts::safety().headline,
                  u"Einen Hardware-Not-Halt vorsehen, der die Motorversorgung trennt."_s);
        EXPECT_EQ(texts::countOfModules(3), u"3 Module"_s);
        EXPECT_EQ(QCoreApplication::translate("Common", "STOP ALL"), u"ALLES STOPP"_s);
    }
    // Translators remove themselves from the application when they are destroyed.
    EXPECT_EQ(texts::countOfModules(3), u"3 modules"_s);
}

TEST(Translation, EnglishAndUnknownLanguagesStayEnglish) {
    Translations translations;
    EXPECT_FALSE(installTranslations(translations, QLocale::c()));
    EXPECT_FALSE(installTranslations(translations, QLocale(QLocale::English, QLocale::Canada)));
    EXPECT_FALSE(installTranslations(translations, QLocale(QLocale::Finnish, QLocale::Finland)));
    EXPECT_EQ(texts::countOfModules(3), u"3 modules"_s);
}

TEST(Translation, NumbersAgreeWithTheirNoun) {
    Translations translations;
    installTranslations(translations, QLocale::c());
    EXPECT_EQ(texts::countOfModules(1), u"1 module"_s);
    EXPECT_EQ(texts::countOfModules(2), u"2 modules"_s);
    Translations german;
    ASSERT_TRUE(installTranslations(german, QLocale(QLocale::German)));
    EXPECT_EQ(texts::countOfModules(1), u"1 Modul"_s);
    EXPECT_EQ(texts::countOfModules(2), u"2 Module"_s);
}

class TranslationFile : public testing::TestWithParam<std::string> {};

TEST_P(TranslationFile, IsFinished) {
    QFile file(QDir(QStringLiteral(TS_DIR)).filePath(QString::fromStdString(GetParam())));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString source;
    bool counts = false;
    int messages = 0;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == u"message"_s)
            counts = xml.attributes().hasAttribute(u"numerus"_s);
        if (xml.name() == u"source"_s)
            source = xml.readElementText();
        if (xml.name() == u"translation"_s) {
            EXPECT_FALSE(xml.attributes().hasAttribute(u"type"_s)) << source.toStdString();
        }
        // A text with a number has a singular and a plural form.
        if (xml.name() != (counts ? u"numerusform"_s : u"translation"_s))
            continue;
        const QString translation = xml.readElementText();
        EXPECT_FALSE(translation.isEmpty()) << source.toStdString();
        EXPECT_EQ(placeholders(translation), placeholders(source)) << source.toStdString();
        EXPECT_EQ(translation.contains(u'&'), source.contains(u'&')) << source.toStdString();
        ++messages;
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    EXPECT_GT(messages, 0);
}

/// All translation files of the project.
std::vector<std::string> translationFiles() {
    std::vector<std::string> files;
    for (const QString& file : QDir(QStringLiteral(TS_DIR)).entryList({u"nmcpanel_*.ts"_s}))
        files.push_back(file.toStdString());
    return files;
}
INSTANTIATE_TEST_SUITE_P(Languages, TranslationFile, testing::ValuesIn(translationFiles()),
                         [](const auto& file) { return file.param.substr(9, file.param.size() - 12); });

TEST(Translation, EachFileIsALanguageThatIsOffered) {
    EXPECT_EQ(static_cast<std::size_t>(languages::available().size()), translationFiles().size());
    for (const QString& language : languages::available())
        EXPECT_EQ(QLocale(language).name().section(u'_', 0, 0), language);
}

}  // namespace
}  // namespace nmc
